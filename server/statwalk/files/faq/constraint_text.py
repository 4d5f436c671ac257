"""The FAQ's table of constraints (Q13) as text: a joint a line, in degrees and units of length. SK6.

    #name          rotation min max        translation min max
    ------------------------------------------------------------------
    Left.upperleg  0 -45 0   0 45 0        0 0 0      0 0 0

Three smallest angles about X, Y and Z (FAQ order), three largest, then the same for the translation along X,
Y and Z; both relative to the rest pose. The heading, lines of dashes, empty lines and comments are skipped.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

from statwalk.errors import TextError
from statwalk.files.faq.skeleton_text import lines_of, number_text, numbers
from statwalk.maths.clamp_kinds import EULER
from statwalk.maths.clamp_table import JointLimit, Range
from statwalk.rig.joint_types import axis_limits

_HEADING = ("#name", "name")
_WORDS = 13


class Constraint(NamedTuple):
    """A row of the table."""

    limit: JointLimit
    line: int


def read_constraints(text: str, scale: float = 1.0) -> dict[str, Constraint]:
    """Reads a table of constraints, by the name of the joint; `scale`: metres for each unit of length.

    :raises TextError: when a row is not a name and twelve numbers, a minimum is more than its maximum, or a
        name occurs twice; `place` is the line.
    """
    rows: dict[str, Constraint] = {}
    for place, words in lines_of(text):
        if words[0].lower() in _HEADING or set(words[0]) == {"-"}:
            continue
        name, line = words[0], int(place.removeprefix("line "))
        if name in rows:
            first = f"first in line {rows[name].line} of the table"
            raise TextError(f"{name} is limited twice, {first}", place=place)
        rows[name] = Constraint(_limit(name, words, scale, place), line)
    return rows


def write_constraints(limits: Mapping[str, JointLimit], scale: float = 1.0) -> str:
    """Returns the table of limits for each axis, by joint; `read_constraints` reads the same values from it,
    but for rounding.

    :raises ValueError: when a joint has limits of another kind, or no limits of its translation.
    """
    lines = ["#name               rotation min max        translation min max", "-" * 66]
    for name, limit in limits.items():
        if limit.kind != EULER or limit.slide is None:
            raise ValueError(f"{name} has limits that the FAQ's table cannot express")
        turns = [
            [number_text(round(math.degrees(ends[side]), 9)) for ends in limit.angles] for side in (0, 1)
        ]
        ways = [[number_text(ends[side] / scale) for ends in limit.slide] for side in (0, 1)]
        lines.append(f"{name:<19} " + "   ".join(" ".join(part) for part in turns + ways))
    return "\n".join(lines) + "\n"


def _limit(name: str, words: list[str], scale: float, place: str) -> JointLimit:
    if len(words) != _WORDS:
        message = (
            f"a constraint is a name and twelve numbers (rotation min, rotation max, translation min, "
            f"translation max), not {len(words)} words: {' '.join(words)[:80]!r}"
        )
        raise TextError(message, place=place)
    values = numbers(words[1:], f"the limits of {name}", place)
    turns = [math.radians(value) for value in values[:6]]
    ways = [value * scale for value in values[6:]]
    try:
        return axis_limits(_ranges(turns), _ranges(ways))
    except ValueError:
        axis = next(axis for axis in (0, 1, 2, 6, 7, 8) if values[axis] > values[axis + 3])
        kind = "rotation" if axis < 6 else "translation"
        raise TextError(
            f"the minimum {kind} of {name} along {'XYZ'[axis % 3]} is more than its maximum: "
            f"{values[axis]:g} > {values[axis + 3]:g}",
            place=place,
        ) from None


def _ranges(ends: list[float]) -> tuple[Range, Range, Range]:
    first, second, third = ((ends[axis], ends[axis + 3]) for axis in range(3))
    return first, second, third
