"""Converts keys to segments: one row of float32 numbers for each key, complete until the next key.

`pack` makes the rows (S, m) of channels of one kind. Their meaning, for the fraction f of the time to the
next key (0…1, and 0 in the last row):

    HOLD         P0                                   STEP: the value of the key passed last
    LINE         P0, P1 − P0                          LINEAR: P0 + f·(P1 − P0). KF3
    ARC          Q0, Q1                               LINEAR on rotations: slerp along the shorter arc. KF4;
                 glTF appendix C.4
    CUBIC        c0, c1, c2, c3                       CUBICSPLINE (glTF appendix C.5) and B-splines: c0 + c1 f
                 + c2 f² + c3 f³
    CUBIC_TURN   the same                             CUBICSPLINE on rotations: the cubic of the components,
                 normalised
    SPLINE_TURN  Q0, the turns to three others        the cumulative quaternion B-spline. KF5
    RATIONAL     c0 … c3, d0 … d3                     NURBS: one cubic divided by another. KF6
    RATIONAL_TURN  Q0, three turns, d0 … d3, and      the cumulative quaternion NURBS: each turn times its
                 c0 … c3 of each turn                 cubic divided by d. KF6
"""

from __future__ import annotations

import numpy as np

from statwalk.maths import curves, nurbs, quat
from statwalk.maths.arrays import Floats
from statwalk.motion.keys import _kernels
from statwalk.motion.keys.key_set import KeySet
from statwalk.motion.keys.segment_kinds import (
    ARC,
    CUBIC,
    CUBIC_TURN,
    HOLD,
    LINE,
    RATIONAL,
    RATIONAL_TURN,
    SPLINE_TURN,
)


def pack(key_set: KeySet, loop: bool) -> tuple[int, Floats]:
    """Returns the kind of the segments of a key set's channels, and their rows (S, m) float32, one channel
    after the other.
    """
    if key_set.interpolation == "STEP":
        return HOLD, _turns(key_set).astype(np.float32)
    if key_set.interpolation == "LINEAR":
        return _straight(key_set)
    ends = zip(key_set.starts, key_set.ends, key_set.timing, strict=True)
    rows = [_rows(key_set, first, last, key_set.times[timing], loop) for first, last, timing in ends]
    return KINDS[key_set.interpolation, key_set.path == "rotation"], np.concatenate(rows).astype(np.float32)


def _turns(key_set: KeySet) -> Floats:
    """The values (S, n), rotations at unit length (float64)."""
    return quat.normalize(key_set.values.astype(np.float64)) if key_set.path == "rotation" else key_set.values


def _straight(key_set: KeySet) -> tuple[int, Floats]:
    """LINEAR: each key and the difference to the next key; the last key of a channel is its own follower."""
    is_turn, values = key_set.path == "rotation", key_set.values
    if values.dtype != np.float32:
        return (ARC, _arcs(key_set)) if is_turn else (LINE, _lines(key_set))
    rows = np.empty((len(values), 2 * values.shape[1]), np.float32)
    pack_rows = _kernels.turns if is_turn else _kernels.lines
    pack_rows(np.require(values, requirements=["C", "A"]), np.asarray(key_set.ends, np.int64), rows)
    return (ARC if is_turn else LINE), rows


def _arcs(key_set: KeySet) -> Floats:
    values, last = _turns(key_set), key_set.ends - 1
    rows = np.empty((len(values), 8), np.float32)
    rows[:, :4] = values
    rows[:-1, 4:] = values[1:]
    rows[
        np.flatnonzero(quat.dot(values[:-1], values[1:]) < 0), 4:
    ] *= -1  # the same rotation, on the nearer side
    rows[last, 4:] = rows[last, :4]
    return rows


def _lines(key_set: KeySet) -> Floats:
    values, last = key_set.values, key_set.ends - 1
    width = values.shape[1]
    rows = np.empty((len(values), 2 * width), np.float32)
    rows[:, :width] = values
    rows[:-1, width:] = values[1:] - values[:-1]
    rows[last, width:] = 0
    return rows


