"""The effects of a tick, in arrays that the caller keeps: verdicts on events, motions that start, actions;
and the workspace of the tick.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numba import types
from numpy.typing import NDArray

from statwalk.machine.compile.program import Program
from statwalk.machine.conditions.condition_values import CONDITION_VALUES, ConditionValues, condition_values
from statwalk.machine.runtime.scratch import SIZE_OF_CLOCK, SIZE_OF_SCRATCH
from statwalk.machine.runtime.state import MOST_WAITING
from statwalk.maths.compiling import write

MOST_CHANGES = 8
MOST_DRAWS = 32
"""draws of an actor and layer in a tick that the caller may set"""
OF_VERDICTS, OF_VALUES, OF_CHANGES, OF_ACTIONS = range(4)
"""places in `Effects.counts`"""
ACTOR, LAYER, EVENT, VERDICT, REASON, FROM, TO, ALTERNATIVE, OTHER, NOTE, ARRIVED, PAST_VALUES = range(12)
"""columns of `Effects.verdicts`; of `Effects.actions` ACTOR, LAYER, ACTION and BY"""
ACTION, BY = 2, 3
CHANGE_EVENT, CHANGE_FROM, CHANGE_TO, CHANGE_ACTION, CHANGE_RESTART, CHANGE_CURVE = range(2, 8)
"""columns of `Effects.changes`, after ACTOR and LAYER"""


class Workspace(NamedTuple):
    """The workspace of one actor's tick."""

    scratch: NDArray[np.int64]
    """(24,) integers, see `runtime.scratch`"""
    clock: NDArray[np.float64]
    """(4,) seconds, see `runtime.scratch`"""
    conditions: ConditionValues
    draws: NDArray[np.float64]
    """(L, 32) 0 ≤ … < 1; NaN: unknown"""
    due: NDArray[np.uint8]
    """(16,) whether the event in a place of the queue is still to be looked up in this tick"""
    held: NDArray[np.int32]
    """(E,) held inputs after the tick before"""
    sensed: NDArray[np.uint8]
    """(K,) whether a sense raises its event in this tick"""
    pace: NDArray[np.float64]
    """(L,) the factor that a blend of clips adds to the speed of each layer's motion in this tick"""
    weights: NDArray[np.float64]
    """(…,) memory for the weights of a blend's clips"""


class MachineEffects(NamedTuple):
    """The effects of a tick on N actors with L layers, in the order in which they came about.

    States, events and actions are rows of the machine; times are seconds.
    """

    counts: NDArray[np.int64]
    """(4,) number of verdicts, values, changes and actions"""
    verdicts: NDArray[np.int64]
    """(…, 12) ACTOR, LAYER, EVENT, VERDICT, REASON, FROM, TO (-1: the state stayed), ALTERNATIVE (-1 none),
    OTHER (id of the actor that was touched or raised the event, -1 none), NOTE (the sense that raised the
    event, -1 none), ARRIVED (whether the actor reached its travel goal), PAST_VALUES (end of the verdict's
    values)
    """
    variable: NDArray[np.int16]
    """(…,) variable of each value that the conditions of a verdict have read"""
    value: NDArray[np.float64]
    """(…,) value of each listed variable"""
    changes: NDArray[np.int64]
    """(…, 8) motions that start: ACTOR, LAYER, then CHANGE_EVENT …; an actor may appear several times"""
    blend: NDArray[np.float32]
    """(…,) seconds that the blend of each change takes"""
    start: NDArray[np.float64]
    """(…,) seconds into the new motion at which each change enters it"""
    carried: NDArray[np.float64]
    """(…,) seconds that were left after END, and went into the new motion"""
    actions: NDArray[np.int64]
    """(…, 4) ACTOR, LAYER, ACTION, BY (as OTHER of a verdict)"""
    before: NDArray[np.float64]
    """(N, L) seconds into the old motion at the end of the tick before"""
    reached: NDArray[np.float64]
    """(N, L) seconds into the old motion at the end of this tick, before any change"""
    wraps: NDArray[np.int64]
    """(N, L) how often the old motion wrapped in this tick"""
    work: Workspace


def effects_for(program: Program, actors: int, room: int = 1024) -> MachineEffects:
    """Returns empty effects for a number of actors, with room for `room` verdicts; `step` makes more room if
    needed.
    """
    layers, rows = len(program.initials), room
    values = rows * max(1, len(program.variable_kind))
    return MachineEffects(
        np.zeros(4, np.int64),
        np.zeros((rows, 12), np.int64),
        np.zeros(values, np.int16),
        np.zeros(values),
        np.zeros((rows, 8), np.int64),
        np.zeros(rows, np.float32),
        np.zeros(rows),
        np.zeros(rows),
        np.zeros((rows, 4), np.int64),
        np.zeros((actors, layers)),
        np.zeros((actors, layers)),
        np.zeros((actors, layers), np.int64),
        workspace_for(program),
    )


def workspace_for(program: Program) -> Workspace:
    """Returns an empty workspace for a program."""
    layers, events = len(program.initials), program.target.shape[1]
    return Workspace(
        np.zeros(SIZE_OF_SCRATCH, np.int64),
        np.zeros(SIZE_OF_CLOCK),
        condition_values(layers, len(program.code) - 1, len(program.variable_kind), len(program.opcode)),
        np.full((layers, MOST_DRAWS), np.nan),
        np.zeros(MOST_WAITING, np.uint8),
        np.zeros(events, np.int32),
        np.zeros(len(program.sense_event), np.uint8),
        np.ones(layers),
        np.zeros(program.blends.most_members),
    )


def doubled(effects: MachineEffects) -> MachineEffects:
    """Returns a copy of the effects with twice the room."""
    grown = (np.concatenate([array, np.zeros_like(array)]) for array in effects[1:9])
    return MachineEffects._make((effects.counts, *grown, *effects[9:]))


WORKSPACE = types.BaseTuple.from_types(
    (
        *(write(types.int64, 1), write(types.float64, 1), CONDITION_VALUES, write(types.float64, 2)),
        *(write(types.uint8, 1), write(types.int32, 1), write(types.uint8, 1)),
        *(write(types.float64, 1), write(types.float64, 1)),
    ),
    Workspace,
)
EFFECTS = types.BaseTuple.from_types(
    (
        *(
            write(types.int64, 1),
            write(types.int64, 2),
            write(types.int16, 1),
            write(types.float64, 1),
            write(types.int64, 2),
        ),
        *(write(types.float32, 1), write(types.float64, 1), write(types.float64, 1), write(types.int64, 2)),
        *(write(types.float64, 2), write(types.float64, 2), write(types.int64, 2), WORKSPACE),
    ),
    MachineEffects,
)
"""the types of Workspace and MachineEffects in kernels"""
