"""Adds morph targets to a character: columns of its weights, of its meshes and of its clips' keys."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import count
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip
from statwalk.skin.primitive import Primitive

MOST_NUMBERS = 4_000_000
"""new morph targets times vertices, of all meshes that get them"""
Rows = dict[int, NDArray[np.float32]]


class AddedTarget(NamedTuple):
    """A morph target that a character gets: displacements (V, 3) of positions and normals, by the place of
    the part in the character's parts.
    """

    name: str
    positions: Rows
    normals: Rows


class _Insertion(NamedTuple):
    """New columns of a node's weights, before the column `at` of the old ones."""

    at: int
    node: int
    targets: tuple[AddedTarget, ...]
    joint: int
    own: int
    """how many targets the node has already"""


def check_new(character: Character, name: str) -> None:
    """Checks that no morph target has the name.

    :raises ContentError: when one has it.
    """
    if name in character.targets:
        raise ContentError(f"the morph target {name[:60]!r} exists already; choose another name")


def check_room(numbers: int) -> None:
    """Checks that new morph targets times vertices are not too many.

    :raises ContentError: when they are.
    """
    if numbers > MOST_NUMBERS:
        raise ContentError(
            f"the new morph targets times the vertices of their meshes are {numbers:,}; at most "
            f"{MOST_NUMBERS:,} are allowed"
        )


def with_targets(character: Character, targets: Sequence[AddedTarget]) -> Character:
    """Returns the character with further morph targets, without a model; their weights rest at 0.

    A node whose parts have targets gets their columns after its own, another node in the order of nodes; keys
    of weights get zeros for them. A target without a name, `target_3` by its column, keeps that name.

    :raises ContentError: when there would be too many numbers.
    """
    insertions = _insertions(character, targets)
    _check_insertions(character, insertions)
    columns = np.array([at for at, _, added, *_ in insertions for _ in added], np.int64)
    names = _names(character)
    for at, _, added, *_ in reversed(insertions):
        names[at:at] = [target.name for target in added]
    return replace(
        character,
        bind_pose=_widened(character.bind_pose, columns),
        clips={name: _clip(clip, insertions, columns) for name, clip in character.clips.items()},
        parts=_parts(character, insertions),
        target_names=tuple(names),
    )


def _names(character: Character) -> list[str]:
    """Returns the names of all columns; a target without a name has that of its column."""
    names = character.target_names or [""] * character.bind_pose.weights.shape[-1]
    return [name or f"target_{column}" for column, name in enumerate(names)]


def _insertions(character: Character, targets: Sequence[AddedTarget]) -> list[_Insertion]:
    """Returns the new columns, in the order of the columns before which they stand, and of the nodes."""
    of_node: dict[int, list[AddedTarget]] = {}
    for target in targets:
        for node in dict.fromkeys(character.parts[row].node for row in target.positions):
            of_node.setdefault(node, []).append(target)
    insertions = []
    for node, added in of_node.items():
        part = next(part for part in character.parts if part.node == node)
        own = _count(part)
        at = part.weight_first + own if own else _column_of(character, node)
        insertions.append(_Insertion(at, node, tuple(added), part.joint, own))
    return sorted(insertions, key=lambda insertion: insertion[:2])


def _column_of(character: Character, node: int) -> int:
    """Returns the column before which a node without targets gets its first: nodes keep their order."""
    later = [part.weight_first for part in character.parts if part.node > node and _count(part)]
    return min(later, default=character.bind_pose.weights.shape[-1])


def _check_insertions(character: Character, insertions: Sequence[_Insertion]) -> None:
    counts = {insertion.node: len(insertion.targets) for insertion in insertions}
    sizes = {(part.mesh, part.primitive): 0 for part in character.parts}
    for part in character.parts:
        size = counts.get(part.node, 0) * len(part.positions)
        sizes[part.mesh, part.primitive] = max(sizes[part.mesh, part.primitive], size)
    check_room(sum(sizes.values()))


def _count(part: Primitive) -> int:
    return 0 if part.target_positions is None else len(part.target_positions)


def _moved(insertions: Sequence[_Insertion], column: int) -> int:
    """Returns the new place of an old column."""
    return column + sum(len(insertion.targets) for insertion in insertions if insertion.at <= column)


