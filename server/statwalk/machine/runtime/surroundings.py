"""The surroundings of machines in a tick: inputs, and how their actors move."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import types
from numpy.typing import ArrayLike, NDArray

from statwalk.machine.conditions.variables import COUNT_MEASURED
from statwalk.maths.compiling import write

PRESS, HOLD, RELEASE, TOUCH, RAISED, TRAVEL = range(6)
"""kinds of inputs: a tap, a key that goes down, a key that comes up, a touch, an event that another actor
raised, a state to travel to
"""


class Inputs(NamedTuple):
    """The inputs of a tick, (M,) each, sorted by actor: touches, then events that other actors raised, then
    commands of the log, in order.
    """

    actor: NDArray[np.int64]
    """row of the batch"""
    event: NDArray[np.int64]
    """column; for TRAVEL the state of the base layer to travel to, -1 to cancel travelling"""
    kind: NDArray[np.int64]
    """PRESS, HOLD, RELEASE, TOUCH, RAISED or TRAVEL"""
    other: NDArray[np.int64]
    """id of the actor that was touched, or raised the event; -1 none"""

    @classmethod
    def of(cls, actor: ArrayLike, event: ArrayLike, kind: ArrayLike = PRESS, other: ArrayLike = -1) -> Inputs:
        """Returns inputs sorted by actor; the inputs of one actor keep their order."""
        rows = np.asarray(actor, np.int64)
        order = rows.argsort(kind="stable")
        parts = (
            np.broadcast_to(np.asarray(part, np.int64), rows.shape)[order] for part in (event, kind, other)
        )
        return cls(rows[order], *parts)


NOTHING = Inputs.of([], [])


class Measurements(NamedTuple):
    """Measurements of N actors that conditions and motions read."""

    measured: NDArray[np.float64]
    """(3, N) the rows of `conditions.variables.MEASURED`, as shown at the tick before"""
    key: NDArray[np.uint64]
    """(N,) the random key of each actor"""

    @classmethod
    def none(cls, actors: int) -> Measurements:
        """Returns the measurements of actors that stand still."""
        return cls(np.zeros((COUNT_MEASURED, actors)), np.zeros(actors, np.uint64))


def _type(kind: Any, axes: list[tuple[Any, int]]) -> Any:
    return types.BaseTuple.from_types(tuple(write(scalar, count) for scalar, count in axes), kind)


INPUTS = _type(Inputs, [(types.int64, 1)] * 4)
SURROUNDINGS = _type(Measurements, [(types.float64, 2), (types.uint64, 1)])
