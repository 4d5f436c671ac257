"""The thread that gives stages their ticks: it goes on when one fails, wakes for a new one, and ends."""

import threading

import pytest
from statwalk.web.pacer import Pacer


class Counting:
    """Due every millisecond; rings after 50 turns."""

    def __init__(self) -> None:
        self.turns = 0
        self.enough = threading.Event()

    def advance_to(self, now: float) -> float:
        self.turns += 1
        self.last = now
        if self.turns >= 50:
            self.enough.set()
        return 0.001


class Failing:
    def advance_to(self, now: float) -> float:
        raise RuntimeError(f"a defect at {now}")


def test_a_stage_that_fails_does_not_stop_the_others(caplog: pytest.LogCaptureFixture) -> None:
    good = Counting()
    pacer = Pacer(lambda: [Failing(), good])
    pacer.start()
    assert good.enough.wait(20)
    pacer.stop()
    assert "a stage failed in its step" in caplog.text


def test_it_wakes_for_a_new_stage_and_ends() -> None:
    stages: list[Counting] = []
    pacer = Pacer(lambda: stages)
    pacer.start()
    stages.append(Counting())
    pacer.wake()
    assert stages[0].enough.wait(20)
    pacer.stop()
    assert not pacer.thread.is_alive()