def _first(insertions: Sequence[_Insertion], node: int) -> int:
    """Returns the first new column of a node."""
    place = next(row for row, insertion in enumerate(insertions) if insertion.node == node)
    before = sum(len(insertion.targets) for insertion in insertions[:place])
    return insertions[place].at + before


def _widened(pose: Pose, columns: NDArray[np.int64]) -> Pose:
    return pose._replace(weights=np.insert(pose.weights, columns, 0, axis=-1))


def _parts(character: Character, insertions: Sequence[_Insertion]) -> tuple[Primitive, ...]:
    """Returns the parts with their new targets."""
    by_node = {insertion.node: insertion for insertion in insertions}
    meshes = _meshes(character, by_node)
    parts = []
    for row, part in enumerate(character.parts):
        mesh = meshes[part.node]
        if part.node not in by_node:
            first = _moved(insertions, part.weight_first)
            parts.append(replace(part, weight_first=first, mesh=mesh))
            continue
        first = _first(insertions, part.node) - _count(part)
        part = replace(part, weight_first=first, mesh=mesh)
        parts.append(_with_rows(part, row, by_node[part.node].targets))
    return tuple(parts)


def _meshes(character: Character, by_node: Mapping[int, _Insertion]) -> dict[int, int]:
    """Returns the mesh of each node: nodes that shared one go on sharing it where they get the same targets
    and their own have the same names; otherwise the mesh stays with the nodes that get none.
    """
    fresh = count(1 + max((part.mesh for part in character.parts), default=-1))
    names = _names(character)
    rows_of: dict[int, list[int]] = {}
    for row, part in enumerate(character.parts):
        rows_of.setdefault(part.node, []).append(row)
    meshes: dict[int, int] = {}
    numbers: dict[tuple[object, ...], int] = {}
    for node in sorted(rows_of, key=lambda node: node in by_node):
        part = character.parts[rows_of[node][0]]
        own = names[part.weight_first : part.weight_first + _count(part)]
        added = by_node[node].targets if node in by_node else ()
        arrays = [id(target.positions.get(row)) for target in added for row in rows_of[node]]
        key = (part.mesh, tuple(own), *arrays)
        if key not in numbers:
            numbers[key] = part.mesh if part.mesh not in numbers.values() else next(fresh)
        meshes[node] = numbers[key]
    return meshes


def _with_rows(part: Primitive, row: int, targets: Sequence[AddedTarget]) -> Primitive:
    """Returns the part with the displacements of new targets after its own."""
    none = np.zeros(part.positions.shape, np.float32)
    own = np.zeros((0, *none.shape), np.float32) if part.target_positions is None else part.target_positions
    positions = np.stack([target.positions.get(row, none) for target in targets])
    replaced = replace(part, target_positions=np.concatenate([own, positions]))
    if part.normals is None:
        return replaced
    old = np.zeros_like(own) if part.target_normals is None else part.target_normals
    normals = np.stack([target.normals.get(row, none) for target in targets])
    return replace(replaced, target_normals=np.concatenate([old, normals]))


def _clip(clip: Clip, insertions: Sequence[_Insertion], columns: NDArray[np.int64]) -> Clip:
    """Returns the clip over the wider rest pose."""
    channels: Sequence[Channel] = clip.channels
    if any(channel.path == "weights" for channel in channels):
        channels = tuple(_channel(channel, insertions) for channel in channels)
    return replace(clip, channels=channels, rest=_widened(clip.rest, columns))


def _channel(channel: Channel, insertions: Sequence[_Insertion]) -> Channel:
    if channel.path != "weights":
        return channel
    count = channel.values.shape[-1]
    first = _moved(insertions, channel.weight_first)
    for insertion in insertions:
        is_whole = insertion.own == count and insertion.at == channel.weight_first + count
        if is_whole and insertion.joint == channel.joint:
            zeros = np.zeros((*channel.values.shape[:-1], len(insertion.targets)), channel.values.dtype)
            values = np.concatenate([channel.values, zeros], -1)
            return replace(channel, values=values, weight_first=first)
    return replace(channel, weight_first=first)
