"""Loops of the face round eyes and mouth, from what lies inside outwards; lids and lips move with their
joints.
"""

from itertools import pairwise

import numpy as np
from curves import Array
from mesh.face import EYE_AT, MOUTH_HALF, MOUTH_Y, Face
from mesh.patches import Net, cast, fan, net
from mesh.surface import Indices

LIDS, LIPS = 20, 22
OPEN_UP, OPEN_DOWN, OPEN_HALF = 0.0096, 0.0084, 0.0184
"""how far the lids are open above and below the middle of the eye, and to both sides"""
LID_LOOPS = ((0.95, 0.0004, 1.0), (1.0, 0.0017, 1.0), (1.10, 0.0020, 1.0), (1.32, 0.0024, 0.9))
"""size beside the opening, distance from the ball, and how much the lid moves them"""
LIP_LOOPS = (
    # half width, up, down
    (MOUTH_HALF - 0.0018, 0.0008, 0.0009),
    (MOUTH_HALF - 0.0005, 0.0036, 0.0046),
    (MOUTH_HALF + 0.0020, 0.0076, 0.0098),
    (MOUTH_HALF + 0.0080, 0.0140, 0.0165),
)


def _band(out: Net, paint: str, inner: Indices, outer: Indices, clockwise: bool) -> Indices:
    rows = np.stack([inner, outer] if clockwise else [outer, inner])
    faces = net(rows, closed=True)
    if paint:
        out.cover(paint, faces)
    return faces


def _ahead(face: Face, flat: Array) -> Array:
    """Points (K, 3) of the face at x and y."""
    origin = np.concatenate([flat, np.full((len(flat), 1), 0.02)], axis=1)
    return cast(face.skin, origin, np.array([0.0, 0.0, 1.0]), 0.14)


def _almond(up: float, down: float, half: float) -> Array:
    """A loop (K, 2) from the inner corner over the upper lid to the outer corner and back below."""
    turn = np.pi - 2 * np.pi * np.arange(LIDS) / LIDS
    x, y = np.cos(turn), np.sin(turn)
    x = np.sign(x) * np.abs(x) ** 0.9
    high = np.where(y > 0, up, down) * np.abs(y) ** 0.95 * np.sign(y)
    return np.stack([half * x, high + 0.0014 * x], -1)


def _on_ball(flat: Array, radius: float) -> Array:
    """Places before the eye's middle on a ball around it."""
    deep = np.sqrt(np.maximum(radius**2 - (flat**2).sum(1), (0.25 * radius) ** 2))
    return np.asarray(EYE_AT + np.concatenate([flat, deep[:, None]], axis=1))


def eye_loops(face: Face, out: Net, side: str) -> Indices:
    """Add the loops round an eye; returns the outermost."""
    s, flip = face.build.eye, np.array([1.0 if side == "Left" else -1.0, 1, 1])
    opening = np.array([OPEN_UP, OPEN_DOWN, OPEN_HALF]) * s
    rings = []
    for size, over, part in LID_LOOPS:
        grown = (
            opening * size if size <= 1.1 else opening + (size - 1) * s * np.array([0.013, 0.0085, 0.0085])
        )
        points = _on_ball(_almond(*grown), face.eye + over)
        rings.append(out.add(points * flip))
        out.give(f"{side}.lid", rings[-1], part * np.clip((points[:, 1] - EYE_AT[1]) / 0.004, 0, 1))
    for up, down, half, part in ((0.0172, 0.0142, 0.0238, 0.45), (0.0225, 0.0195, 0.0285, 0.0)):
        points = _ahead(face, EYE_AT[:2] + s * _almond(up, down, half))
        rings.append(out.add(points * flip))
        out.give(f"{side}.lid", rings[-1], part * np.clip((points[:, 1] - EYE_AT[1]) / 0.004, 0, 1))
    for number, (inner, outer) in enumerate(pairwise(rings)):
        faces = _band(out, "", inner, outer, side == "Left")
        high = np.array(out.points)[faces][..., 1].min(1) > EYE_AT[1] + 0.0022
        dark = high & (number < 2)
        out.cover("lash", faces[dark])
        out.cover("lids" if number == 0 else "skin", faces[~dark])
    return rings[-1]


def mouth_loops(face: Face, out: Net) -> Indices:
    """Add the mouth's inside and the loops of the lips; returns the outermost."""
    turn = 2 * np.pi * np.arange(LIPS) / LIPS  # from the left corner over the upper lip
    x, y = np.cos(turn), np.sin(turn)
    bow = 1 - 0.20 * np.exp(-((x / 0.16) ** 2))
    low = np.clip(0.5 - 0.5 * np.sign(np.round(y, 6)) * np.minimum(1.0, np.abs(y) * 1.3), 0, 1)
    loops = []
    for number, (half, up, down) in enumerate(LIP_LOOPS):
        size = face.build.lips if number in (1, 2) else 1.0
        high = np.where(y > 0, up * (bow if number in (1, 2) else 1.0), -down) * size
        high = high * np.abs(y) ** (1.15 if number < 3 else 0.9)
        loops.append(_ahead(face, np.stack([half * x, MOUTH_Y + high + 0.0032 * x**2 - 0.0010], -1)))
    loops[0][:, 2] -= 0.0026 * np.abs(y) ** 0.5
    wide = loops[0] + np.stack(
        [0 * x, 0.004 * np.sign(np.round(y, 6)) * np.abs(y), np.full(LIPS, -0.009)], -1
    )
    deep = wide.mean(0) + 0.8 * (wide - wide.mean(0)) - (0.0, 0.0, 0.022)
    rings = [out.add(points) for points in (deep, wide, *loops)]
    back = out.add(deep.mean(0)[None])
    out.cover("mouth", fan(rings[0], int(back[0])))
    for ring, part in zip(rings, (0.6, 1.0, 1.0, 1.0, 1.0, 1.0), strict=True):
        out.give("Jaw", ring, part * low)
    for paint, inner, outer in zip(
        ("mouth", "mouth", "lips", "lips", "skin"), rings, rings[1:], strict=False
    ):
        _band(out, paint, inner, outer, False)
    return rings[-1]
