"""What comes to the actors of a batch in a tick: senses that raise their events, and inputs, each actor's in their order."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Bools, Ints

Actors = NDArray[np.integer[Any]]
"""rows of the batch"""


class Given:
    """M inputs for N actors."""

    def __init__(self, actors: int, inputs: tuple[Ints, Ints, Ints, Ints | None], sensed: Bools) -> None:
        """`inputs`: actor, event, kind and other, (M,) each; `sensed` (N, K)."""
        actor, event, kind, other = inputs
        self.sensed = sensed
        order = actor.argsort(kind="stable")
        parts = (event, kind, np.full(len(event), -1) if other is None else other)
        self.rows = np.array([part[order] for part in parts], np.int64).T
        """(M, 3) event, kind and other, by actors"""
        self.count = np.bincount(actor, minlength=actors)
        """(N,) inputs of each actor"""
        self.first = self.count.cumsum() - self.count
        self.most = int(self.count.max(initial=0))

    def inputs_of(self, actor: int) -> list[tuple[int, int, int]]:
        """Event, kind and other of each input of an actor."""
        first = int(self.first[actor])
        return [(event, kind, other) for event, kind, other in self.rows[first : first + int(self.count[actor])].tolist()]

    def sensed_by(self, actor: int) -> list[int]:
        """Rows of the senses that raise their events."""
        return self.sensed[actor].nonzero()[0].tolist() if self.sensed.shape[1] else []

    def columns(self, actors: Actors) -> list[NDArray[Any]]:
        """Columns (T,) of all of it: the same in all of them for those to whom the same comes."""
        count = self.count[actors]
        found: list[NDArray[Any]] = [*self.sensed[actors].T, count]
        for number in range(self.most):
            some = number < count
            row = np.where(some, self.first[actors] + number, 0)
            found += [np.where(some, part[row], 0) for part in self.rows.T]
        return found
