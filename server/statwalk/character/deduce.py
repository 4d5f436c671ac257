"""Inverse kinematics by the FAQ's twelve rules: from some known values of bones to all that follow
(IK1 to IK12; FAQ Q26).

    bones = shipped_skeleton("mammal")
    found = deduce(bones, {"Root": {"SP": [0, 0, 0]}, "Left.hand": {"EP": [9, 3, 2]}})
    found["Left.hand"]["SP"].value, found["Left.hand"]["SP"].source, found.unknown
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from numbers import Real
from types import MappingProxyType
from typing import Any

import numpy as np

from statwalk.character.bone_sets import Source, bone_set_of
from statwalk.errors import ContentError
from statwalk.maths.arrays import Floats
from statwalk.maths.formula.assignments import AssignmentError, read_assignments
from statwalk.solve.bone_expressions import channel_of
from statwalk.solve.bone_values import SHAPES, BoneSet, BoneValue, BoneValues
from statwalk.solve.given_values import Known, given_values
from statwalk.solve.propagate import TOLERANCE, propagate


@dataclass(frozen=True, eq=False)
class Deduction:
    """What the rules found: for each bone its quantities with their sources, and what stayed unknown."""

    bones: BoneSet
    values: Mapping[str, Mapping[str, BoneValue]]
    """by bone and quantity"""
    unknown: tuple[tuple[str, str], ...]
    """bone and quantity"""
    variables: Mapping[str, BoneValue]
    """the free variables that expressions set"""

    def __repr__(self) -> str:
        found = sum(len(values) for values in self.values.values())
        return f"Deduction({len(self.values)} bones, {found} values, {len(self.unknown)} unknown)"

    def __getitem__(self, bone: str) -> Mapping[str, BoneValue]:
        return self.values[bone]


def deduce(
    bones: Source,
    known: Known,
    expressions: str | Sequence[str] | Sequence[tuple[int, str]] = (),
    tolerance: float = TOLERANCE,
) -> Deduction:
    """Returns everything that follows from `known` by the twelve rules and the expressions.

    `bones`: the bones of a skeleton table, a character, whose joints are bones, or your own:
    {name: {"parent": name, "length": number, "direction": (3,)}}, each of the three may be missing.

    Known quantities by bone: RA (3,) radians, RM (3, 3), SP EP TR (3,), DIR (3,), LEN (), each after any
    leading axes of frames; the data `path` (2, 3), two points of a motion path, and `bend` (3,), the
    direction in which the joint at the bone's start bends. LEN, DIR and TR come from the bones where they are
    not given; None makes them unknown. Points are in the space and the unit of the bones.

    `expressions`: a text or a list of lines such as `hand.rotate_z = -0.5 * forearm.rotate_z`, or lines with
    their numbers.
    `tolerance`: how far apart two values of one quantity may be, as a part of the longest bone.

    :raises UnknownNameError: when a bone, quantity or channel does not exist.
    :raises ContentError: when a value is impossible, values contradict each other, or an expression is wrong.
    """
    if not (isinstance(tolerance, Real) and 0 <= tolerance <= 1):
        raise ContentError(f"{tolerance!r:.40} is no number from 0 to 1", place="tolerance")
    bone_set = bone_set_of(bones)
    state = given_values(bone_set, known)
    numbered = _numbered(expressions)

    def check(name: str, names_set: frozenset[str]) -> str:
        place = channel_of(bone_set, name)
        return "" if place or name in names_set else f"no line sets {name}, and it is no channel of a bone"

    try:
        assignments = read_assignments(numbered, check)
    except AssignmentError as error:
        raise ContentError(error.message, place=f"line {error.line}") from None
    for assignment in assignments:
        channel_of(bone_set, assignment.target)
    variables = propagate(state, assignments, tolerance)
    return _answer(state, variables)


def _numbered(lines: Any) -> list[tuple[int, str]]:
    if isinstance(lines, str):
        lines = lines.split("\n")
    if not isinstance(lines, Sequence) or not all(isinstance(line, str | tuple) for line in lines):
        raise ContentError(f"a text or a list of lines is needed, not {lines!r:.40}", place="expressions")
    return [line if isinstance(line, tuple) else (k, line) for k, line in enumerate(lines, 1)]


def _answer(state: BoneValues, variables: Mapping[str, BoneValue]) -> Deduction:
    names = state.bones.names
    values = {
        name: MappingProxyType(
            {
                quantity: state.values[bone, quantity]
                for quantity in SHAPES
                if (bone, quantity) in state.values
            }
        )
        for bone, name in enumerate(names)
    }
    unknown = tuple((name, quantity) for name in names for quantity in SHAPES if quantity not in values[name])
    return Deduction(state.bones, MappingProxyType(values), unknown, MappingProxyType(dict(variables)))


def sketch(found: Deduction) -> Floats:
    """Returns the start and end (J, 2, 3) of every bone for a drawing: the known points, and for unknown
    points a bone that goes on from its parent as at rest. The first frame, if there are frames.
    """
    points = np.zeros((len(found.bones.names), 2, 3))
    turns = np.tile(np.eye(3), (len(points), 1, 1))
    for bone, name in enumerate(found.bones.names):
        known = {quantity: _first_frame(entry.value, quantity) for quantity, entry in found[name].items()}
        parent = int(found.bones.parent[bone])
        turns[bone] = known.get("RM", turns[parent] if parent >= 0 else np.eye(3))
        way = turns[bone] @ known.get("DIR", np.zeros(3)) * known.get("LEN", 0.0)
        start = known.get("SP", points[parent, 1] if parent >= 0 else known.get("EP", way) - way)
        points[bone] = start, known.get("EP", start + way)
    return points


def _first_frame(value: Floats, quantity: str) -> Floats:
    first: Floats = value.reshape(-1, *SHAPES[quantity])[0]
    return first
