"""The body that is rigged, and the space in which it was bound: its mesh, and the matrices of its joints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths import transform
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.binding.shell import Shell, welded
from statwalk.skin.primitive import Primitive, Skin
from statwalk.skin.shading import triangles

SMALLEST_VOLUME = 1e-12
"""of an inverse bind matrix that has an inverse"""
MOST_TRIANGLES, MOST_VERTICES = 400_000, 400_000
SURFACES = (4, 5, 6)
"""glTF's modes of triangles, strips and fans"""


@dataclass(frozen=True, eq=False)
class RigBody:
    """The parts of a character that rigging reads and writes, under a Character's names."""

    skeleton: Skeleton
    node_index: Ints
    bind_pose: Pose
    skins: tuple[Skin, ...]
    parts: tuple[Primitive, ...]
    clips: Mapping[str, Clip] = field(default_factory=dict)

    def character_fields(self) -> dict[str, Any]:
        """Returns the fields by their names."""
        return {part.name: getattr(self, part.name) for part in fields(self)}


@dataclass(frozen=True, eq=False)
class BindSpace:
    """joints  (J,3,4) the joints when they were bound
    placed     (P,3,4) the space of each part
    """

    joints: Floats
    placed: Floats
    is_skin_joint: Bools
    """(J,)"""


def bind_space(body: RigBody) -> BindSpace:
    """Returns the space in which a body was bound: of a skin its bind matrices, otherwise the pose at rest.

    Skins stand as they were bound even if the file rests in another pose; a skin is placed so that its first
    joint is where it rests, or where another skin has placed it.
    """
    rest = world_from_local(body.skeleton, body.bind_pose).astype(np.float64)
    bound, is_bound = rest.copy(), np.zeros(len(rest), bool)
    skin_places = [_placed_skin(skin, bound, is_bound) for skin in body.skins]
    for joint, parent in enumerate(body.skeleton.parent.tolist()):
        if not is_bound[joint] and parent >= 0:
            bound[joint] = _carried(rest, bound, joint, parent)
    placed = [bound[part.joint] if part.skin is None else skin_places[part.skin] for part in body.parts]
    return BindSpace(bound, np.array(placed).reshape(-1, 3, 4), is_bound)


def shell_of(body: RigBody, placed: Floats) -> Shell:
    """Returns the welded mesh of all parts, each in its space (P,3,4).

    :raises ContentError: when there are no triangles, or too many.
    """
    faces = [_triangles(part) for part in body.parts]
    count, vertices = sum(map(len, faces)), sum(len(part.positions) for part in body.parts)
    if not count:
        raise ContentError("the model has no triangles, so it cannot be rigged")
    if count > MOST_TRIANGLES or vertices > MOST_VERTICES:
        raise ContentError(
            f"the model has {count:,} triangles and {vertices:,} vertices; at most {MOST_TRIANGLES:,} and "
            f"{MOST_VERTICES:,} can be rigged: make it simpler first"
        )
    positions = [
        transform.apply(place, part.positions.astype(np.float64))
        for place, part in zip(placed, body.parts, strict=True)
    ]
    shell = welded(positions, faces)
    if not np.isfinite(shell.points).all() or not 1e-9 < shell.size < 1e12 or not len(shell.triangles):
        raise ContentError("the model has no size: all its vertices are at one place, or infinitely far")
    return shell


def _triangles(part: Primitive) -> Ints:
    """(T,3) the triangles of a part; none of points and lines."""
    if part.mode not in SURFACES:
        return np.zeros((0, 3), np.int64)
    drawn = np.arange(len(part.positions)) if part.indices is None else part.indices
    return triangles(drawn.astype(np.int64), part.mode)


def _placed_skin(skin: Skin, bound: Floats, is_bound: Bools) -> Floats:
    """The space (3,4) of a skin's vertices; writes the joints that it places."""
    matrices = skin.inverse_bind.astype(np.float64)
    volumes = np.abs(np.linalg.det(matrices[:, :, :3]))
    good = np.flatnonzero((volumes > SMALLEST_VOLUME) & np.isfinite(volumes))
    if not len(good):
        return np.eye(3, 4)
    rows = skin.joints[good]
    first = int(np.lexsort((rows, ~is_bound[rows]))[0])
    place: Floats = transform.mul(bound[rows[first]], matrices[good[first]])
    new = ~is_bound[rows]
    bound[rows[new]] = transform.mul(place, transform.invert(matrices[good[new]]))
    is_bound[rows] = True
    return place


def _carried(rest: Floats, bound: Floats, joint: int, parent: int) -> Floats:
    """A joint as it stands to its parent at rest."""
    carried: Floats = rest[joint]
    if abs(np.linalg.det(rest[parent, :, :3])) > SMALLEST_VOLUME:
        local = transform.mul(transform.invert(rest[parent]), rest[joint])
        carried = transform.mul(bound[parent], local)
    return carried
