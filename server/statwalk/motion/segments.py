"""From keys to segments: one row of float32 numbers for each key, with all that is needed until the next key.

A kind of segment is a pair: `pack_*` makes the rows (K, m) of a channel once, `evaluate` turns gathered rows (…, m) and the
fractions (…,) of the way to the next key into values (…, n). Fractions run 0…1 and are 0 in the last row, which has no next key.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from statwalk.maths import curves, quat
from statwalk.maths.arrays import Floats
from statwalk.motion.channel import Channel

Evaluate = Callable[[Floats, Floats], Floats]


def hold(rows: Floats, fractions: Floats) -> Floats:  # noqa: ARG001 - every kind of segment is called alike
    """STEP: the value of the key passed last."""
    return rows


def line(rows: Floats, fractions: Floats) -> Floats:
    """LINEAR: P0 + f·(P1 − P0). KF3."""
    width = rows.shape[-1] // 2
    return rows[..., :width] + rows[..., width:] * fractions[..., None]


def arc(rows: Floats, fractions: Floats) -> Floats:
    """LINEAR on rotations: slerp along the shorter arc. KF4; glTF appendix C.4."""
    return quat.slerp(rows[..., :4], rows[..., 4:], fractions)


def cubic(rows: Floats, fractions: Floats) -> Floats:
    """A cubic by its four coefficients, Horner's rule: CUBICSPLINE (glTF appendix C.5) and B-splines."""
    width = rows.shape[-1] // 4
    f = fractions[..., None]
    c0, c1, c2, c3 = (rows[..., i * width : (i + 1) * width] for i in range(4))
    return c0 + (c1 + (c2 + c3 * f) * f) * f


def cubic_turn(rows: Floats, fractions: Floats) -> Floats:
    """CUBICSPLINE on rotations: the cubic of the components, normalised (glTF appendix C.5)."""
    return quat.normalize(cubic(rows, fractions))


def spline_turn(rows: Floats, fractions: Floats) -> Floats:
    """B-splines on rotations: the cumulative quaternion B-spline. KF5."""
    return curves.bspline_turn(rows[..., :4], rows[..., 4:].reshape(*rows.shape[:-1], 3, 3), fractions)


def pack(channel: Channel, closed: bool) -> tuple[Evaluate, Floats]:
    """How a channel's segments are evaluated, and its rows (K, m) float32. `closed`: it loops, and its ends meet."""
    evaluate, rows = _pack(channel, closed)
    return evaluate, rows.astype(np.float32)


def _pack(channel: Channel, closed: bool) -> tuple[Evaluate, Floats]:
    values: Floats = channel.values.astype(np.float64)
    is_turn = channel.path == "rotation"
    if channel.interpolation == "CUBICSPLINE":
        return (cubic_turn if is_turn else cubic), _hermite(channel.times.astype(np.float64), values)
    if is_turn:
        values = quat.normalize(values)
    through = channel.interpolation == "BSPLINE_THROUGH"
    return (spline_turn, _turn_windows(values, through, closed)) if is_turn else (cubic, _bspline(values, through, closed))


def pack_straight(channels: Sequence[Channel]) -> tuple[Evaluate, Floats]:
    """The same for channels of one path, all STEP or all LINEAR: the rows (S, m) of all of them at once, one channel after the other."""
    values: Floats = np.concatenate([channel.values for channel in channels]).astype(np.float64)
    is_turn = channels[0].path == "rotation"
    if is_turn:
        values = quat.normalize(values)
    if channels[0].interpolation == "STEP":
        return hold, values.astype(np.float32)
    following = _next(values)
    last = np.cumsum([len(channel.times) for channel in channels]) - 1
    following[last] = values[last]  # the last key of each channel is its own follower
    if is_turn:
        return arc, np.concatenate([values, quat.align(values, following)], -1).astype(np.float32)
    return line, np.concatenate([values, following - values], -1).astype(np.float32)


def _next(values: Floats) -> Floats:
    """The following key's values; the last key is its own follower."""
    return np.concatenate([values[1:], values[-1:]])


def _hermite(times: Floats, values: Floats) -> Floats:
    """Coefficients (K, 4n) of glTF's Hermite spline; tangents are per second, so they are scaled by the time between the keys."""
    length = np.append(np.diff(times), 0.0)[:, None]
    start, end = values[:, 1], _next(values[:, 1])
    leave, arrive = values[:, 2] * length, _next(values[:, 0]) * length
    return np.concatenate([start, leave, 3 * (end - start) - 2 * leave - arrive, 2 * (start - end) + leave + arrive], -1)


def _bspline(values: Floats, through: bool, closed: bool) -> Floats:
    """Coefficients (K, 4n) of the uniform cubic B-spline near the keys, or through them. KF5."""
    controls = (curves.bspline_through if through else curves.ends)(values, closed)
    p0, p1, p2, p3 = _windows(controls)
    return np.concatenate([(p0 + 4 * p1 + p2) / 6, (p2 - p0) / 2, (p0 - 2 * p1 + p2) / 2, (p3 - p0 + 3 * (p1 - p2)) / 6], -1)


def _turn_windows(values: Floats, through: bool, closed: bool) -> Floats:
    """The first control quaternion of each segment, and the three turns to the others (K, 4 + 9)."""
    controls = (curves.rotations_through if through else curves.rotation_ends)(values, closed)
    windows = np.stack(_windows(controls), 1)
    return np.concatenate([windows[:, 0], curves.turns_between(windows).reshape(len(windows), 9)], -1)


def _windows(controls: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """The four controls (K, n) of each of K segments; in the last one, where f stays 0, the fourth has no say."""
    return controls[:-2], controls[1:-1], controls[2:], np.concatenate([controls[3:], controls[-1:]])
