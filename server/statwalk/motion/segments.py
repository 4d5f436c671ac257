"""From keys to segments: one row of float32 numbers for each key, with all that is needed until the next key.

A kind of segment is a pair: `pack` makes the rows (S, m) of channels alike once, `evaluate` turns gathered rows (…, m) and the
fractions (…,) of the way to the next key into values (…, n). Fractions run 0…1 and are 0 in the last row, which has no next key.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from statwalk.maths import curves, quat
from statwalk.maths.arrays import Floats
from statwalk.maths.kernels.choose import loaded
from statwalk.motion.bundle import Bundle

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


def pack(bundle: Bundle, loop: bool) -> tuple[Evaluate, Floats]:
    """How the segments of a bundle's channels are evaluated, and the rows (S, m) float32 of all of them, one channel after the other."""
    if bundle.interpolation == "STEP":
        return hold, _turns(bundle).astype(np.float32)
    if bundle.interpolation == "LINEAR":
        return _straight(bundle)
    ends = zip(bundle.starts, bundle.ends, bundle.timing, strict=True)
    parts = [(bundle.times[timing].astype(np.float64), bundle.values[first:last].astype(np.float64)) for first, last, timing in ends]
    rows = [_curve(bundle, times, values, loop) for times, values in parts]
    return EVALUATE[bundle.interpolation, bundle.path == "rotation"], np.concatenate(rows).astype(np.float32)


def _turns(bundle: Bundle) -> Floats:
    """The values (S, n), rotations at unit length (float64)."""
    return quat.normalize(bundle.values.astype(np.float64)) if bundle.path == "rotation" else bundle.values


def _straight(bundle: Bundle) -> tuple[Evaluate, Floats]:
    """LINEAR: each key and the way to the next one; the last key of a channel is its own follower."""
    is_turn, given = bundle.path == "rotation", bundle.values
    compiled = loaded()
    if compiled is None or given.dtype != np.float32:
        return (arc, _arcs(bundle)) if is_turn else (line, _lines(bundle))
    rows = np.empty((len(given), 2 * given.shape[1]), np.float32)
    pack_rows = compiled.turns if is_turn else compiled.lines
    pack_rows(np.require(given, requirements=["C", "A"]), np.asarray(bundle.ends, np.int64), rows)
    return (arc if is_turn else line), rows


def _arcs(bundle: Bundle) -> Floats:
    values, last = _turns(bundle), bundle.ends - 1
    rows = np.empty((len(values), 8), np.float32)
    rows[:, :4] = values
    rows[:-1, 4:] = values[1:]
    rows[np.flatnonzero(quat.dot(values[:-1], values[1:]) < 0), 4:] *= -1  # the same turn, on the nearer side
    rows[last, 4:] = rows[last, :4]
    return rows


def _lines(bundle: Bundle) -> Floats:
    values, last = bundle.values, bundle.ends - 1
    width = values.shape[1]
    rows = np.empty((len(values), 2 * width), np.float32)
    rows[:, :width] = values
    rows[:-1, width:] = values[1:] - values[:-1]
    rows[last, width:] = 0
    return rows


def _curve(bundle: Bundle, times: Floats, values: Floats, loop: bool) -> Floats:
    """The rows (K, m) of one channel of splines, from its times and values (float64)."""
    if bundle.interpolation == "CUBICSPLINE":
        return _hermite(times, values)
    is_turn, through = bundle.path == "rotation", bundle.interpolation == "BSPLINE_THROUGH"
    # The next lap goes on where this one ends: the ends meet, or it is a way whose next lap starts there (root motion).
    closed = loop and (bundle.path == "translation" or bool((values[0] == values[-1]).all()))
    return _turn_windows(quat.normalize(values), through, closed) if is_turn else _bspline(values, through, closed)


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


EVALUATE: dict[tuple[str, bool], Evaluate] = {
    ("CUBICSPLINE", False): cubic,
    ("CUBICSPLINE", True): cubic_turn,
    ("BSPLINE", False): cubic,
    ("BSPLINE", True): spline_turn,
    ("BSPLINE_THROUGH", False): cubic,
    ("BSPLINE_THROUGH", True): spline_turn,
}
"""by the kind of interpolation, and whether it is of rotations"""
