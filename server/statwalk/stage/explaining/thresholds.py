"""Which value of one number would make a condition true: the nearest one, and a round one where there is room."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from statwalk.maths.arrays import Bools, Floats

Truth = Callable[[Floats], Bools]
"""(n,) whether a condition is true at each of the values (n,)"""

GRID = 257
"""values that are tried over the range; a condition that is true only between two of them is not found"""
HALVINGS = 60
FARTHEST = 1e6
"""from the present value, where a range is endless"""


def nearest_true(is_true: Truth, now: float, low: float, high: float) -> float | None:
    """The value in `low` … `high` nearest to `now` at which the condition is true; None where it is nowhere seen to be."""
    low, high = max(low, now - FARTHEST), min(high, now + FARTHEST)
    near = np.concatenate([sign * np.logspace(-6, 6, 97) for sign in (-1.0, 1.0)]) + now
    tried = np.unique(np.clip(np.concatenate([np.linspace(low, high, GRID), near, [now]]), low, high))
    true = tried[is_true(tried)]
    if not len(true):
        return None
    far = float(true[np.abs(true - now).argmin()])
    return far if far == now else _rounded(is_true, _bisected(is_true, now, far), far > now, (low, high))


def _bisected(is_true: Truth, false: float, true: float) -> float:
    """The first true value on the way from a false one to a true one."""
    for _ in range(HALVINGS):
        between = false + (true - false) / 2
        if is_true(np.array([between]))[0]:
            true = between
        else:
            false = between
    return true


def _rounded(is_true: Truth, first: float, up: bool, bounds: tuple[float, float]) -> float:
    """The first true value from `first` on, upwards or downwards, that has no more digits than a hundredth of the range needs."""
    low, high = bounds
    digits = max(0, 2 - int(np.floor(np.log10(high - low))))
    for places in range(digits, 17):
        unit = 10.0**-places
        step = float(np.ceil(first / unit) if up else np.floor(first / unit))
        for value in (round(step * unit, places), round((step + (1 if up else -1)) * unit, places)):
            if low <= value <= high and is_true(np.array([value]))[0]:
                return value
    return first
