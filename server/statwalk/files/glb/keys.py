"""Keys that do not matter: of values at every tick, those that are needed to come back within a bound (KF1: key frames, not frames)."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths import quat
from statwalk.maths.arrays import Bools, Floats


class Keys(NamedTuple):
    """The ticks (K,) that are kept, and what holds between them."""

    ticks: NDArray[np.intp]
    interpolation: Literal["STEP", "LINEAR"]


def needed(values: Floats, tolerance: Floats, *, turns: bool = False) -> list[Keys]:
    """For each of C channels of values (T,C,n) the keys that bring all of them back within `tolerance` (C,).

    LINEAR keys, or STEP ones where those are fewer (they bring the values back exactly). A channel that stays within the bound of its
    first value has that one key. `turns`: unit quaternions, interpolated as glTF says (slerp), their error an angle in radians.
    """
    kept = linear(values, tolerance, turns)
    changed = np.ones(values.shape[:2], bool)
    changed[1:] = (values[1:] != values[:-1]).any(axis=-1)
    still = distance(values, values[:1], turns).max(axis=0) <= tolerance
    return [choice(kept[:, column], changed[:, column], bool(still[column])) for column in range(values.shape[1])]


def every_key(count: int) -> Keys:
    """All of so many ticks."""
    return Keys(np.arange(count), "LINEAR" if count > 1 else "STEP")


def restored(values: Floats, keys: Keys, *, turns: bool) -> Floats:
    """The values (T,n) of a channel as the keys that were kept of them bring them back."""
    place = np.searchsorted(keys.ticks, np.arange(len(values)), "right") - 1
    before = keys.ticks[place]
    if keys.interpolation == "STEP":
        return values[before]
    after = keys.ticks[np.minimum(place + 1, len(keys.ticks) - 1)]
    return between(values[before], values[after], (np.arange(len(values)) - before) / np.maximum(after - before, 1), turns=turns)


def between(start: Floats, end: Floats, part: Floats, *, turns: bool) -> Floats:
    """The values (…,n) at `part` 0…1 of the way, float64: straight, or along the shorter arc (glTF 2.0, appendix C)."""
    first, last = start.astype(np.float64), end.astype(np.float64)
    return quat.slerp(first, last, part) if turns else first + (last - first) * part[..., None]


def choice(kept: Bools, changed: Bools, still: bool) -> Keys:
    """The smaller of the two sets of ticks (T,)."""
    if still:
        return Keys(np.zeros(1, np.intp), "STEP")
    if np.count_nonzero(changed) < np.count_nonzero(kept):
        return Keys(np.flatnonzero(changed), "STEP")
    return Keys(np.flatnonzero(kept), "LINEAR")


def linear(values: Floats, tolerance: Floats, turns: bool) -> Bools:
    """(T,C) the keys between which straight lines stay within the bound: each piece is cut at its worst tick until it does."""
    count, channels = values.shape[:2]
    kept = np.zeros((count, channels), bool)
    kept[0] = kept[-1] = True
    active = np.arange(channels)
    while len(active):
        error = errors(values[:, active], kept[:, active], turns) / tolerance[active]
        bad = error > 1
        kept[:, active] |= bad & (error == worst(error, kept[:, active]))
        active = active[bad.any(axis=0)]
    return kept


def errors(values: Floats, kept: Bools, turns: bool) -> Floats:
    """(T,C) how far lines between the kept keys are from the values."""
    count, channels = kept.shape
    tick, column = np.arange(count)[:, None], np.arange(channels)
    before = np.maximum.accumulate(np.where(kept, tick, 0), axis=0)
    after = np.minimum.accumulate(np.where(kept, tick, count - 1)[::-1], axis=0)[::-1]
    part = (tick - before) / np.maximum(after - before, 1)
    line = between(values[before, column], values[after, column], part, turns=turns)
    return distance(line, values, turns)


def distance(left: Floats, right: Floats, turns: bool) -> Floats:
    """How far values (…,n) are apart: the largest difference of a component, or the angle of a turn (its chord, for they are small)."""
    if not turns:
        return np.asarray(np.abs(left - right).max(axis=-1))
    nearest = np.minimum(((left - right) ** 2).sum(axis=-1), ((left + right) ** 2).sum(axis=-1))
    return np.asarray(2 * np.sqrt(nearest))


def worst(error: Floats, kept: Bools) -> Floats:
    """(T,C) for every tick the largest error in its piece, from a kept key up to the next."""
    flat, starts = error.T.ravel(), np.flatnonzero(kept.T.ravel())
    largest = np.maximum.reduceat(flat, starts)
    whole = np.repeat(largest, np.diff(np.append(starts, len(flat))))
    return np.asarray(whole.reshape(error.shape[::-1]).T)
