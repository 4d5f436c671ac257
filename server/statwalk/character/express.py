"""Runs expressions on poses, outside a stage (EX1).

found = statwalk.express(gearbox, ["gear_b.rotate_z = -1.25 * gear_a.rotate_z"], pose)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numba import types

from statwalk.character.character import Character
from statwalk.character.expressions import channels_of, values_by_name
from statwalk.character.length_lines import with_lengths
from statwalk.errors import ContentError
from statwalk.machine.definition.expression_lines import read_lines
from statwalk.maths.arrays import Floats
from statwalk.maths.columns import columns
from statwalk.maths.compiling import FLOAT, kernel, read, write
from statwalk.maths.formula.assignments import AssignmentError
from statwalk.maths.packed import ADDRESSES, opened, packed
from statwalk.maths.pose import Pose
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.simd.pose_layout import place_of
from statwalk.skin.face_muscles import contracted, contractions_of
from statwalk.solve.express import express as express_one
from statwalk.solve.expression_tables import ExpressionProgram, ExpressionTables, expression_program

_EXPRESSIONS = columns(ExpressionTables, readonly=True)
_open = opened(_EXPRESSIONS)
MOST_FRAME = 2**53
RATES = (1.0, 1000.0)


@dataclass(frozen=True, eq=False)
class Expressed:
    """A pose, or poses (N, …), after expressions ran on them, and what the lines set.

    variables, channels   by name, numbers or (N,): free variables, and channels in degrees, metres, scales
    """

    pose: Pose
    variables: Mapping[str, Any]
    channels: Mapping[str, Any]


def express(
    character: Character,
    expressions: str | Sequence[str] = (),
    pose: Pose | None = None,
    *,
    frameid: int = 0,
    rate: float = 60.0,
    parameters: Mapping[str, float] | None = None,
) -> Expressed:
    """Returns the pose (J, …), or the poses (N, J, …), after the expressions ran, in the order of their
    dependencies, as a tick runs them.

    `expressions`: lines, or one text; none: the character's own. `pose`: the pose at rest unless given.
    `frameid` is the number of the tick, `time` is frameid / rate, in seconds; `parameters`: numbers by name.

    :raises ContentError: when a line is no expression, a name is unknown or set twice, names form a circle,
        or a number is out of its range; `place` is the line.
    """
    given = dict(parameters or {})
    _check(frameid, rate, given)
    written = _read(expressions, tuple(given)) if expressions else character.expressions
    lines = with_lengths(character, written, _refuse)
    channels = channels_of(character, lines, _refuse, tuple(given))
    program = expression_program([lines], [], channels, tuple(given))
    muscles = contractions_of(character.muscles, character.targets)
    poses = character.bind_pose if pose is None else pose
    lead = poses.rotation.shape[:-2]
    if poses.rotation.shape[-2:] != character.bind_pose.rotation.shape or len(lead) > 1:
        joints = len(character.skeleton)
        raise ContentError(f"a pose of {poses.rotation.shape} for {joints} joints", place="pose")
    buffer = _buffer(character, poses if lead else Pose(*(part[None] for part in poses)))
    values = _run_on(buffer, program, list(given.values()), (float(frameid), frameid / rate))
    named = values_by_name(program, list(values.T) if lead else values[0].tolist())
    expressed = buffer.poses()
    expressed = expressed._replace(weights=contracted(expressed.weights, muscles))
    return Expressed(expressed if lead else expressed.take(0), *named)


def _buffer(character: Character, poses: Pose) -> PoseBuffer:
    return PoseBuffer.of(character.bind_pose, Pose(*(np.asarray(part, np.float32) for part in poses)))


def _run_on(
    buffer: PoseBuffer, program: ExpressionProgram, parameters: Sequence[float], clock: tuple[float, float]
) -> Floats:
    """Runs a program on poses, and returns the values (N, F) of its slots."""
    slots = np.array(list(program.slots.values()), np.int32)
    numbers = np.tile(np.array(parameters, np.float64), (buffer.count, 1))
    work, values = np.zeros(program.values + program.deepest), np.zeros((buffer.count, len(slots)))
    tables = packed(program.tables, _EXPRESSIONS)
    _run(tables.argument, numbers, np.array(clock), slots, work, program.values, buffer.values, values)
    return values


def _check(frameid: int, rate: float, parameters: Mapping[str, float]) -> None:
    if not 0 <= frameid <= MOST_FRAME:
        raise ContentError(f"frameid is 0…{MOST_FRAME}, not {frameid}", place="frameid")
    if not RATES[0] <= rate <= RATES[1]:
        raise ContentError(f"a rate is {RATES[0]:g}…{RATES[1]:g} ticks a second, not {rate:g}", place="rate")
    for name, value in parameters.items():
        if not np.isfinite(value):
            raise ContentError(f"{name[:40]} is no finite number", place="parameters")


def _read(expressions: str | Sequence[str], parameters: tuple[str, ...]) -> Any:
    lines = expressions.split("\n") if isinstance(expressions, str) else expressions
    try:
        return read_lines(list(enumerate(lines, 1)), parameters)
    except AssignmentError as error:
        raise _refuse(error.message, error.line) from None


def _refuse(message: str, line: int) -> ContentError:
    return ContentError(message, place=f"line {line}")


@kernel(
    ADDRESSES, read(types.float64, 2), read(types.float64, 1), read(types.int32, 1), write(types.float64, 1),
    types.int64, write(FLOAT, 3), write(types.float64, 2),
)  # fmt: skip
def _run(
    tables: Any, parameters: Any, clock: Any, slots: Any, work: Any, count: int, pose: Any, out: Any
) -> None:
    """Runs group 0 on the rows of `pose`; `work`: `count` values, then the stack."""
    x, values, stack = _open(tables), work[:count], work[count:]
    for row in range(out.shape[0]):
        block, lane = place_of(row)
        express_one(x, 0, parameters, row, clock[0], clock[1], values, stack, pose, block, lane)
        for number in range(slots.shape[0]):
            out[row, number] = values[slots[number]]
