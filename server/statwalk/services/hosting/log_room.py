"""The room for inputs in the log of a stage: the oldest inputs are forgotten when it is full."""

from __future__ import annotations

from statwalk.errors import LimitError
from statwalk.services.limits import Limits
from statwalk.stage.stage import Stage


class LogRoom:
    """Counts the inputs to one stage."""

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._tick = self._since_tick = 0

    def make(self, stage: Stage) -> bool:
        """Has the stage forget its oldest inputs if its log is full; returns whether it forgot any."""
        return stage.held >= self._limits.entries and stage.forget(self._limits.entries // 2)

    def check(self, stage: Stage) -> None:
        """Refuses inputs for which there is no room.

        :raises LimitError: when too many inputs wait for the next tick, or too many came since the newest
            tick that the stage can go on from.
        """
        if stage.tick != self._tick:
            self._tick, self._since_tick = stage.tick, 0
        if self._since_tick >= self._limits.tick_entries:
            raise LimitError(
                f"{self._since_tick:,} inputs wait for the next tick, and no more; let it step first",
                limit="tick_entries",
            )
        if stage.held >= self._limits.entries:
            raise LimitError(
                f"the log of this stage holds {stage.held:,} inputs, and no more; let it step for a second, "
                "so that it can forget the oldest",
                limit="entries",
            )

    def take(self, inputs: int) -> None:
        """Counts inputs that the log has taken."""
        self._since_tick += inputs
