"""The budget of work that the properties of a machine share, and the checkpoint that cancels the work."""

from __future__ import annotations

from collections.abc import Callable

Checkpoint = Callable[[], None]
"""called between pieces of long work; raises to cancel the work"""
MOST_WORK = 4_000_000
"""ticks for all properties of a machine together: one or two seconds"""
RUN_STEP_WORK = 16
"""the cost of one tick of a counterexample, in ticks of a search"""
TOO_MANY = "undecided: there are too many moments to look at; the motions are long, or the table is large"
SPENT = "undecided: the properties before it took all the work that a machine is allowed"


class TooManyError(Exception):
    """A search ended without a result; `str` is the answer to the property."""


def go_on() -> None:
    """Cancels nothing: the default checkpoint."""


class Work:
    """The work that is left for the properties of one machine; the same on every computer."""

    def __init__(self, most: int = MOST_WORK, checkpoint: Checkpoint = go_on) -> None:
        self.left, self.checkpoint = most, checkpoint

    def begin(self) -> None:
        """Begins the next property.

        :raises TooManyError: when no work is left for it.
        """
        self.checkpoint()
        if self.left <= 0:
            raise TooManyError(SPENT)

    def spend(self, ticks: int) -> None:
        """Takes `ticks` from the work that is left."""
        self.left -= ticks
