"""Cubic NURBS over time, for keys at uneven times and with weights (FAQ Q17). KF6.

The parameter of the curve is the time in seconds, and the knots are the key times: a segment ends at each
key, and no second curve maps time to a parameter. Key k pulls the curve from two keys before it to two keys
after it, by its weight: R_k = w_k N_k / Σ w_i N_i. With even times and equal weights the curve is the uniform
B-spline of `curves`. The knots beyond the ends repeat the first and the last interval (a closed curve takes
the other end's intervals), and one more control at each end lets the curve begin and end at the end keys.

Rotations take the cumulative form of Kim, Kim and Shin (1995) with the rational basis:
q = q₀ · exp(ω₁ (R₁ + R₂ + R₃)) · exp(ω₂ (R₂ + R₃)) · exp(ω₃ R₃), where ωᵢ turns control i−1 to control i.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.tridiagonal import solve

_ROUNDS = 60
_LARGEST_MISS = 1e-9


class Segments(NamedTuple):
    """K segments of a curve, one from each key; the last one is a point, f = 0."""

    controls: Floats
    """(K, 4, n) the controls of each segment"""
    basis: Floats
    """(K, 4, 4) for each control the coefficients of w_i N_i(f) = c0 + c1 f + c2 f² + c3 f³"""


def knots(times: Floats, closed: bool = False) -> Floats:
    """Returns the knots (K+6,) of a curve with keys at `times` (K,): three more at each end."""
    gaps = np.diff(times) if len(times) > 1 else np.ones(1)
    before = gaps[np.arange(-3, 0) % len(gaps)] if closed else gaps[:1].repeat(3)
    after = gaps[np.arange(3) % len(gaps)] if closed else gaps[-1:].repeat(3)
    return np.concatenate([times[0] - before[::-1].cumsum()[::-1], times, times[-1] + after.cumsum()])


def basis(all_knots: Floats) -> Floats:
    """Returns (K, 4, 4): the coefficients of 1, f, f², f³ of the four basis functions of each segment (Piegl
    and Tiller, The NURBS Book, algorithm A2.2, on polynomials).
    """
    first, count = 3, len(all_knots) - 6
    at = np.arange(count) + first
    start, length = all_knots[at], all_knots[at + 1] - all_knots[at]
    functions: list[Floats] = [np.zeros((count, 4))]
    functions[0][:, 0] = 1
    for degree in range(1, 4):
        saved: Floats = np.zeros((count, 4))
        raised: list[Floats] = []
        for r in range(degree):
            low, high = all_knots[at + 1 - degree + r], all_knots[at + 1 + r]
            part = functions[r] / (high - low)[:, None]
            raised.append(saved + _times_line(part, high - start, -length))
            saved = _times_line(part, start - low, length)
        functions = [*raised, saved]
    return np.stack(functions, 1)


def _times_line(polynomial: Floats, constant: Floats, slope: Floats) -> Floats:
    """A polynomial (K, 4) in f times constant + slope · f."""
    product = polynomial * constant[:, None]
    product[:, 1:] += polynomial[:, :-1] * slope[:, None]
    return product


def near(times: Floats, keys: Floats, weights: Floats, closed: bool = False) -> Segments:
    """Returns the curve near keys (K, n) at `times` (K,) with `weights` (K,) > 0.

    Closed: the last key is the first key again, or the first key one lap further on.
    """
    return _Curve(times, weights, closed, is_turn=False).segments(keys)


def through(times: Floats, keys: Floats, weights: Floats, closed: bool = False) -> Segments:
    """Returns the curve that passes through each key (K, n) at its time; the weights say how sharply it bends
    there. With equal weights it is the natural (or periodic) cubic spline.

    :raises ContentError: when no curve passes through the keys.
    """
    return _Curve(times, weights, closed, is_turn=False).segments_through(keys)


def rotations_near(times: Floats, keys: Floats, weights: Floats, closed: bool = False) -> Segments:
    """Returns `near` for unit quaternions (K, 4)."""
    return _Curve(times, weights, closed, is_turn=True).segments(keys)


def rotations_through(times: Floats, keys: Floats, weights: Floats, closed: bool = False) -> Segments:
    """Returns `through` for unit quaternions (K, 4).

    :raises ContentError: when no curve passes through the keys.
    """
    return _Curve(times, weights, closed, is_turn=True).segments_through(keys)


class _Curve:
    """What the times and weights of keys say about a curve, before their values."""

    def __init__(self, times: Floats, weights: Floats, closed: bool, is_turn: bool) -> None:
        self.closed, self.is_turn = closed, is_turn
        plain = basis(knots(times, closed))
        at_first, at_last = plain[0, :, 0], plain[-1, :, 0]
        self.reach = at_first[2] / at_first[0], at_last[0] / at_last[2]
        """how far the extra controls lie beyond the ends, in steps from the first key to the second"""
        last = weights[-2:-1] if len(weights) > 1 else weights
        extended = np.concatenate(
            [last, weights, weights[1:2]] if closed else [weights[1:2], weights, last, last[:0]]
        )
        self.basis = plain * _windows(extended)[..., None]
        at_key = self.basis[:, :3, 0]
        self.rows = at_key / at_key.sum(1)[:, None]
        """(K, 3) the shares of the neighbouring controls at each key"""

    def controls(self, keys: Floats) -> Floats:
        """The controls (K+2, n) that `keys` give."""
        if self.is_turn:
            if self.closed:
                return np.concatenate([keys[-2:-1], keys, keys[1:2]])
            before, after = (_turned(keys[a], keys[b], reach) for a, b, reach in self._ends())
            return np.concatenate([before, keys, after])
        if self.closed:
            lap = keys[-1:] - keys[:1]
            return np.concatenate([keys[-2:-1] - lap, keys, keys[1:2] + lap])
        before, after = (keys[a] + reach * (keys[a] - keys[b]) for a, b, reach in self._ends())
        return np.concatenate([before, keys, after])

    def _ends(self) -> tuple[tuple[slice, slice, float], tuple[slice, slice, float]]:
        first, last = self.reach
        return (slice(0, 1), slice(1, 2), first), (slice(-1, None), slice(-2, -1), last)

    def segments(self, keys: Floats) -> Segments:
        return Segments(_windows(self.controls(keys)), self.basis)

    def segments_through(self, keys: Floats) -> Segments:
        inner = keys
        limit = _LARGEST_MISS * max(1.0, float(np.abs(keys).max()))
        for _ in range(_ROUNDS):
            miss = self._miss(inner, keys)
            largest = float(np.abs(miss).max())
            if largest <= limit * 1e-3 or not np.isfinite(largest):
                break
            inner = self._moved(inner, self._correction(miss))
        if not np.abs(self._miss(inner, keys)).max() <= limit:
            raise ContentError(
                "a NURBS curve cannot pass through these keys: neighbouring rotations should differ by at "
                "most 60 degrees, and weights and times less from key to key; add keys"
            )
        return self.segments(inner)

    def _miss(self, inner: Floats, wanted: Floats) -> Floats:
        """(K, n) from the curve to the keys at their times; rotation vectors for rotations."""
        windows, shares = _windows(self.controls(inner))[:, :3], self.rows
        if not self.is_turn:
            return np.asarray(wanted - (windows * shares[..., None]).sum(1))
        turns = quat.to_rotation_vector(quat.mul(quat.conjugate(windows[:, :-1]), windows[:, 1:]))
        first = quat.from_rotation_vector(turns[:, 0] * (shares[:, 1] + shares[:, 2])[:, None])
        second = quat.from_rotation_vector(turns[:, 1] * shares[:, 2, None])
        shown = quat.mul(quat.mul(windows[:, 0], first), second)
        return quat.to_rotation_vector(quat.mul(quat.conjugate(shown), wanted))

    def _correction(self, miss: Floats) -> Floats:
        """(K, n) how the controls must move so that the curve moves by `miss`, for small rotations."""
        rows = self.rows.copy()
        if self.closed:
            inner = solve(rows[:-1], miss[:-1])
            return np.concatenate([inner, inner[:1]])
        rows[0], rows[-1] = (0, 1, 0), (0, 1, 0)
        return solve(rows, miss)

    def _moved(self, inner: Floats, correction: Floats) -> Floats:
        if not self.is_turn:
            return inner + correction
        return quat.normalize(quat.mul(inner, quat.from_rotation_vector(correction)))


def _turned(end: Floats, neighbour: Floats, reach: float) -> Floats:
    """The rotation beyond an end: the turn from its neighbour to it goes on, times `reach`."""
    turn = quat.to_rotation_vector(quat.mul(quat.conjugate(neighbour), end))
    return quat.mul(end, quat.from_rotation_vector(turn * reach))


def _windows(controls: Floats) -> Floats:
    """(K, 4, …) the four controls of each segment; the last segment's fourth has no effect."""
    fourth = np.concatenate([controls[3:], controls[-1:]])
    return np.stack([controls[:-2], controls[1:-1], controls[2:], fourth], 1)
