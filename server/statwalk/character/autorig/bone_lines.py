"""The bones of a skeleton as lines in the body: from each joint to the joints below it."""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.binding.bone_distance import BoneLines
from statwalk.skin.binding.volume import Volume

SAMPLES = 9
INSIDE = 0.5
"""share of a bone that lies in the body, if it carries vertices: a root on the ground carries none"""
SHALLOW = 3
"""voxels: a root that is not deeper carries no vertices"""
TIP = 0.9
"""share of the way to the surface that the bone of a last joint goes"""
STEPS = 48


def bone_lines(skeleton: Skeleton, joints: Ints, places: Floats, volume: Volume) -> BoneLines:
    """Returns the bones of some joints at `places` (J,3) that lie in the body; `joint` counts in `joints`.

    A joint without joints below it goes on in its parent's direction, to the surface.
    """
    row_of = {joint: row for row, joint in enumerate(joints.tolist())}
    lines: list[tuple[Floats, Floats, int]] = []
    has_child: set[int] = set()
    for joint in joints.tolist():
        above = _above(skeleton, joint, row_of)
        if above is not None:
            lines.append((places[joints[above]], places[joint], above))
            has_child.add(above)
    for row, joint in enumerate(joints.tolist()):
        if row not in has_child:
            above = _above(skeleton, joint, row_of)
            start = places[joint]
            way = start - places[joints[above]] if above is not None else np.zeros(3)
            lines.append((start, _tip(start, way, volume), row))
    bones = BoneLines(
        np.array([line[0] for line in lines]).reshape(-1, 3),
        np.array([line[1] for line in lines]).reshape(-1, 3),
        np.array([line[2] for line in lines], np.int64),
    )
    is_top = np.array([_above(skeleton, int(joint), row_of) is None for joint in joints])[bones.joint]
    is_outside = volume.depth_at(bones.start) < SHALLOW * volume.size
    return bones.take((inside_share(bones, volume) >= INSIDE) & ~(is_top & is_outside))


def inside_share(bones: BoneLines, volume: Volume) -> Floats:
    """Returns (B,) the share of each bone that lies in the body."""
    steps = np.linspace(0, 1, SAMPLES)[:, None, None]
    share: Floats = volume.holds(bones.start * (1 - steps) + bones.end * steps).mean(0)
    return share


def _above(skeleton: Skeleton, joint: int, row_of: dict[int, int]) -> int | None:
    """The row of the nearest joint above that is one of the joints."""
    parent = int(skeleton.parent[joint])
    while parent >= 0 and parent not in row_of:
        parent = int(skeleton.parent[parent])
    return row_of.get(parent)


def _tip(start: Floats, way: Floats, volume: Volume) -> Floats:
    """The end of the bone of a last joint."""
    length = float(np.linalg.norm(way))
    if length < 1e-9:
        return start
    steps = np.arange(1, STEPS + 1)[:, None] * volume.size
    ahead = start + way / length * steps
    held = volume.holds(ahead)
    count = STEPS if held.all() else int(held.argmin())
    return start + way / length * (TIP * count * volume.size)
