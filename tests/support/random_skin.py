"""Skins with random bones: rotations, rotations with stretches, mirrors."""

import numpy as np
from scipy.spatial.transform import Rotation
from statwalk.skin.deform import surface
from statwalk.skin.primitive import Primitive, Skin

JOINTS, VERTICES = 6, 45


def rotations(chance, count, most=np.pi):
    """(count,3,3) rotations by at most an angle."""
    axes = chance.normal(size=(count, 3))
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    return Rotation.from_rotvec(axes * chance.uniform(0, most, (count, 1))).as_matrix()


def moved(chance, linear):
    """(count,3,4) matrices of these linear parts, moved."""
    return np.concatenate([linear, chance.normal(size=(len(linear), 3, 1))], axis=2).astype(np.float32)


def bones(chance, kind, count):
    """(count,3,4) matrices: `rigid`, `stretched` along oblique axes, or `mirrored` as well."""
    turns = rotations(chance, count, 2.2)
    if kind == "rigid":
        return moved(chance, turns)
    frames = rotations(chance, count)
    sizes = chance.uniform(0.4, 2.5, (count, 3)) * (-1 if kind == "mirrored" else 1)
    return moved(chance, turns @ (frames * sizes[:, None, :]) @ frames.swapaxes(1, 2))


def skinned(chance, influences, *, is_dual=True):
    """A surface of one skin whose bones are all the joints, bound at the origin."""
    positions, raw = chance.normal(size=(2, VERTICES, 3))
    normals = raw / np.linalg.norm(raw, axis=1, keepdims=True)
    bind = np.tile(np.eye(4, dtype=np.float32)[:3], (JOINTS, 1, 1))
    joints = np.stack([chance.permutation(JOINTS)[:influences] for _ in range(VERTICES)]).astype(np.uint16)
    weights = chance.dirichlet(np.ones(influences), VERTICES).astype(np.float32)
    points = positions.astype(np.float32), normals.astype(np.float32)
    part = Primitive(0, 0, 0, 0, *points, skin=0, joints=joints, weights=weights)
    return surface([part], [Skin("skin", np.arange(JOINTS, dtype=np.int32), bind)], is_dual=is_dual)
