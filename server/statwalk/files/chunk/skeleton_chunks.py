"""The skeleton: a SKIN chunk for each joint, nested below its parent's, with the joint's PIVO and CONS."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.chunk.chunk_tree import Chunk, ChunkReader, joined, refuse
from statwalk.files.chunk.records import CONS, DEEPEST, PIVO
from statwalk.files.gltf.check import LARGEST
from statwalk.maths import pose as poses
from statwalk.maths.clamp_kinds import EULER
from statwalk.maths.clamp_table import JointLimit, Range
from statwalk.maths.pose import Pose
from statwalk.rig.joint_types import ORDERS, TYPES
from statwalk.rig.skeleton import Skeleton

MOST_JOINTS = 65_536
UNIT = 1e-3


class JointChunk(NamedTuple):
    """A joint as its SKIN chunk says it; `parent` is a row, -1 for a root."""

    chunk: Chunk
    name: str
    row: int
    node: int
    parent: int
    rest: tuple[float, ...]
    limit: JointLimit | None
    is_muscle: bool


@dataclass
class JointChunks:
    """The joints and the POLY chunks of an object, in the order of the file."""

    reader: ChunkReader
    joints: list[JointChunk] = field(default_factory=list)
    polygons: list[tuple[int, Chunk]] = field(default_factory=list)
    """the joint's row, and the POLY chunk"""

    def take(self, root: Chunk) -> None:
        """Reads a SKIN chunk and the chunks inside it, in a loop: no nesting is too deep for Python.

        :raises ModelError: when a chunk is wrong, or SKIN chunks are nested too deep.
        """
        pending = [(root, -1, 1)]
        while pending:
            chunk, parent, depth = pending.pop()
            if depth > DEEPEST:
                raise refuse(chunk, f"joints may be nested {DEEPEST} deep at most")
            joint, inside = self._joint(chunk, parent)
            self.joints.append(joint)
            if len(self.joints) > MOST_JOINTS:
                raise refuse(chunk, f"a skeleton may have {MOST_JOINTS} joints at most")
            self.polygons += [(joint.row, below) for below in inside if below.tag == "POLY"]
            pending += [(below, joint.row, depth + 1) for below in reversed(inside) if below.tag == "SKIN"]

    def _joint(self, chunk: Chunk, parent: int) -> tuple[JointChunk, list[Chunk]]:
        name, inside = self.reader.name(chunk, 0, ("PIVO", "CONS", "MUSC", "POLY", "SKIN"))
        pivots = [below for below in inside if below.tag == "PIVO"]
        limits = [limit_of(below) for below in inside if below.tag == "CONS"]
        if len(pivots) != 1 or len(limits) > 1:
            raise refuse(chunk, f"a joint has one PIVO, and one CONS at most; {name[:60]!r} has not")
        row, node, *rest = pivots[0].record(PIVO)
        if not all(abs(number) <= LARGEST for number in rest):
            raise refuse(pivots[0], f"a number is not finite, or larger than {LARGEST:g}")
        limit, is_muscle = limits[0] if limits else None, any(below.tag == "MUSC" for below in inside)
        return JointChunk(chunk, name, row, node, parent, tuple(rest), limit, is_muscle), inside

    def in_order(self, count: int) -> list[JointChunk]:
        """Returns the joints by their rows.

        :raises ModelError: when rows are not 0…count-1, once each, a parent before its children; when a node
            occurs twice; when two joints have one name.
        """
        self.joints.sort(key=lambda joint: joint.row)
        for row, joint in enumerate(self.joints):
            if joint.row != row or joint.parent >= row:
                raise refuse(
                    joint.chunk,
                    f"the rows of joints run from 0, parents first; {joint.name[:60]!r} has {joint.row}",
                )
        if len(self.joints) != count:
            chunk = self.joints[-1].chunk if self.joints else Chunk("OBJE", memoryview(b""), 0)
            raise refuse(chunk, f"the object has {len(self.joints)} joints, and says {count}")
        for what, values in (
            ("node", [joint.node for joint in self.joints]),
            ("name", [joint.name for joint in self.joints]),
        ):
            if len(set(values)) < len(values):
                raise refuse(self.joints[0].chunk, f"two joints have the same {what}")
        return self.joints


def skeleton_of(joints: list[JointChunk]) -> Skeleton:
    """Returns the skeleton of joints in their order.

    :raises ModelError: when another joint hangs on a muscle bone.
    """
    skeleton = Skeleton(
        tuple(joint.name for joint in joints), np.array([joint.parent for joint in joints], np.int32)
    )
    try:
        return skeleton.with_muscle_bones(joint.name for joint in joints if joint.is_muscle)
    except ContentError as error:
        raise refuse(joints[0].chunk, error.message) from None


