"""A skeleton from a mesh alone (RTCA 2.3.1, after Hagland): the mesh is shrunk to the lines in its middle,
the lines are broken into parts, and each part becomes a bone.

The lines are found as TEASAR finds them (Sato et al. 2000): from the middle of the body to the point that is
furthest, then from this line to the point that is furthest of those not yet near a line, and so on.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.character.autorig.added_joints import PlacedJoint
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.skin.binding.body_graph import BodyGraph, at_share, length_of, way_to

MOST_LIMBS = 32
FLESH = 1.4
"""the points within so many depths of a line belong to it"""
SHORTEST = 0.06
"""share of the body's length below which a limb is none"""
SLIMNESS = 6.0
"""a limb longer than so many times its depth is broken in two, and so on"""
MOST_PIECES = 5


class _Limb(NamedTuple):
    """A line (K,3) out of the body, the joints of its pieces, and the row of the first."""

    line: Floats
    first: int
    pieces: int


def part_joints(graph: BodyGraph) -> list[PlacedJoint]:
    """Returns the joints of a skeleton for a body: the root in the middle of its longest way, and a chain of
    joints for each limb, from where it leaves the body.
    """
    root = _middle(graph)
    before, lengths = graph.ways_from(root), graph.lengths_from(root)
    near = _near(graph, np.array([root]))
    joints, limbs = [PlacedJoint("Root", -1, graph.points[root])], list[_Limb]()
    owner = np.full(len(graph.points), -1)
    owner[root] = 0
    while not near.all() and len(limbs) < MOST_LIMBS:
        tip = int(np.where(near, -1, lengths).argmax())
        way = way_to(before, tip)
        stem = int(np.flatnonzero(owner[way] >= 0)[-1])
        free = way[stem:][~_near(graph, way[stem : stem + 1])[way[stem:]]]
        near[tip] = True
        line = graph.line(free) if len(free) > 1 else graph.points[free]
        if len(line) < 2 or length_of(line) < SHORTEST * lengths[np.isfinite(lengths)].max():
            near |= _near(graph, way[-1:])
            continue
        near |= _near(graph, way[stem:])
        limb = _Limb(line, len(joints), _pieces(graph, free, line))
        _add(joints, limb, len(limbs) + 1, int(owner[way[stem]]))
        limbs.append(limb)
        _own(owner, way[stem:], free, limb, int(owner[way[stem]]))
    if not limbs:
        joints[0] = joints[0]._replace(tip=graph.points[int(lengths.argmax())])
    return joints


def _middle(graph: BodyGraph) -> int:
    """The voxel in the middle of the longest way through the body."""
    first = int(graph.lengths_from(int(graph.depth.argmax())).argmax())
    lengths = graph.lengths_from(first)
    way = graph.middle_way(first, int(lengths.argmax()))
    return int(way[len(way) // 2])


def _near(graph: BodyGraph, way: Ints) -> Bools:
    """(N,) the voxels in the flesh around a way."""
    near = np.zeros(len(graph.points), bool)
    for voxel in way.tolist():
        reach = FLESH * graph.depth[voxel] + 2 * graph.size
        near |= ((graph.points - graph.points[voxel]) ** 2).sum(1) <= reach**2
    return near


def _pieces(graph: BodyGraph, way: Ints, line: Floats) -> int:
    return int(np.clip(round(length_of(line) / (SLIMNESS * float(graph.depth[way].mean()))), 1, MOST_PIECES))


def _add(joints: list[PlacedJoint], limb: _Limb, number: int, parent: int) -> None:
    """Adds the joints of a limb; the last one has its tip at the end of the limb."""
    for piece in range(limb.pieces):
        is_last = piece == limb.pieces - 1
        joints.append(
            PlacedJoint(
                f"Part{number}" if limb.pieces == 1 else f"Part{number}_{piece + 1}",
                parent if piece == 0 else len(joints) - 1,
                at_share(limb.line, piece / limb.pieces),
                limb.line[-1] if is_last else None,
            )
        )


def _own(owner: Ints, way: Ints, free: Ints, limb: _Limb, parent: int) -> None:
    """Writes which joint owns the voxels of a limb's way."""
    owner[way] = np.where(owner[way] >= 0, owner[way], parent)
    piece = np.minimum(np.arange(len(free)) * limb.pieces // len(free), limb.pieces - 1)
    owner[free] = limb.first + piece
