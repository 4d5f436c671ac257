"""One thread at a time; long work lets others in between its slices."""

import threading

import pytest
from statwalk.errors import CancelledError
from statwalk.services.hosting.stage_lock import StageLock


def test_the_lock_is_free_between_two_slices() -> None:
    lock, free = StageLock(), threading.Event()

    def check() -> None:
        if not lock.lock.locked():
            free.set()

    lock.in_slices(iter(range(3)), check)
    assert free.is_set()


def test_what_is_done_stays_when_the_work_is_cancelled() -> None:
    lock, done = StageLock(), []

    def work():
        for number in range(3):
            done.append(number)
            yield number

    def check() -> None:
        if done:
            raise CancelledError("enough")

    slow = iter(work())
    next(slow)
    with pytest.raises(CancelledError):
        lock.in_slices(slow, check)
    assert (done, lock.lock.locked()) == ([0], False)
