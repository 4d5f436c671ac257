"""The value of one variable that makes a condition true: the nearest value, rounded if there is room."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from statwalk.maths.arrays import Bools, Floats

Truth = Callable[[Floats], Bools]
"""(n,) whether a condition is true at each of the values (n,)"""

GRID = 257
"""number of values that are tried over the range; a condition that is true only between two of them is not
seen
"""
HALVINGS = 60
FARTHEST = 1e6
"""distance from the present value up to which an endless range is searched"""


def nearest_true(is_true: Truth, now: float, low: float, high: float) -> float | None:
    """Returns the value in `low` … `high` nearest to `now` at which the condition is true; None if no tried
    value makes it true.
    """
    low, high = max(low, now - FARTHEST), min(high, now + FARTHEST)
    near = np.concatenate([sign * np.logspace(-6, 6, 97) for sign in (-1.0, 1.0)]) + now
    tried = np.unique(np.clip(np.concatenate([np.linspace(low, high, GRID), near, [now]]), low, high))
    true = tried[is_true(tried)]
    if not len(true):
        return None
    far = float(true[np.abs(true - now).argmin()])
    return far if far == now else _rounded(is_true, _bisected(is_true, now, far), far > now, (low, high))


def _bisected(is_true: Truth, false: float, true: float) -> float:
    """The first true value on the way from a false value to a true value."""
    for _ in range(HALVINGS):
        between = false + (true - false) / 2
        if is_true(np.array([between]))[0]:
            true = between
        else:
            false = between
    return true


def _rounded(is_true: Truth, first: float, up: bool, bounds: tuple[float, float]) -> float:
    """The first true value from `first` on, upwards or downwards, with no more digits than a hundredth of the
    range needs.
    """
    low, high = bounds
    digits = max(0, 2 - int(np.floor(np.log10(high - low))))
    for places in range(digits, 17):
        unit = 10.0**-places
        step = float(np.ceil(first / unit) if up else np.floor(first / unit))
        for value in (round(step * unit, places), round((step + (1 if up else -1)) * unit, places)):
            if low <= value <= high and is_true(np.array([value]))[0]:
                return value
    return first
