"""The trousers: a waist of one ring that parts into two legs at the crotch, hems, and a belt."""

import numpy as np
from curves import Array
from mesh.figure import FRONT, HIP_AT, LEG_SIDE, LEG_WAY, SOLE_Y, Figure
from mesh.patches import Patch, cast, eased_onto, hemmed, net, outward
from mesh.surface import Indices, averaged, edges_of, project

RING, INNER = 24, 3
ALONG = (0.115, 0.165, 0.225, 0.29, 0.345, 0.39, 0.43, 0.47, 0.515, 0.575, 0.65, 0.72)
CROTCH = np.array([[0.0, 0.846, -0.052], [0.0, 0.826, -0.008], [0.0, 0.842, 0.040]])
BELT = (0.962, 0.999)


def _ring(figure: Figure, heights: Array, front: Array | float = 0.0) -> Array:
    turn = 2 * np.pi * np.arange(RING) / RING  # from the front over the left side
    way = np.stack([np.sin(turn), np.zeros(RING), np.cos(turn)], -1)
    origin = np.zeros((len(heights), RING, 3))
    origin[..., 1] = heights[:, None] + np.asarray(front) * np.cos(turn)
    return cast(figure.trousers, origin, way)


def make_trousers(figure: Figure) -> list[Patch]:
    """The trousers of a build, and the belt if the shirt is tucked in."""
    heights = np.array([0.990, 0.968, 0.945, 0.915, 0.885, 0.862])
    top = _ring(figure, heights)
    points = list(top.reshape(-1, 3)) + list(CROTCH)
    ring = np.arange(len(heights) * RING).reshape(-1, RING)
    inner = ring.size + np.arange(INNER)
    faces = [net(ring[::-1], closed=True)]
    left = np.concatenate([ring[-1, : RING // 2 + 1], inner])
    right = np.concatenate([ring[-1, RING // 2 :], ring[-1, :1], inner[::-1]])
    ends = []
    for loop, sign in ((left, 1.0), (right, -1.0)):
        legs = _leg(figure) * (sign, 1, 1)
        order = legs if sign > 0 else np.concatenate([legs[:, 12::-1], legs[:, :12:-1]], axis=1)
        index = np.concatenate(
            [loop[None], len(points) + np.arange(order[..., 0].size).reshape(order.shape[:2])]
        )
        points.extend(order.reshape(-1, 3))
        faces.append(net(index[::-1], closed=True))
        ends.append(index[-1])
    all_points, triangles = np.array(points), np.concatenate(faces)
    lowest = np.concatenate(ends)
    fixed = np.concatenate([ring[0], lowest, inner[1:2]])
    eased = eased_onto(figure.trousers, project(figure.trousers, all_points, 2), triangles, fixed, 4)
    eased[inner, 0] = 0.0
    eased = _drawn(eased, triangles)
    patch = Patch(eased, {"trousers": outward(eased, triangles, figure.trousers)})
    for end in ends:
        patch = hemmed(patch, end, 0.004, 0.03, "seam")
    return [patch, *([_belt(figure)] if figure.build.tucked else [])]


def _drawn(points: Array, faces: Indices) -> Array:
    """The cloth stretched between the legs, where a body would have a fold."""
    near = np.clip(1 - np.hypot(points[:, 0] / 0.095, (points[:, 1] - 0.858) / 0.085), 0, 1)[:, None]
    edges = edges_of(faces)
    for _ in range(20):
        points = points + np.minimum(1.5 * near, 0.8) * (averaged(points, edges) - points)
    return points


def _leg(figure: Figure) -> Array:
    """Rings (R, K, 3) of the left leg, from the front over the outside, down to the hem."""
    outer = np.linspace(-40, 220, RING // 2 + 1)
    turn = np.radians(np.concatenate([outer, [245, 270, 295]]))
    way = np.cos(turn)[:, None] * FRONT + np.sin(turn)[:, None] * LEG_SIDE
    end = (HIP_AT[1] - SOLE_Y - figure.build.ankle) / -LEG_WAY[1]
    along = np.tile(np.array([*ALONG, end])[:, None], len(turn))
    for columns, first in (((12, 0), 0.135), ((13, 14, 15), 0.152)):  # below the crotch
        along[:, columns] = np.maximum(
            along[:, columns], first + 0.5 * (along[:, columns] - along[0, columns])
        )
    rings = cast(figure.leg, HIP_AT + along[..., None] * LEG_WAY, way, 0.2)
    hem = rings[-1]  # level, a little lower over the heel
    low = hem[:, 1] - (SOLE_Y + figure.build.ankle) + 0.10 * (0.01 - hem[:, 2])
    rings[-1] = hem - low[:, None] * LEG_WAY / LEG_WAY[1]
    rings[..., 0] = np.maximum(rings[..., 0], 0.006)
    return np.asarray(rings)


def _belt(figure: Figure) -> Patch:
    """A band round the waist, with a buckle's place in front."""
    heights = np.array([BELT[0], BELT[0], (BELT[0] + BELT[1]) / 2, BELT[1], BELT[1]])
    rings = _ring(figure, heights)
    out = rings * (1, 0, 1) / np.linalg.norm(rings * (1, 0, 1), axis=-1, keepdims=True)
    rings += np.array([-0.004, 0.0055, 0.007, 0.0055, -0.004])[:, None, None] * out
    index = np.arange(rings[..., 0].size).reshape(rings.shape[:2])
    faces = net(index, closed=True).reshape(len(heights) - 1, RING, 2, 3)
    front = np.zeros(faces.shape[:2], bool)
    front[:, [0, -1]] = True
    paints = {"belt": faces[~front].reshape(-1, 3), "buckle": faces[front].reshape(-1, 3)}
    return Patch(rings.reshape(-1, 3), paints)
