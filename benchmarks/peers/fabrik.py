"""FABRIK in NumPy over all chains, as a user of NumPy would write it, in float32: without limits the joints'
places alone; with round cones local rotations too, since a limit is one of a rotation.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]


def places_of_fabrik(offsets: Floats, targets: Floats, iterations: int) -> Floats:
    """Returns the joints' places (N, J, 3) of straight chains of bones (N, J, 3) after the iterations."""
    start, lengths = offsets.cumsum(1), np.linalg.norm(offsets, axis=-1)[..., None]
    places = start.copy()
    for _ in range(iterations):
        _pull_back(places, targets, lengths)
        places[:, 0] = start[:, 0]
        for joint in range(1, places.shape[1]):
            _pull(places, joint - 1, joint, lengths[:, joint])
    return places


def places_within_cones(offsets: Floats, targets: Floats, iterations: int, bend: float) -> Floats:
    """Returns the best places (N, J, 3) that the iterations find, if no joint twists about Y or swings by
    more than `bend` radians from its rest.
    """
    count, lengths = offsets.shape[1], np.linalg.norm(offsets, axis=-1)[..., None]
    local = np.zeros((count, len(offsets), 4), np.float32)
    local[..., 3] = 1
    places = offsets.cumsum(1)
    best, nearest = places.copy(), np.linalg.norm(places[:, -1] - targets, axis=-1)
    for _ in range(iterations):
        _pull_back(places, targets, lengths)
        above, at = np.broadcast_to(np.float32([0, 0, 0, 1]), (len(offsets), 4)), offsets[:, 0]
        for joint in range(count - 1):
            bone = offsets[:, joint + 1]
            wanted = _rotated(above * np.float32([-1, -1, -1, 1]), places[:, joint + 1] - at)
            turn = _between(_rotated(local[joint], bone), wanted)
            local[joint] = _within_cone(_product(turn, local[joint]), bend)
            above = _product(above, local[joint])
            places[:, joint] = at
            at = at + _rotated(above, bone)
        places[:, -1] = at
        distance = np.linalg.norm(at - targets, axis=-1)
        is_better = distance < nearest
        best[is_better], nearest = places[is_better], np.minimum(distance, nearest)
    return best


def _pull_back(places: Floats, targets: Floats, lengths: Floats) -> None:
    places[:, -1] = targets
    for joint in range(places.shape[1] - 2, -1, -1):
        _pull(places, joint + 1, joint, lengths[:, joint + 1])


def _pull(places: Floats, origin: int, joint: int, length: Floats) -> None:
    """Puts a joint at its bone's length from another."""
    way = places[:, joint] - places[:, origin]
    places[:, joint] = places[:, origin] + way * (length / np.sqrt(np.einsum("ni,ni->n", way, way))[:, None])


def _within_cone(q: Floats, bend: float) -> Floats:
    """The rotations (N, 4) with twist about Y, which comes first, and swing cut to `bend` radians."""
    sign = np.where(q[:, 3] < 0, np.float32(-1), np.float32(1))
    cosine = np.sqrt(q[:, 3] * q[:, 3] + q[:, 1] * q[:, 1])
    half_twist = np.arctan2(sign * q[:, 1], sign * q[:, 3])
    swing = np.stack([q[:, 0] * q[:, 3] + q[:, 2] * q[:, 1], q[:, 2] * q[:, 3] - q[:, 0] * q[:, 1]], -1)
    swing /= cosine[:, None]
    sine = np.sqrt(np.einsum("ni,ni->n", swing, swing))
    half_swing = np.minimum(np.arctan2(sine, cosine), np.float32(bend / 2))
    swing *= (np.sin(half_swing) / np.maximum(sine, np.float32(1e-12)))[:, None]
    half_twist = np.clip(half_twist, -bend / 2, bend / 2)
    turn, along = np.cos(half_swing), np.stack([np.cos(half_twist), np.sin(half_twist)], -1)
    x = swing[:, 0] * along[:, 0] - swing[:, 1] * along[:, 1]
    z = swing[:, 1] * along[:, 0] + swing[:, 0] * along[:, 1]
    return np.stack([x, turn * along[:, 1], z, turn * along[:, 0]], -1)


def _between(start: Floats, end: Floats) -> Floats:
    """The shortest turns (N, 4) from vectors to others."""
    size = np.sqrt(np.einsum("ni,ni->n", start, start) * np.einsum("ni,ni->n", end, end))
    real = size + np.einsum("ni,ni->n", start, end)
    turn = np.concatenate([_cross(start, end), real[:, None]], -1)
    return turn / np.sqrt(np.maximum(np.einsum("ni,ni->n", turn, turn), np.float32(1e-24)))[:, None]


def _cross(a: Floats, b: Floats) -> Floats:
    """np.cross takes three times as long."""
    return a[:, (1, 2, 0)] * b[:, (2, 0, 1)] - a[:, (2, 0, 1)] * b[:, (1, 2, 0)]


def _rotated(q: Floats, vector: Floats) -> Floats:
    twice = 2 * _cross(q[:, :3], vector)
    return vector + q[:, 3:] * twice + _cross(q[:, :3], twice)


def _product(a: Floats, b: Floats) -> Floats:
    vector = a[:, 3:] * b[:, :3] + b[:, 3:] * a[:, :3] + _cross(a[:, :3], b[:, :3])
    real = a[:, 3] * b[:, 3] - np.einsum("ni,ni->n", a[:, :3], b[:, :3])
    return np.concatenate([vector, real[:, None]], -1)
