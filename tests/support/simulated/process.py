"""The process of the server: its clock, its threads, and how it is stopped, frozen and killed."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from typing import Any

from simulated.fibers import Fiber
from simulated.world import World

FIRST_NOW = 1_000.0


class Process:
    """From one start of the server to its end; follows `Threads`. What is due happens only while it lives."""

    def __init__(self, world: World) -> None:
        self.world, self.is_alive = world, True
        self.current: Fiber | None = None
        self._fibers: list[Fiber] = []
        self._frozen_until = self._asleep = 0.0

    # --- time

    def now(self) -> float:
        """The monotonic clock: it does not count the time in which the computer was asleep."""
        return FIRST_NOW + self.world.time - self._asleep

    def freeze(self, seconds: float, *, is_counted: bool) -> None:
        """Stops the whole process: `is_counted` by SIGSTOP, else the computer sleeps. Once at a time."""
        if self.world.time < self._frozen_until:
            return
        self._frozen_until = self.world.time + seconds
        if not is_counted:
            self.world.after(seconds, self._sleep, seconds)

    def _sleep(self, seconds: float) -> None:
        self._asleep += seconds

    def after(self, seconds: float, act: Callable[..., object], *arguments: Any) -> None:
        self.world.after(seconds, self._do, act, arguments)

    def _do(self, act: Callable[..., object], arguments: tuple[Any, ...]) -> None:
        if self.world.time < self._frozen_until:
            self.world.after(self._frozen_until - self.world.time, self._do, act, arguments)
        elif self.is_alive:
            act(*arguments)

    def kill(self) -> None:
        """Ends all threads where they wait."""
        self.is_alive = False
        for fiber in list(self._fibers):
            fiber.kill()

    # --- threads

    def start(self, run: Callable[[], None], name: str) -> "Started":
        started = Started(self)

        def whole() -> None:
            try:
                run()
            except Exception as error:  # as the server would log it
                self.world.fault(f"the thread {name} failed: {error!r}")
            finally:
                self._fibers.remove(fiber)
                started.has_ended = True
                started.ended.notify_all()

        fiber = Fiber(whole)
        self._fibers.append(fiber)
        self.after(0.0, self.resume, fiber)
        return started

    def resume(self, fiber: Fiber) -> None:
        before, self.current = self.current, fiber
        fiber.resume()
        self.current = before

    def condition(self) -> Any:
        return Condition(self)

    def sleep(self, seconds: float) -> None:
        """Has the thread that calls it wait."""
        Condition(self).wait_for(lambda: False, seconds)


class Started:
    def __init__(self, process: Process) -> None:
        self.has_ended, self.ended = False, Condition(process)

    def join(self) -> None:
        self.ended.wait_for(lambda: self.has_ended)


class Condition(AbstractContextManager[None]):
    """As `threading.Condition`; only one thread runs, so that it locks nothing."""

    def __init__(self, process: Process) -> None:
        self._process = process
        self._waiting: list[tuple[Fiber, Callable[[], object]]] = []

    def __enter__(self) -> None:
        return None

    def __exit__(self, *_: object) -> None:
        return None

    def wait_for(self, is_done: Callable[[], Any], seconds: float | None = None) -> Any:
        if done := is_done():
            return done
        fiber = self._process.current
        assert fiber is not None, "only a thread can wait"
        waiting = fiber, is_done
        self._waiting.append(waiting)
        if seconds is not None:
            self._process.after(seconds, self._wake, waiting, True)
        try:
            fiber.suspend()
        finally:
            if waiting in self._waiting:
                self._waiting.remove(waiting)
        return is_done()

    def notify_all(self) -> None:
        for waiting in self._waiting:
            self._process.after(0.0, self._wake, waiting, False)

    def _wake(self, waiting: tuple[Fiber, Callable[[], object]], is_over: bool) -> None:
        if any(each is waiting for each in self._waiting) and (is_over or waiting[1]()):
            self._waiting.remove(waiting)
            self._process.resume(waiting[0])
