"""Meshes for rigging: a cylinder, a figure of boxes, an animal of boxes, and meshes of models."""

from itertools import product

import numpy as np
from statwalk.character.character import Character
from statwalk.files.gltf import read_model
from statwalk.files.gltf.write import model_glb
from statwalk.maths.pose import rest
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive

RADIUS, HALF, ROUND = 0.25, 1.0, 24


def cylinder(rings: int = 41) -> tuple[np.ndarray, np.ndarray]:
    """A closed cylinder along Y from -1 to 1, its rings at equal distances; the last two points are the
    middles of its ends.
    """
    angle = np.linspace(0, 2 * np.pi, ROUND, endpoint=False)
    heights = np.linspace(-HALF, HALF, rings)
    points = [[RADIUS * np.cos(a), y, RADIUS * np.sin(a)] for y in heights for a in angle]
    points += [[0, -HALF, 0], [0, HALF, 0]]
    low, high, last = len(points) - 2, len(points) - 1, (rings - 1) * ROUND
    faces = []
    for k in range(ROUND):
        ahead = (k + 1) % ROUND
        faces += [[low, k, ahead], [high, last + ahead, last + k]]
        for ring in range(rings - 1):
            a, b = ring * ROUND + k, ring * ROUND + ahead
            faces += [[a, a + ROUND, b], [b, a + ROUND, b + ROUND]]
    return np.array(points, float), np.array(faces)


CORNERS = np.array(list(product((-1, 1), repeat=3)), float)
BOX = np.array(
    [
        *([0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1]),
        *([2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]),
    ]
)


def boxes(
    *sizes: tuple[tuple[float, float, float], tuple[float, float, float]],
) -> tuple[np.ndarray, np.ndarray]:
    """Boxes, each a shell of its own: the middle and the half sides of each."""
    points = np.concatenate([np.array(middle) + CORNERS * half for middle, half in sizes])
    return points, np.concatenate([BOX + 8 * row for row in range(len(sizes))])


def human() -> tuple[np.ndarray, np.ndarray]:
    """A figure of 1.8 m with its arms out that looks along +Z."""
    limbs = [
        ((0, 1.2, 0), (0.2, 0.3, 0.12)),
        ((0, 1.55, 0), (0.05, 0.1, 0.05)),
        ((0, 1.68, 0), (0.1, 0.12, 0.12)),
    ]
    for side in (-1, 1):
        limbs += [
            ((side * 0.12, 0.5, 0), (0.07, 0.5, 0.07)),
            ((side * 0.12, 0.04, 0.06), (0.06, 0.04, 0.13)),
            ((side * 0.5, 1.42, 0), (0.35, 0.05, 0.05)),
        ]
    return boxes(*limbs)


def mammal() -> tuple[np.ndarray, np.ndarray]:
    """An animal 1 m long that looks along +Z, with a tail."""
    parts = [
        ((0, 0.6, 0), (0.12, 0.12, 0.5)),
        ((0, 0.8, 0.55), (0.06, 0.2, 0.06)),
        ((0, 0.95, 0.65), (0.07, 0.07, 0.15)),
        ((0, 0.66, -0.7), (0.03, 0.03, 0.25)),
    ]
    parts += [((x, 0.28, z), (0.04, 0.28, 0.04)) for x in (-0.09, 0.09) for z in (-0.42, 0.42)]
    return boxes(*parts)


def mesh(points: np.ndarray, faces: np.ndarray, mode: int = 4) -> Character:
    """A character that is a mesh on one node, as a file of it is read."""
    part = Primitive(
        joint=0,
        node=0,
        mesh=0,
        primitive=0,
        positions=np.asarray(points, np.float32),
        indices=np.asarray(faces, np.uint32).reshape(-1),
        mode=mode,
    )
    plain = Character(
        "mesh", Skeleton(("mesh",), np.array([-1], np.int32)), np.array([0], np.int32), rest(1), parts=(part,)
    )
    return read_model(model_glb(plain), "mesh")


def stripped(character: Character) -> Character:
    """The mesh of a character at rest, with its colours and without joints, skin and clips."""
    posed = character.vertices(character.bind_pose)
    parts = tuple(
        Primitive(
            joint=0,
            node=0,
            mesh=0,
            primitive=row,
            positions=shown.positions,
            normals=shown.normals,
            indices=part.indices,
            mode=part.mode,
            material=part.material,
            attributes=part.attributes,
        )
        for row, (part, shown) in enumerate(zip(character.parts, posed, strict=True))
    )
    plain = Character(
        "mesh",
        Skeleton(("mesh",), np.array([-1], np.int32)),
        np.array([0], np.int32),
        rest(1),
        parts=parts,
        materials=character.materials,
    )
    return read_model(model_glb(plain), "mesh")
