"""Curves through and near keys (FAQ Q17), over any leading axes; float32 and float64 stay.

KF5, KF7.

A B-spline segment has four controls and runs between the two in the middle, f = 0…1. `ends` adds the missing
controls of a clip's first and last segment; `bspline_through` and `rotations_through` find controls whose
curve passes through the keys.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from statwalk.errors import ContentError
from statwalk.maths import quat
from statwalk.maths.arrays import Floats

# The error of the controls at least halves in each round (the curve's matrix has eigenvalues 1/3…1): 56
# rounds reach float64.
_ROUNDS = 56
_STEP = 1.5
_LARGEST_MISS = 1e-9


def step(a: Floats, b: Floats, f: ArrayLike) -> Floats:
    """Returns `a` before f = ½ and `b` from f = ½ on (…, n); f (…). RTCA Listing 2, KF7."""
    return np.where(np.asarray(f)[..., None] < 0.5, a, b)


def bspline_basis(f: ArrayLike, dtype: np.typing.DTypeLike = np.float64) -> Floats:
    """Returns the weights (…, 4) of four controls of a uniform cubic B-spline at f (…) in 0…1; they
    sum to 1.
    """
    part = np.asarray(f, dtype)
    rest, square, cube = 1 - part, part * part, part * part * part
    return (
        np.stack([rest * rest * rest, 3 * cube - 6 * square + 4, 3 * (part + square - cube) + 1, cube], -1)
        / 6
    )


def ends(keys: Floats, loop: bool = False) -> Floats:
    """Returns controls (K+2, …, n) for K keys (K, …, n): one more at each end, so that the curve begins and
    ends at the end keys.

    With `loop` the curve continues smoothly into the next lap: the last key is the first key again (a cycle
    whose duration is its last key), or the first key one lap further on (the root motion of a walk).
    """
    if loop:
        lap = keys[-1:] - keys[:1]
        return np.concatenate([keys[-2:-1] - lap, keys, keys[1:2] + lap])
    return np.concatenate([2 * keys[:1] - keys[1:2], keys, 2 * keys[-1:] - keys[-2:-1]])


def bspline_through(keys: Floats, loop: bool = False) -> Floats:
    """Returns controls (K+2, …, n) of the uniform cubic B-spline through K keys (K, …, n)."""
    wanted = keys.astype(np.float64)
    inner: Floats = wanted
    for _ in range(_ROUNDS):
        controls = ends(inner, loop)
        inner = inner + _STEP * (wanted - (controls[:-2] + 4 * controls[1:-1] + controls[2:]) / 6)
    return ends(inner, loop).astype(keys.dtype)


def bspline_rotation(controls: Floats, f: ArrayLike) -> Floats:
    """Returns the rotation (…, 4) at f (…) of the cumulative B-spline with control quaternions (…, 4, 4)
    (Kim, Kim and Shin 1995).
    """
    return bspline_turn(controls[..., 0, :], turns_between(controls), f)


def turns_between(controls: Floats) -> Floats:
    """Returns the rotation vectors (…, 3, 3) from each of four control quaternions (…, 4, 4) to the next."""
    return quat.to_rotation_vector(quat.mul(quat.conjugate(controls[..., :-1, :]), controls[..., 1:, :]))


def bspline_turn(start: Floats, turns: Floats, f: ArrayLike) -> Floats:
    """Returns `bspline_rotation` from the first control (…, 4) and the precomputed `turns_between` the four
    (…, 3, 3).
    """
    weights = bspline_basis(f, start.dtype)
    third = weights[..., 3]
    second = third + weights[..., 2]
    first = second + weights[..., 1]
    steps = quat.from_rotation_vector(turns * np.stack([first, second, third], -1)[..., None])
    rotation = quat.mul(quat.mul(quat.mul(start, steps[..., 0, :]), steps[..., 1, :]), steps[..., 2, :])
    return quat.normalize(rotation)


def rotation_ends(keys: Floats, loop: bool = False) -> Floats:
    """Returns `ends` for quaternions (K, …, 4): the turns of the first and last segment continue."""
    if loop:
        return np.concatenate([keys[-2:-1], keys, keys[1:2]])
    first = quat.mul(keys[:1], quat.mul(quat.conjugate(keys[1:2]), keys[:1]))
    last = quat.mul(keys[-1:], quat.mul(quat.conjugate(keys[-2:-1]), keys[-1:]))
    return np.concatenate([first, keys, last])


def rotations_through(keys: Floats, loop: bool = False) -> Floats:
    """Returns controls (K+2, …, 4) of the cumulative B-spline through K quaternions (K, …, 4), found by
    iteration.

    Controls swing up to three times as far as their keys and no further than half a turn, so neighbouring
    keys may differ by 60° (more if they do not swing to and fro).

    :raises ContentError: when the curve cannot pass through the keys.
    """
    wanted = keys.astype(np.float64)
    inner: Floats = wanted
    for _ in range(_ROUNDS):
        inner = quat.normalize(quat.mul(inner, quat.from_rotation_vector(_STEP * _miss(inner, wanted, loop))))
    if np.abs(_miss(inner, wanted, loop)).max(initial=0) > _LARGEST_MISS:
        raise ContentError(
            "a B-spline cannot pass through these rotations: neighbouring keys should differ by at most 60 "
            "degrees; add keys"
        )
    return rotation_ends(inner, loop).astype(keys.dtype)


def _miss(inner: Floats, wanted: Floats, loop: bool) -> Floats:
    """The rotation vectors (K, …, 3) from the curve of the controls to the keys."""
    return quat.to_rotation_vector(
        quat.mul(quat.conjugate(_rotation_at_keys(rotation_ends(inner, loop))), wanted)
    )


def _rotation_at_keys(controls: Floats) -> Floats:
    """The rotations of the B-spline with `controls` (K+2, …, 4) at its K keys: f = 0, where the last control
    has no effect.
    """
    windows = np.stack([controls[:-2], controls[1:-1], controls[2:], controls[2:]], -2)
    return bspline_rotation(windows, np.zeros(windows.shape[:-2]))