def rest_of(joints: list[JointChunk], weights: int) -> Pose:
    """Returns the rest pose of joints in their order, with room for morph weights."""
    rest = poses.rest(len(joints), weights)
    numbers = np.array([joint.rest for joint in joints], np.float32).reshape(-1, 10)
    rest.translation[:], rest.rotation[:], rest.scale[:] = numbers[:, :3], numbers[:, 3:7], numbers[:, 7:]
    return rest


def limit_of(chunk: Chunk) -> JointLimit:
    """Returns the limits in a CONS chunk.

    :raises ModelError: when a range ends below its beginning, or the type, form, order or kind is unknown.
    """
    kind, has_slide, *rest = chunk.record(CONS)
    values, words = rest[:23], [_word(chunk, word) for word in rest[23:]]
    ends: list[Range] = [(values[at], values[at + 1]) for at in range(4, 22, 2)]
    name, form, order = words
    if kind > EULER or has_slide > 1 or not all(abs(value) <= LARGEST for value in values):
        raise refuse(chunk, f"a limit has a kind 0…{EULER} and finite numbers")
    if any(low > high for low, high in ends):
        raise refuse(chunk, "a minimum is more than its maximum")
    if (
        name not in ("", *TYPES)
        or form not in ("", *(TYPES[name].forms if name else ()))
        or order not in ORDERS
    ):
        raise refuse(chunk, f"no joint has type {name!r}, form {form!r} and order {order!r}")
    if abs(math.hypot(*values[:4]) - 1) > UNIT or (name == "helical") != (values[22] != 0):
        raise refuse(chunk, "the frame is a rotation of length 1; a helical joint, and no other, has a pitch")
    twist, swing_x, swing_z, x, y, z, *slide = ends
    return JointLimit(
        kind,
        (values[0], values[1], values[2], values[3]),
        twist,
        (swing_x, swing_z),
        (x, y, z),
        (slide[0], slide[1], slide[2]) if has_slide else None,
        values[22],
        order,
        name,
        form,
    )


def _word(chunk: Chunk, word: bytes) -> str:
    try:
        return word.rstrip(b"\0").decode("ascii")
    except UnicodeDecodeError:
        raise refuse(chunk, "type, form and order are words of ASCII letters") from None


def limit_chunk(limit: JointLimit) -> bytes:
    """Returns the CONS chunk of limits."""
    ranges = (limit.twist, *limit.swing, *limit.angles, *(limit.slide or ((0.0, 0.0),) * 3))
    numbers = (*limit.frame, *(end for ends in ranges for end in ends), limit.pitch)
    words = (limit.type.encode(), limit.form.encode(), limit.order.encode())
    return joined("CONS", CONS.pack(limit.kind, int(limit.slide is not None), *numbers, *words))


def joint_chunks(character: Character, polygons: dict[int, list[bytes]]) -> Iterator[bytes]:
    """Yields the SKIN chunks of the roots, each with its joints inside; `polygons`: the POLY chunks of each
    joint.

    :raises ContentError: when the joints are nested too deep.
    """
    parent = character.skeleton.parent.tolist()
    _check_depth(parent)
    inside: dict[int, list[bytes]] = {row: [] for row in range(-1, len(parent))}
    for row in range(len(parent) - 1, -1, -1):
        own = _own_chunks(character, row)
        children = inside.pop(row)[::-1]
        inside[parent[row]].append(joined("SKIN", *own, *polygons.get(row, ()), *children))
    yield from inside[-1][::-1]


def _own_chunks(character: Character, row: int) -> list[bytes]:
    pose, name = character.bind_pose, character.skeleton.names[row]
    rest = (*pose.translation[row].tolist(), *pose.rotation[row].tolist(), *pose.scale[row].tolist())
    chunks = [joined("NAME", name.encode()), joined("PIVO", PIVO.pack(row, character.node_index[row], *rest))]
    chunks += [limit_chunk(character.limits[name])] if name in character.limits else []
    return chunks + ([joined("MUSC")] if name in character.skeleton.muscle_bones else [])


def _check_depth(parent: list[int]) -> None:
    depths: list[int] = []
    for above in parent:
        depths.append(1 if above < 0 else depths[above] + 1)
    if max(depths, default=0) > DEEPEST:
        raise ContentError(f"the chunk format nests joints {DEEPEST} deep at most, not {max(depths)}")
