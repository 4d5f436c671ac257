"""Draws a skeleton as tetrahedra (FAQ Q28): base at a bone's start, apex at its end. RD2."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive, Skin

MATERIAL = {
    "name": "bone",
    "pbrMetallicRoughness": {
        "baseColorFactor": [0.82, 0.78, 0.68, 1.0],
        "metallicFactor": 0.0,
        "roughnessFactor": 0.65,
    },
}
# apex, then the base; the FAQ prints the last y as -3.306186
UNIT = np.array([[0, 0, 1], [0.353553, 0, 0], [-0.176776, 0.306186, 0], [-0.176776, -0.306186, 0]])
FACES = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
_THICKNESS = 0.4  # of the base, relative to the median length of all bones, or the bone's own if that is less


def rigid_parts(bones: Bones, drawn: Sequence[int]) -> tuple[Primitive, ...]:
    """Returns one rigid part for each of the `drawn` bones, which moves with the bone's joint; metres."""
    solids = _solids(bones, bones.length)
    return tuple(
        Primitive(
            joint=bone,
            node=bone,
            mesh=mesh,
            primitive=0,
            positions=solids[bone],
            normals=_normals(solids[bone]),
            material=0,
        )
        for mesh, bone in enumerate(drawn)
    )


def joined_parts(skeleton: Skeleton, offsets: Floats) -> tuple[Primitive, ...]:
    """Returns one rigid part for each joint that has children: tetrahedra from the joint to each of them.

    `offsets` (J, 3) are the joints' rest translations, in the unit of the file.
    """
    length = np.sqrt((offsets * offsets).sum(-1)) * (skeleton.parent >= 0)
    direction = offsets / np.where(length > 0, length, 1)[:, None]
    solids = _solids(Bones(skeleton, length, direction), length)
    of_joint: dict[int, list[NDArray[np.float32]]] = {}
    for child in np.flatnonzero(length > 0).tolist():
        of_joint.setdefault(int(skeleton.parent[child]), []).append(solids[child])
    return tuple(
        Primitive(
            joint=joint,
            node=joint,
            mesh=mesh,
            primitive=0,
            positions=np.concatenate(drawn),
            normals=np.concatenate([_normals(solid) for solid in drawn]),
            material=0,
        )
        for mesh, (joint, drawn) in enumerate(sorted(of_joint.items()))
    )


def growing_part(
    bones: Bones, longest_length: Floats, end_joint_of: Mapping[int, int], mesh: int, node: int
) -> tuple[Primitive, Skin]:
    """Returns one skinned part for all bones with a keyed length, and its skin.

    The base of a tetrahedron follows the bone's joint, the apex follows the joint `end_joint_of[bone]`.
    `longest_length` (J,), metres, is the length that each bone is drawn with: a bone that rests at length 0
    gets its shape and its normals from it.
    """
    drawn = list(end_joint_of)
    solids = _solids(bones, longest_length)
    positions = np.concatenate([solids[bone] for bone in drawn])
    joint_of_vertex = (
        np.tile((FACES.reshape(-1) == 0).astype(np.uint16), (len(drawn), 1))
        + 2 * np.arange(len(drawn), dtype=np.uint16)[:, None]
    )
    joints = np.array([joint for bone in drawn for joint in (bone, end_joint_of[bone])], np.int32)
    skin = Skin("growing bones", joints, _inverse_bind(bones, longest_length, drawn))
    weights = np.ones((len(positions), 1), np.float32)
    normals = np.concatenate([_normals(solids[bone]) for bone in drawn])
    part = Primitive(
        0,
        node,
        mesh,
        0,
        positions,
        normals,
        material=0,
        skin=0,
        joints=joint_of_vertex.reshape(-1, 1),
        weights=weights,
    )
    return part, skin


def _solids(bones: Bones, length: Floats) -> list[NDArray[np.float32]]:
    """Returns for every bone the corners (12, 3) of its tetrahedron's faces, in the bone's own space."""
    drawn_lengths = length[length > 0]
    thickness = np.minimum(
        _THICKNESS * length, _THICKNESS * (np.median(drawn_lengths) if len(drawn_lengths) else 0)
    )
    size = np.stack([thickness, thickness, length], -1)
    direction = np.where(length[:, None] > 0, bones.direction, [0.0, 0.0, 1.0])
    turn = quat.between(np.broadcast_to([0.0, 0.0, 1.0], direction.shape), direction)
    corners = quat.rotate(turn[:, None, :], UNIT * size[:, None, :])
    return [solid[FACES].reshape(12, 3).astype(np.float32) for solid in corners]


def _normals(positions: NDArray[np.float32]) -> NDArray[np.float32]:
    """Returns flat normals (12, 3): the faces share no corners."""
    face = positions.reshape(4, 3, 3).astype(np.float64)
    normal = np.cross(face[:, 1] - face[:, 0], face[:, 2] - face[:, 0])
    normal /= np.sqrt((normal * normal).sum(-1, keepdims=True))
    return np.repeat(normal, 3, 0).astype(np.float32)


def _inverse_bind(bones: Bones, longest_length: Floats, drawn: Sequence[int]) -> NDArray[np.float32]:
    """Returns inverse bind matrices (2K, 3, 4): the identity for a bone's joint, whose space the corners are
    in, and the way back from the apex for the joint at its end.
    """
    inverse = np.zeros((2 * len(drawn), 3, 4), np.float32)
    inverse[:, :, :3] = np.eye(3)
    inverse[1::2, :, 3] = -bones.attachment(longest_length)[drawn]
    return inverse
