"""Removes keys that are not needed: of the values at every tick it keeps the keys that restore them within a
tolerance (KF1: key frames, not frames).
"""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths import quat
from statwalk.maths.arrays import Bools, Floats


class Keys(NamedTuple):
    """The ticks (K,) of the kept keys, and the interpolation between them."""

    ticks: NDArray[np.intp]
    interpolation: Literal["STEP", "LINEAR"]


def reduce_keys(values: Floats, tolerance: Floats, *, turns: bool = False) -> list[Keys]:
    """Returns for each of C channels of values (T,C,n) the keys that restore all values within `tolerance`
    (C,).

    The keys are LINEAR, or STEP if fewer STEP keys are needed (STEP keys restore the values exactly). A
    channel that stays within the tolerance of its first value has only that key. With `turns` the values are
    unit quaternions, interpolated as in glTF (slerp), and their error is an angle in radians.
    """
    kept = linear(values, tolerance, turns)
    changed = np.ones(values.shape[:2], bool)
    changed[1:] = (values[1:] != values[:-1]).any(axis=-1)
    still = distance(values, values[:1], turns).max(axis=0) <= tolerance
    return [
        _choice(kept[:, column], changed[:, column], bool(still[column])) for column in range(values.shape[1])
    ]


def every_key(count: int) -> Keys:
    """Returns keys at all of `count` ticks."""
    return Keys(np.arange(count), "LINEAR" if count > 1 else "STEP")


def restored(values: Floats, keys: Keys, *, turns: bool) -> Floats:
    """Returns the values (T,n) of a channel as its kept keys restore them."""
    row = np.searchsorted(keys.ticks, np.arange(len(values)), "right") - 1
    before = keys.ticks[row]
    if keys.interpolation == "STEP":
        return values[before]
    after = keys.ticks[np.minimum(row + 1, len(keys.ticks) - 1)]
    return between(
        values[before],
        values[after],
        (np.arange(len(values)) - before) / np.maximum(after - before, 1),
        turns=turns,
    )


def between(start: Floats, end: Floats, fraction: Floats, *, turns: bool) -> Floats:
    """Returns the values (…,n) at `fraction` 0…1 of the way, float64: straight, or along the shorter arc
    (glTF 2.0, appendix C).
    """
    first, last = start.astype(np.float64), end.astype(np.float64)
    return quat.slerp(first, last, fraction) if turns else first + (last - first) * fraction[..., None]


def _choice(kept: Bools, changed: Bools, still: bool) -> Keys:
    """Returns the smaller of the two sets of ticks (T,)."""
    if still:
        return Keys(np.zeros(1, np.intp), "STEP")
    if np.count_nonzero(changed) < np.count_nonzero(kept):
        return Keys(np.flatnonzero(changed), "STEP")
    return Keys(np.flatnonzero(kept), "LINEAR")


def linear(values: Floats, tolerance: Floats, turns: bool) -> Bools:
    """Returns (T,C): the keys between which straight lines stay within the tolerance. Each piece is split at
    its worst tick until its lines do.
    """
    count, channels = values.shape[:2]
    kept = np.zeros((count, channels), bool)
    kept[0] = kept[-1] = True
    active = np.arange(channels)
    while len(active):
        error = errors(values[:, active], kept[:, active], turns) / tolerance[active]
        too_far = error > 1
        kept[:, active] |= too_far & (error == _worst(error, kept[:, active]))
        active = active[too_far.any(axis=0)]
    return kept


def errors(values: Floats, kept: Bools, turns: bool) -> Floats:
    """Returns (T,C): the distance of the lines between the kept keys from the values."""
    count, channels = kept.shape
    tick, column = np.arange(count)[:, None], np.arange(channels)
    before = np.maximum.accumulate(np.where(kept, tick, 0), axis=0)
    after = np.minimum.accumulate(np.where(kept, tick, count - 1)[::-1], axis=0)[::-1]
    fraction = (tick - before) / np.maximum(after - before, 1)
    interpolated = between(values[before, column], values[after, column], fraction, turns=turns)
    return distance(interpolated, values, turns)


def distance(left: Floats, right: Floats, turns: bool) -> Floats:
    """Returns the distance of values (…,n): the largest difference of a component, or the angle of a rotation
    (its chord, because angles are small).
    """
    if not turns:
        return np.asarray(np.abs(left - right).max(axis=-1))
    nearest = np.minimum(((left - right) ** 2).sum(axis=-1), ((left + right) ** 2).sum(axis=-1))
    return np.asarray(2 * np.sqrt(nearest))


def _worst(error: Floats, kept: Bools) -> Floats:
    """Returns (T,C): for every tick the largest error of its piece, from a kept key up to the next."""
    flat_error, starts = error.T.ravel(), np.flatnonzero(kept.T.ravel())
    largest = np.maximum.reduceat(flat_error, starts)
    error_of_tick = np.repeat(largest, np.diff(np.append(starts, len(flat_error))))
    return np.asarray(error_of_tick.reshape(error.shape[::-1]).T)
