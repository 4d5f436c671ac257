"""Eyes with iris and pupil, brows and ears."""

import numpy as np
from mesh.face import EYE_AT, MIDDLE, MOUTH_Y, Face
from mesh.patches import Patch, both_sides, cast, fan, net
from mesh.surface import gradient
from skeleton import SIDES

AROUND = 16
RINGS = ((11.5, "pupil"), (24.0, "iris"), (28.0, "rim"), (48.0, "white"), (72.0, "white"), (100.0, "white"))
"""degrees from the line of sight, and what lies within"""
EAR_AT = np.array([0.0785, 1.634, -0.014])


def make_eyes(face: Face) -> list[Patch]:
    """Eyes, brows, ears, nostrils and teeth."""
    left = [_eye(face), _brow(face), _ear(), _nostril(face)]
    both = [side for patch in left for side in both_sides(patch)]
    return [*both, _glint(face, "Left"), _glint(face, "Right"), _teeth(face)]


def _eye(face: Face) -> Patch:
    turn = 2 * np.pi * np.arange(AROUND) / AROUND
    around = np.stack([np.cos(turn), np.sin(turn), np.zeros(AROUND)], -1)
    points, faces, count = [np.array([[0.0, 0.0, 1.0]])], {"pupil": np.zeros((0, 3), int)}, 1
    before = None
    for degrees, paint in RINGS:
        angle = np.radians(degrees)
        points.append(np.sin(angle) * around + (0.0, 0.0, np.cos(angle)))
        ring = count + np.arange(AROUND)
        made = fan(ring, 0) if before is None else net(np.stack([ring, before]), closed=True)
        faces[paint] = np.concatenate([faces.get(paint, np.zeros((0, 3), int)), made])
        before, count = ring, count + AROUND
    ball = EYE_AT + face.eye * np.concatenate(points)
    return Patch(ball, faces, {"Left.eye": np.ones(len(ball))})


def _glint(face: Face, side: str) -> Patch:
    """The light that an eye reflects, on the same side of both."""
    turn = 2 * np.pi * np.arange(8) / 8
    middle = np.array([-0.20, 0.24])
    flat = middle + 0.085 * np.stack([np.cos(turn), np.sin(turn)], -1)
    flat = np.concatenate([flat, middle[None]])
    ball = np.concatenate([flat, np.sqrt(1 - (flat**2).sum(1, keepdims=True))], axis=1)
    points = EYE_AT * (SIDES[side], 1, 1) + 1.005 * face.eye * ball
    return Patch(points, {"glint": fan(np.arange(8), 8)}, {f"{side}.eye": np.ones(9)})


def _brow(face: Face) -> Patch:
    """A flat tube over the eye, thinner to its outer end."""
    f = np.linspace(0, 1, 7)
    x = 0.0150 + 0.0440 * f
    y = EYE_AT[1] + 0.0265 + 0.0065 * np.sin(np.pi * (0.15 + 0.75 * f)) - 0.004 * f**3
    origin = np.stack([x, y, np.full(7, 0.02)], -1)
    middle = cast(face.skin, origin, np.array([0.0, 0.0, 1.0]), 0.14)
    high = face.build.brow * np.array([0.0036, 0.0046, 0.0047, 0.0044, 0.0038, 0.0028, 0.0012])
    turn = 2 * np.pi * np.arange(6) / 6
    rings = middle[:, None] + np.stack(
        [
            0.35 * 0.0024 * np.outer(np.ones(7), np.cos(turn)),
            np.outer(high, np.sin(turn)),
            0.0026 * np.outer(np.ones(7), np.cos(turn)),
        ],
        -1,
    )
    index = np.arange(42).reshape(7, 6)
    points = np.concatenate([rings.reshape(-1, 3), middle[[0, -1]]])
    faces = np.concatenate([net(index, closed=True), fan(index[0], 42)[:, ::-1], fan(index[-1], 43)])
    return Patch(points, {"brow": faces[:, ::-1]})


def _ear() -> Patch:
    """A shell: its back, its edge, and two hollows."""
    turn = 2 * np.pi * np.arange(14) / 14
    up, back = (np.sign(part) * np.abs(part) ** 0.8 for part in (np.cos(turn), np.sin(turn)))
    wide = 0.0160 * back * (1 + 0.26 * up) - 0.003 * up
    shape = np.stack([0.029 * up * np.where(up < 0, 0.9, 1.0), wide], -1)  # up, and back
    rings = []
    for out, size in (
        (-0.012, 0.62),
        (0.004, 0.90),
        (0.0105, 1.0),
        (0.0100, 0.84),
        (0.0050, 0.66),
        (0.0010, 0.36),
    ):
        up, back = (size * shape).T
        x = EAR_AT[0] + out + 0.24 * np.maximum(back + 0.012, -0.01) * (out > -0.01)
        rings.append(np.stack([x, EAR_AT[1] + up, EAR_AT[2] - back], -1))
    index = np.arange(len(rings) * 14).reshape(-1, 14)
    points = np.concatenate([*rings, rings[-1].mean(0, keepdims=True) - (0.001, 0, 0)])
    faces = np.concatenate([net(index, closed=True), fan(index[-1], len(points) - 1)])
    return Patch(points, {"skin": faces})


def _nostril(face: Face) -> Patch:
    """A small dark spot under the nose."""
    turn = 2 * np.pi * np.arange(8) / 8
    way = np.array([0.0068 * face.build.nose, 1.5990, 0.1085]) - MIDDLE
    middle = cast(face.skin, MIDDLE, way, 0.2)
    normal = gradient(face.skin, middle[None])[0]
    normal /= np.linalg.norm(normal)
    right = np.cross((0.0, 0.3, 1.0), normal)
    right /= np.linalg.norm(right)
    ahead = np.cross(normal, right)
    spot = middle + np.outer(0.0026 * np.cos(turn), right) + np.outer(0.0034 * np.sin(turn), ahead)
    slope = gradient(face.skin, spot)
    spot = spot - slope * (face.skin(spot) / (slope**2).sum(1))[:, None] + 0.0005 * normal
    faces = fan(np.arange(8), 8)
    return Patch(np.concatenate([spot, (middle + 0.0006 * normal)[None]]), {"lash": faces})


def _teeth(face: Face) -> Patch:
    """The upper teeth behind the lips."""
    turn = np.linspace(-1, 1, 9)
    front = cast(face.skin, np.array([0.0, MOUTH_Y, 0.02]), np.array([0.0, 0.0, 1.0]), 0.14)[2]
    flat = np.stack([0.0185 * np.sin(1.2 * turn), np.zeros(9), front - 0.0085 - 0.012 * turn**2], -1)
    low, high = np.array([0, MOUTH_Y + 0.0012, 0]), np.array([0, MOUTH_Y + 0.0100, -0.0008])
    rows = np.stack([flat + low, flat + high])
    return Patch(rows.reshape(-1, 3), {"white": net(np.arange(18).reshape(2, 9))})
