"""Adds a skeleton to a body: new joints below no node of the file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from statwalk.character.autorig.bind_space import RigBody
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.binding.bone_distance import BoneLines

PREFIX = "rig:"
"""before the name of a new joint that a node of the file has already"""


class PlacedJoint(NamedTuple):
    """A joint of a new skeleton: the row of its parent in the list, -1 a root, its place (3,), and where its
    bone ends if no joint is there.
    """

    name: str
    parent: int
    place: Floats
    tip: Floats | None = None


def depth_first(joints: Sequence[PlacedJoint]) -> list[PlacedJoint]:
    """Returns the joints in the order in which a file is read: each before its children, and all below it
    before the next.
    """
    order: list[int] = []
    waiting = [row for row, joint in enumerate(joints) if joint.parent < 0][::-1]
    while waiting:
        order.append(waiting.pop())
        waiting += [row for row, joint in enumerate(joints) if joint.parent == order[-1]][::-1]
    place = {row: number for number, row in enumerate(order)}
    return [joints[row]._replace(parent=place.get(joints[row].parent, -1)) for row in order]


def with_joints(body: RigBody, joints: Sequence[PlacedJoint]) -> tuple[RigBody, Ints]:
    """Returns the body with the joints, which rest unrotated at their places, and their rows (K,)."""
    first, node = len(body.skeleton), int(body.node_index.max(initial=-1)) + 1
    places = np.array([joint.place for joint in joints], np.float64)
    parents = np.array([joint.parent for joint in joints], np.int32)
    offset = np.where(parents[:, None] < 0, places, places - places[parents])
    taken = set(body.skeleton.names)
    names = [PREFIX + joint.name if joint.name in taken else joint.name for joint in joints]
    skeleton = Skeleton(
        (*body.skeleton.names, *names),
        np.concatenate([body.skeleton.parent, np.where(parents < 0, -1, parents + first)]).astype(np.int32),
        body.skeleton.muscle_bones,
    )
    added = Pose(offset, np.tile([0.0, 0, 0, 1], (len(joints), 1)), np.ones((len(joints), 3)), np.zeros(0))
    whole = replace(
        body,
        skeleton=skeleton,
        node_index=np.append(body.node_index, np.arange(node, node + len(joints))).astype(np.int32),
        bind_pose=_longer(body.bind_pose, added),
        clips={name: replace(clip, rest=_longer(clip.rest, added)) for name, clip in body.clips.items()},
    )
    return whole, np.arange(first, first + len(joints))


def placed_lines(joints: Sequence[PlacedJoint]) -> BoneLines:
    """Returns the bones of joints: to the joints below them, and to their tips."""
    ends = [(joint.parent, joint.place) for joint in joints if joint.parent >= 0]
    ends += [(row, joint.tip) for row, joint in enumerate(joints) if joint.tip is not None]
    rows = np.array([row for row, _ in ends], np.int64)
    start = np.array([joints[row].place for row in rows.tolist()])
    return BoneLines(start.reshape(-1, 3), np.array([end for _, end in ends]).reshape(-1, 3), rows)


def _longer(pose: Pose, added: Pose) -> Pose:
    """The pose with more joints at its end."""
    arrays = [
        np.concatenate([ours, theirs.astype(ours.dtype)]) for ours, theirs in zip(pose, added, strict=True)
    ]
    return Pose(*arrays)
