"""When a stage was last asked for, and whether it sleeps: its time stands until somebody looks or asks."""

from __future__ import annotations

from statwalk.services.hosting.live_stage import LiveStage
from statwalk.services.hosting.store.records import StageIdentity


class Attention:
    """Puts one stage to sleep and wakes it. Threads may call it without the stage's lock."""

    def __init__(self, identity: StageIdentity, live: LiveStage) -> None:
        self._may_sleep, self._live = identity.may_sleep, live
        self._touched = live.services.now()

    def idle_for(self, now: float) -> float:
        """Returns the seconds without a request or a viewer until `now`, in seconds of `services.now`."""
        return 0.0 if self._live.fanout.outboxes else now - self._touched

    def come_back(self) -> None:
        """Lets a stage sleep that comes back when the server starts, until somebody looks or asks: otherwise
        all kept stages would step at once.
        """
        if self._may_sleep:
            self._touched = float("-inf")

    def touch(self) -> None:
        """Counts a request, and wakes the stage."""
        self._touched = self._live.services.now()
        if self._live.asleep:
            self._live.asleep = False
            self._live.services.wake()

    def sleeps(self, now: float) -> bool:
        """Puts the stage to sleep if it is time; returns whether it sleeps. The ticker's thread calls it."""
        asleep = self._may_sleep and self.idle_for(now) > self._live.services.limits.rest_seconds
        if asleep:
            self._live.clock.stand()
        self._live.asleep = asleep
        return asleep
