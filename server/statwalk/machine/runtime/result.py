"""The result of a tick: copies of its effects, which the next tick overwrites."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.runtime.effects import MachineEffects
from statwalk.machine.runtime.state import MachineState


class VerdictCodes(NamedTuple):
    """Verdicts as codes, with the columns of `MachineEffects.verdicts`."""

    rows: NDArray[np.int64]
    """(n, 12)"""
    variable: NDArray[np.int16]
    """(m,) variable of each value that conditions have read"""
    value: NDArray[np.float64]
    """(m,)"""


class Changes(NamedTuple):
    """The motions that start in a tick, (C,) each, in order; an actor may appear several times."""

    actor: NDArray[np.int64]
    layer: NDArray[np.int64]
    event: NDArray[np.int64]
    from_state: NDArray[np.int64]
    to_state: NDArray[np.int64]
    action: NDArray[np.int64]
    """row of the machine's actions, -1 none"""
    restart: NDArray[np.bool_]
    """whether the same state began its motion again"""
    curve: NDArray[np.int64]
    """row of CURVES"""
    blend: NDArray[np.float32]
    """seconds"""
    time: NDArray[np.float64]
    """seconds into the new motion"""


class StepResult(NamedTuple):
    """The state after a tick, and the effects of the tick."""

    state: MachineState
    changes: Changes
    verdicts: VerdictCodes
    actions: NDArray[np.int64]
    """(n, 4) see `MachineEffects.actions`"""


NO_CHANGES = Changes._make(
    (
        *np.zeros((6, 0), np.int64),
        np.zeros(0, bool),
        np.zeros(0, np.int64),
        np.zeros(0, np.float32),
        np.zeros(0),
    )
)
NO_VERDICTS = VerdictCodes(np.zeros((0, 12), np.int64), np.zeros(0, np.int16), np.zeros(0))
NO_ACTIONS = np.zeros((0, 4), np.int64)


def result_of(state: MachineState, effects: MachineEffects) -> StepResult:
    """Returns the state with a copy of the effects."""
    verdicts, values, changes, actions = effects.counts.tolist()
    if not verdicts + changes + actions:
        return StepResult(state, NO_CHANGES, NO_VERDICTS, NO_ACTIONS)
    verdict_codes = VerdictCodes(
        effects.verdicts[:verdicts].copy(), effects.variable[:values].copy(), effects.value[:values].copy()
    )
    columns = effects.changes[:changes].copy().T
    started = Changes._make(
        (
            *columns[:6],
            columns[6] != 0,
            columns[7],
            effects.blend[:changes].copy(),
            effects.start[:changes].copy(),
        )
    )
    return StepResult(state, started, verdict_codes, effects.actions[:actions].copy())
