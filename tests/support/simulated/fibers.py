"""Threads of which exactly one runs, until it waits: the simulation says which goes on, and when."""

from collections.abc import Callable

from greenlet import GreenletExit, getcurrent, greenlet


class Fiber:
    """A thread that runs only while `resume` waits for it."""

    def __init__(self, run: Callable[[], None]) -> None:
        hub = getcurrent()
        while hub.parent is not None:
            hub = hub.parent
        self._hub, self._own, self._is_killed = hub, greenlet(run, hub), False

    def resume(self) -> None:
        """Lets it run until it suspends itself or ends."""
        self._own.switch()

    def suspend(self) -> None:
        """Gives the word back; called in the fiber itself. :raises GreenletExit: when it is killed."""
        if self._is_killed:
            raise GreenletExit
        self._hub.switch()

    def kill(self) -> None:
        """Ends it where it waits, if it has begun."""
        self._is_killed = True
        self._own.throw(GreenletExit)
