"""The thread that gives stages their ticks: it goes on when one fails, wakes for a new one, and ends."""

import threading
import time
from typing import Any

import pytest
from serving import PATIENCE
from statwalk.services.hosting import ticker as ticker_module
from statwalk.services.hosting.ticker import SHORTEST_SLEEP, Ticker


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
    ticker = Ticker(lambda: [Failing(), good])
    ticker.start()
    assert good.enough.wait(PATIENCE)
    ticker.stop()
    assert "a stage failed in its step" in caplog.text


class Slow:
    """Its step takes longer than the time until the next one."""

    def advance_to(self, now: float) -> float:
        while time.perf_counter() <= now + 0.02:
            pass
        return 0.02


class Once(threading.Event):
    """Ends the ticker when it would wait, and keeps for how long."""

    def __init__(self, ticker: Ticker) -> None:
        super().__init__()
        self.ticker = ticker

    def wait(self, timeout: float | None = None) -> bool:
        self.timeout, self.ticker.stopping = timeout, True
        return True


def test_the_time_that_a_step_takes_is_part_of_the_wait() -> None:
    ticker = Ticker(lambda: [Slow()])
    waiting = ticker.woken = Once(ticker)
    ticker.run()
    assert waiting.timeout == SHORTEST_SLEEP


def test_it_wakes_for_a_new_stage_and_ends() -> None:
    stages: list[Counting] = []
    ticker = Ticker(lambda: stages)
    ticker.start()
    stages.append(Counting())
    ticker.wake()
    assert stages[0].enough.wait(PATIENCE)
    ticker.stop()
    assert not ticker.thread.is_alive()


def test_a_stage_that_fails_is_a_fault_until_it_is_closed() -> None:
    failing, good = Failing(), Counting()
    stages: list[Any] = [failing, good]
    ticker = Ticker(lambda: stages)
    assert "does not run" in ticker.fault()
    ticker.start()
    assert good.enough.wait(PATIENCE)
    assert ticker.fault() == "1 of the stages fail in their steps; the log says why"
    stages.remove(failing)
    good.turns, good.enough = 0, threading.Event()
    ticker.wake()
    assert good.enough.wait(PATIENCE)
    assert ticker.fault() == ""
    ticker.stop()


class Stuck:
    """Its step ends when it is told to."""

    def __init__(self) -> None:
        self.began, self.told = threading.Event(), threading.Event()

    def advance_to(self, _: float) -> float:
        self.began.set()
        self.told.wait(PATIENCE)
        return 1.0


def test_a_round_without_an_end_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ticker_module, "LONGEST_ROUND", 0.0)
    stuck = Stuck()
    ticker = Ticker(lambda: [stuck])
    ticker.start()
    assert stuck.began.wait(PATIENCE)
    assert "has stood still" in ticker.fault()
    stuck.told.set()
    ticker.stop()
