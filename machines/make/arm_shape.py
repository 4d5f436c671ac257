"""The shape of an arm, stretched along +X with the palm upwards: rings around the bones, with muscles."""

import numpy as np
from shapes import Array

UPPER, FORE = 0.3, 0.26
"""metres: from the shoulder to the elbow, and to the wrist"""
TABLE = np.array(
    [
        # along, middle (up), half height, half depth: centimetres
        (0.0, 0.0, 5.8, 5.5),
        (5.0, 0.3, 6.0, 5.7),
        (10.0, 0.0, 5.4, 5.1),
        (16.0, -0.2, 4.9, 4.6),
        (22.0, -0.3, 4.5, 4.3),
        (26.5, -0.3, 4.0, 4.2),
        (30.0, -0.2, 3.9, 4.4),
        (33.0, -0.1, 4.1, 4.8),
        (37.0, 0.0, 4.1, 4.9),
        (43.0, 0.1, 3.5, 4.2),
        (49.0, 0.0, 2.7, 3.2),
        (54.0, -0.05, 2.0, 2.5),
        (57.5, 0.1, 1.55, 2.3),
    ]
)
BUMPS = (
    # along, angle (0 front, 90 up), width along, width around: centimetres and degrees; height: centimetres
    (16.5, 80.0, 5.0, 42.0, 0.9),  # biceps
    (12.0, -95.0, 5.5, 40.0, 0.9),  # triceps
    (4.0, 60.0, 4.5, 60.0, 0.6),  # deltoid
    (35.0, 40.0, 5.0, 35.0, 0.55),  # brachioradialis
    (36.0, 150.0, 5.0, 40.0, 0.45),  # flexors
    (30.3, -90.0, 1.6, 30.0, 0.5),  # the tip of the elbow
    (17.0, 12.0, 7.0, 18.0, -0.5),  # the grooves between biceps and triceps
    (17.0, 168.0, 7.0, 18.0, -0.5),
    (28.5, 90.0, 2.5, 35.0, -0.35),  # the bend of the elbow
)

FIST = np.array(
    [
        # from the wrist, middle (up), half height, half depth: centimetres
        (1.0, 0.1, 1.6, 2.35),
        (3.0, 0.5, 2.2, 3.0),
        (5.2, 1.1, 2.8, 3.6),
        (7.2, 1.5, 3.1, 3.8),
        (9.0, 1.6, 3.0, 3.7),
        (10.1, 1.6, 2.4, 3.1),
    ]
)
THUMB = np.array(
    [(3.4, 2.3, -2.9, 1.0), (4.8, 3.6, -2.7, 1.15), (6.4, 4.6, -1.6, 1.1), (7.6, 4.7, 0.0, 0.95)]
)
"""from the wrist, up, to the front, half width: centimetres"""


def rings(along: Array, around: int) -> Array:
    """Points (R, around, 3) metres at places `along` (R,) metres from the shoulder."""
    angle = np.arange(around) * 360.0 / around
    x = 100 * along[:, None]
    middle, height, depth = (np.interp(x, TABLE[:, 0], TABLE[:, column]) for column in (1, 2, 3))
    out = sum(
        high * np.exp(-(((x - place) / long) ** 2) - ((_turned(angle - at) / wide) ** 2))
        for place, at, long, wide, high in BUMPS
    )
    up, front = np.sin(np.radians(angle)), np.cos(np.radians(angle))
    y, z = middle + (height + out) * up, (depth + out) * front
    return 0.01 * np.stack([np.broadcast_to(x, y.shape), y, z], -1)


def _turned(degrees: Array) -> Array:
    """Angles within ±180 degrees."""
    return np.asarray((degrees + 180) % 360 - 180)


def step(x: Array, at: float, soft: float) -> Array:
    """0 before and 1 after `at`, smooth within `soft`."""
    t = np.clip((x - at) / (2 * soft) + 0.5, 0, 1)
    return np.asarray(t * t * (3 - 2 * t))


def fist(along: Array, around: int) -> Array:
    """Points (R, around, 3) of a closed hand at places `along` (R,) metres from the wrist, from which they
    are measured.
    """
    angle = np.arange(around) * 2 * np.pi / around
    square = [np.sign(wave) * np.abs(wave) ** 0.75 for wave in (np.sin(angle), np.cos(angle))]
    x = 100 * along[:, None]
    middle, height, depth = (np.interp(x, FIST[:, 0], FIST[:, column]) for column in (1, 2, 3))
    return 0.01 * np.stack(
        [np.broadcast_to(x, (len(along), around)), middle + height * square[0], depth * square[1]], -1
    )


def thumb(steps: int, around: int) -> Array:
    """Points (steps, around, 3) of the thumb, across the fingers of the fist, metres from the wrist."""
    place = np.linspace(0, len(THUMB) - 1, steps)
    spine = np.stack([np.interp(place, np.arange(len(THUMB)), column) for column in THUMB.T], -1)
    way = np.gradient(spine[:, :3], axis=0)
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    side = np.cross(way, [0.0, 1.0, 0.0])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    up = np.cross(side, way)
    angle = np.arange(around) * 2 * np.pi / around
    out = np.cos(angle)[None, :, None] * side[:, None] + np.sin(angle)[None, :, None] * up[:, None]
    return np.asarray(0.01 * (spine[:, None, :3] + spine[:, None, 3:] * out))
