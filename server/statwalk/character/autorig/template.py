"""Template skeletons: named joints, each at a share of a line in the body."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.character.autorig.added_joints import PlacedJoint
from statwalk.errors import ContentError
from statwalk.maths.arrays import Bools, Floats
from statwalk.skin.binding.body_graph import BodyGraph, at_share

Lines = Mapping[str, Floats]
"""named lines (K,3) from joint to joint in the body"""
SIDES = {"Left": 1.0, "Right": -1.0}
"""the sign of x"""
LOW = 0.08
"""share of the height in which feet stand"""


class JointRow(NamedTuple):
    """A joint of a template: its parent's name, its line, its share of the line; `is_last`: its bone goes on
    to the line's end.
    """

    name: str
    parent: str
    line: str
    share: float
    is_last: bool = False


def both_sides(rows: Sequence[JointRow]) -> tuple[JointRow, ...]:
    """Returns rows with `{side}` in their names for both sides."""
    return tuple(
        row._replace(
            name=row.name.format(side=side),
            parent=row.parent.format(side=side),
            line=row.line.format(side=side),
        )
        for side in SIDES
        for row in rows
    )


def placed(rows: Sequence[JointRow], lines: Lines) -> list[PlacedJoint]:
    """Returns the joints of a template on the lines of a body; joints of a missing line are left out."""
    joints: list[PlacedJoint] = []
    row_of: dict[str, int] = {}
    for row in rows:
        if row.line in lines:
            line = lines[row.line]
            row_of[row.name] = len(joints)
            tip = line[-1] if row.is_last else None
            joints.append(PlacedJoint(row.name, row_of.get(row.parent, -1), at_share(line, row.share), tip))
    return joints


def foot(graph: BodyGraph, where: Bools, what: str) -> int:
    """Returns the voxel in the middle of the lowest part of some voxels (N,).

    :raises ContentError: when no voxel is there.
    """
    height = float(np.ptp(graph.points[:, 1]))
    low = where & (graph.points[:, 1] <= graph.points[:, 1].min() + LOW * height)
    if not low.any():
        raise no_legs(what)
    rows = np.flatnonzero(low)
    middle = graph.points[rows].mean(0)
    return int(rows[((graph.points[rows] - middle) ** 2).sum(1).argmin()])


def no_legs(what: str) -> ContentError:
    """Returns the error for a mesh without the legs of a template."""
    return ContentError(
        f"the template finds no {what} in this mesh: the model must stand upright (+Y), look along the "
        "facing that you name, and its legs must be apart; the skeleton parts fits any mesh"
    )


def leg_lines(graph: BodyGraph, feet: Mapping[str, int]) -> tuple[Floats, float, dict[str, Floats]]:
    """Returns the highest point (3,) of the middle way from foot to foot, its depth, and for each side the
    line from the hip to the ground.
    """
    left, right = feet.values()
    way = graph.middle_way(left, right)
    line = graph.line(way)
    top = int(line[:, 1].argmax())
    depth = float(graph.depth[way[top]])
    sides = dict(zip(feet, (line[: top + 1][::-1], line[top:]), strict=True))
    return line[top], depth, {side: _from_hip(leg, depth) for side, leg in sides.items()}


def _from_hip(leg: Floats, depth: float) -> Floats:
    """The line of a leg from its hip, at the height of the line's start, above the way down."""
    below = np.flatnonzero(leg[:, 1] <= leg[0, 1] - depth)
    first = int(below[0]) if len(below) else 0
    hip = np.array([leg[first, 0], leg[0, 1], leg[first, 2]])
    return np.concatenate([hip[None], leg[first:]])


def down_to(line: Floats, height: float) -> tuple[Floats, Floats]:
    """Returns the parts of a line that falls: above and below a height."""
    cut = int(np.flatnonzero(line[:, 1] > height)[-1]) + 1 if (line[:, 1] > height).any() else 1
    cut = min(max(cut, 1), len(line) - 1)
    return line[: cut + 1], line[cut:]
