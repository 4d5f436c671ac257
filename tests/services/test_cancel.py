"""Work ends when nobody waits for it, when the server stops, and when its time is over."""

import threading

import pytest
from statwalk.errors import CancelledError, OverdueError
from statwalk.services.cancel import CancelToken


def test_work_ends_with_its_client_and_with_the_server() -> None:
    ending = threading.Event()
    first, second = CancelToken(ending), CancelToken(ending)
    first.cancel()
    second.check()
    with pytest.raises(CancelledError):
        first.check()
    ending.set()
    with pytest.raises(CancelledError):
        second.check()


def test_work_has_so_many_seconds() -> None:
    token = CancelToken()
    token.expire_after(60.0)
    token.check()
    token.expire_after(-1.0)
    with pytest.raises(OverdueError, match="fewer ticks"):
        token.check()
