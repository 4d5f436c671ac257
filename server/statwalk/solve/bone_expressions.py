"""Expressions among the rules: the left side is an unknown of a bone, the right side holds known values
(FAQ Q26).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from statwalk.errors import ContentError, UnknownNameError
from statwalk.maths.arrays import Floats
from statwalk.maths.formula.assignments import Assignment
from statwalk.solve.bone_values import CHANNELS, BoneSet, BoneValue, BoneValues


def _read(state: BoneValues, variables: Mapping[str, BoneValue], name: str) -> Floats | None:
    """The value of a name of an expression; None: not known."""
    place = channel_of(state.bones, name)
    if place is not None:
        return state.component(*place)
    return variables[name].value if name in variables else None


def _value(state: BoneValues, variables: Mapping[str, BoneValue], assignment: Assignment) -> Floats | None:
    formula = assignment.formula
    values = [_read(state, variables, name) for name in formula.scope]
    known = [value for value in values if value is not None]
    if len(known) < len(values):
        return None
    frames = np.broadcast_arrays(np.zeros(()), *known)[1:]
    shape = frames[0].shape if frames else ()
    table = np.array([np.ravel(value) for value in frames]).reshape(len(frames), int(np.prod(shape)))
    if not frames:
        table = np.zeros((0, 1))
    return formula.evaluate(table).reshape(shape)


def assign(state: BoneValues, variables: dict[str, BoneValue], assignment: Assignment) -> bool:
    """Runs an expression if its left side is unknown and its right side known; returns whether it ran."""
    if _read(state, variables, assignment.target) is not None:
        return False
    value = _value(state, variables, assignment)
    if value is None:
        return False
    source = f"expression, line {assignment.line}"
    place = channel_of(state.bones, assignment.target)
    if place is None:
        variables[assignment.target] = BoneValue(value, source)
    else:
        state.put_component(*place, value, source)
    return True


def check_expressions(
    state: BoneValues,
    variables: Mapping[str, BoneValue],
    expressions: Sequence[Assignment],
    tolerance: float,
) -> None:
    """Compares the two sides of every expression whose values are all known.

    :raises ContentError: when they differ by more than `tolerance`, relative above 1.
    """
    for assignment in expressions:
        left = _read(state, variables, assignment.target)
        right = _value(state, variables, assignment)
        if left is None or right is None:
            continue
        apart = np.max(np.abs(left - right), initial=0.0)
        if apart > tolerance * max(1.0, float(np.max(np.abs(right), initial=0.0))):
            raise ContentError(
                f"contradiction: {assignment.text} gives {float(np.ravel(right)[0]):.6g}, but "
                f"{assignment.target} is {float(np.ravel(left)[0]):.6g}",
                place=f"line {assignment.line}",
            )


def channel_of(bones: BoneSet, name: str) -> tuple[int, str] | None:
    """Returns bone and channel of a name like `hand.rotate_z`; None: the name is a free variable.

    :raises UnknownNameError: when the name has parts, but no bone or no channel has the name.
    """
    bone, dot, channel = name.rpartition(".")
    if not dot:
        return None
    if bone not in bones.names:
        raise UnknownNameError("bone", bone, bones.names)
    if channel not in CHANNELS:
        raise UnknownNameError("channel", channel, CHANNELS)
    return bones.names.index(bone), channel