def _rows(key_set: KeySet, first: int, last: int, key_times: Floats, loop: bool) -> Floats:
    """The rows (K, m) of one channel of splines, from the keys first…last."""
    times, values = key_times.astype(np.float64), key_set.values[first:last].astype(np.float64)
    if key_set.interpolation == "CUBICSPLINE":
        return _hermite(times, values)
    is_turn, through = key_set.path == "rotation", key_set.interpolation.endswith("THROUGH")
    # A closed curve continues into the next lap: its ends meet, or it is root motion, whose next lap starts
    # where this one ends.
    closed = loop and (key_set.path == "translation" or bool((values[0] == values[-1]).all()))
    if key_set.key_weights is not None:
        weights = key_set.key_weights[first:last].astype(np.float64)
        return _rational(times, values, weights, closed and bool(weights[0] == weights[-1]), is_turn, through)
    return (
        _turn_windows(quat.normalize(values), through, closed)
        if is_turn
        else _bspline(values, through, closed)
    )


def _next(values: Floats) -> Floats:
    """The values of the following key; the last key is its own follower."""
    return np.concatenate([values[1:], values[-1:]])


def _hermite(times: Floats, values: Floats) -> Floats:
    """Coefficients (K, 4n) of glTF's Hermite spline; tangents are per second, so they are multiplied by the
    seconds between the keys.
    """
    length = np.append(np.diff(times), 0.0)[:, None]
    start, end = values[:, 1], _next(values[:, 1])
    leave, arrive = values[:, 2] * length, _next(values[:, 0]) * length
    return np.concatenate(
        [start, leave, 3 * (end - start) - 2 * leave - arrive, 2 * (start - end) + leave + arrive], -1
    )


def _bspline(values: Floats, through: bool, closed: bool) -> Floats:
    """Coefficients (K, 4n) of the uniform cubic B-spline near the keys, or through them. KF5."""
    controls = (curves.bspline_through if through else curves.ends)(values, closed)
    p0, p1, p2, p3 = _windows(controls)
    return np.concatenate(
        [(p0 + 4 * p1 + p2) / 6, (p2 - p0) / 2, (p0 - 2 * p1 + p2) / 2, (p3 - p0 + 3 * (p1 - p2)) / 6], -1
    )


def _turn_windows(values: Floats, through: bool, closed: bool) -> Floats:
    """The first control quaternion of each segment, and the three turns to the others (K, 4 + 9)."""
    controls = (curves.rotations_through if through else curves.rotation_ends)(values, closed)
    windows = np.stack(_windows(controls), 1)
    return np.concatenate([windows[:, 0], curves.turns_between(windows).reshape(len(windows), 9)], -1)


def _rational(
    times: Floats, values: Floats, weights: Floats, closed: bool, is_turn: bool, through: bool
) -> Floats:
    """The rows (K, m) of a NURBS curve."""
    if is_turn:
        curve = nurbs.rotations_through if through else nurbs.rotations_near
        segments = curve(times, quat.normalize(values), weights, closed)
        turns = curves.turns_between(segments.controls).reshape(-1, 9)
        later = segments.basis[:, ::-1].cumsum(1)[:, ::-1]  # all four, the last three, two, one
        return np.concatenate([segments.controls[:, 0], turns, later.reshape(-1, 16)], -1)
    segments = (nurbs.through if through else nurbs.near)(times, values, weights, closed)
    above = (segments.basis[..., None] * segments.controls[:, :, None]).sum(1)
    below = segments.basis.sum(1)[..., None].repeat(values.shape[-1], -1)
    return np.concatenate([above, below], 1).reshape(len(values), -1)


def _windows(controls: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """The four controls (K, n) of each of K segments; in the last segment, where f stays 0, the fourth has no
    effect.
    """
    return controls[:-2], controls[1:-1], controls[2:], np.concatenate([controls[3:], controls[-1:]])


KINDS = {
    ("CUBICSPLINE", False): CUBIC,
    ("CUBICSPLINE", True): CUBIC_TURN,
    ("BSPLINE", False): CUBIC,
    ("BSPLINE", True): SPLINE_TURN,
    ("BSPLINE_THROUGH", False): CUBIC,
    ("BSPLINE_THROUGH", True): SPLINE_TURN,
    ("NURBS", False): RATIONAL,
    ("NURBS", True): RATIONAL_TURN,
    ("NURBS_THROUGH", False): RATIONAL,
    ("NURBS_THROUGH", True): RATIONAL_TURN,
}
"""by interpolation and whether the channel is a rotation"""
