"""Sets of bones that the twelve rules work on: of a skeleton table, of a character, or your own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.maths import vector
from statwalk.maths.arrays import Floats
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton
from statwalk.solve.bone_values import BoneSet

Row = Mapping[str, Any]
"""of one bone: `parent`, `length`, `direction`"""
Source = Bones | Character | BoneSet | Mapping[str, Row]
MEMBERS = ("parent", "length", "direction")


def bone_set(skeleton: Skeleton, length: Floats, direction: Floats) -> BoneSet:
    """Returns bones with lengths (J,) and directions (J, 3) of any length; NaN: not known."""
    return BoneSet(
        skeleton.names, skeleton.parent, length, vector.unit(direction), np.zeros((len(length), 3))
    )


def bone_set_of(source: Source) -> BoneSet:
    """Returns the bones of a skeleton table, of rows {name: {parent, length, direction}} in any order, or of
    a character's joints in their pose at rest: a joint's bone ends at its first child that has an offset, and
    the TR of its other children starts there.

    :raises ContentError: when the source is none of them, or a row is wrong; with its place.
    """
    if isinstance(source, BoneSet):
        return source
    if isinstance(source, Bones):
        return bone_set(source.skeleton, source.length, source.direction)
    if isinstance(source, Mapping):
        return _own_bones(source)
    if not isinstance(source, Character):
        raise ContentError(
            "{name: {parent, length, direction}}, the bones of a skeleton table or a character are needed, "
            f"not {type(source).__name__}",
            place="bones",
        )
    return _joint_bones(source)


def _own_bones(rows: Mapping[str, Row]) -> BoneSet:
    if not rows:
        raise ContentError("there are no bones", place="bones")
    places = [f"bones.{name}" for name in rows]
    for place, row in zip(places, rows.values(), strict=True):
        _check_row(place, row)
    parents = [row.get("parent") for row in rows.values()]
    skeleton, order = Skeleton.sorted(list(rows), parents, places)
    lengths = [_numbers(f"bones.{name}.length", row.get("length"), ()) for name, row in rows.items()]
    ways = [_numbers(f"bones.{name}.direction", row.get("direction"), (3,)) for name, row in rows.items()]
    return bone_set(skeleton, np.array(lengths)[order], np.array(ways)[order])


def _check_row(place: str, row: Any) -> None:
    if not isinstance(row, Mapping) or not set(row) <= set(MEMBERS):
        raise ContentError(f"a bone has {', '.join(MEMBERS)}, not {row!r:.80}", place=place)
    if _numbers(f"{place}.length", row.get("length"), ()) < 0:
        raise ContentError(f"a length is 0 or more, not {row['length']}", place=place)


def _numbers(place: str, value: Any, shape: tuple[int, ...]) -> Floats:
    """Numbers; NaN if they are missing."""
    if value is None:
        return np.full(shape, np.nan)
    try:
        numbers = np.asarray(value, np.float64)
    except (TypeError, ValueError):
        numbers = np.empty(0)
    if numbers.shape != shape or not np.isfinite(numbers).all():
        wanted = "3 numbers are needed" if shape else "a number is needed"
        raise ContentError(f"{wanted}, not {value!r:.40}", place=place)
    return numbers


def _joint_bones(character: Character) -> BoneSet:
    parent = character.skeleton.parent
    offset = np.asarray(character.bind_pose.translation, np.float64)
    first = np.full(len(parent), -1)
    for joint in range(len(parent) - 1, -1, -1):
        if parent[joint] >= 0 and offset[joint].any():
            first[parent[joint]] = joint
    attachment = np.where((first >= 0)[:, None], offset[first], 0)
    length = vector.length(attachment)
    moved = offset - np.where((parent >= 0)[:, None], attachment[parent], 0)
    return BoneSet(character.skeleton.names, parent, length, vector.unit(attachment), moved)
