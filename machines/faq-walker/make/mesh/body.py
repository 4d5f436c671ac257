"""The body: one seamless mesh with normals, weights and materials, in its binding pose."""

from dataclasses import dataclass

import numpy as np
from curves import Array
from mesh.figure import ARM_SPREAD, LEG_SPREAD, figure
from mesh.garments import dress
from mesh.surface import Indices, edges_of, gradient, relaxed, spaced, surface_net, triangles
from mesh.weights import soft_weights, strongest
from numpy.typing import NDArray
from skeleton import NAMES, PARENT, SIDES, rest_translation

HALF_WIDTH = spaced([(0.12, 0.0215), (0.44, 0.0250), (0.66, 0.0140)], 0.0)
LINES = (
    np.concatenate([-HALF_WIDTH[:0:-1], HALF_WIDTH]),
    spaced([(0.12, 0.0150), (0.80, 0.0310), (1.00, 0.0180), (1.38, 0.0260), (1.80, 0.0170)], -0.03),
    spaced([(0.26, 0.0190)], -0.22),
)


@dataclass(frozen=True)
class Body:
    """Points, normals (V, 3), joints, weights (V, 4) and one list of triangles (T, 3) per material."""

    points: Array
    normals: Array
    joints: NDArray[np.uint8]
    weights: NDArray[np.float32]
    parts: dict[str, Indices]


def make_body() -> Body:
    """Surface, weights, clothes."""
    points, quads = surface_net(figure, LINES)
    points = relaxed(figure, points, quads, 10)
    weights = soft_weights(points, edges_of(quads))
    points, weights, parts = dress(points, weights, triangles(points, quads))
    slope = gradient(figure, points)
    normals = slope / np.linalg.norm(slope, axis=1, keepdims=True)
    joints, kept = strongest(weights)
    return Body(points, normals, joints, kept, parts)


def bind_rotation() -> Array:
    """World rotation matrices (J, 3, 3) of the pose the mesh is made in."""
    turns = np.zeros(len(NAMES))
    for side, sign in SIDES.items():
        for bone in ("upperarm", "lowerarm", "hand"):
            turns[NAMES.index(f"{side}.{bone}")] = sign * ARM_SPREAD
        for bone in ("upperleg", "lowerleg"):
            turns[NAMES.index(f"{side}.{bone}")] = sign * LEG_SPREAD
    c, s, zero, one = np.cos(turns), np.sin(turns), np.zeros_like(turns), np.ones_like(turns)
    return np.stack(
        [np.stack([c, -s, zero], -1), np.stack([s, c, zero], -1), np.stack([zero, zero, one], -1)], axis=1
    )


def inverse_bind() -> Array:
    """Inverse bind matrices (J, 4, 4), row-major."""
    rotation, place = bind_rotation(), rest_translation()
    for joint, parent in enumerate(PARENT):
        if parent >= 0:
            place[joint] = place[parent] + rotation[parent] @ place[joint]
    inverse = np.tile(np.eye(4), (len(NAMES), 1, 1))
    inverse[:, :3, :3] = np.swapaxes(rotation, 1, 2)
    inverse[:, :3, 3] = -np.einsum("jba,jb->ja", rotation, place)
    return inverse
