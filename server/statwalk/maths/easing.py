"""Easing: maps a fraction of time 0…1 to a fraction of the way 0…1 (slow in and slow out, FAQ Q1).

Arguments outside 0…1 are clamped.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths.arrays import Floats, floats


def _clamp01(f: ArrayLike) -> Floats:
    return np.minimum(np.maximum(floats(f), 0), 1)


def linear(f: ArrayLike) -> Floats:
    """Returns f: even speed."""
    return _clamp01(f)


def smoothstep(f: ArrayLike) -> Floats:
    """Returns 3f² − 2f³: starts and ends at rest."""
    x = _clamp01(f)
    return x * x * (3 - 2 * x)


def smootherstep(f: ArrayLike) -> Floats:
    """Returns 6f⁵ − 15f⁴ + 10f³: starts and ends at rest and without force (Perlin)."""
    x = _clamp01(f)
    return x * x * x * (x * (x * 6 - 15) + 10)


def _ease_in(f: ArrayLike) -> Floats:
    """f³: slow at first."""
    x = _clamp01(f)
    return x * x * x


def _ease_out(f: ArrayLike) -> Floats:
    """1 − (1−f)³: slow at last."""
    rest = 1 - _clamp01(f)
    return 1 - rest * rest * rest


def _ease_in_out(f: ArrayLike) -> Floats:
    """Slow at both ends, each half a cubic."""
    x = _clamp01(f)
    rest = 1 - x
    return np.where(x < 0.5, 4 * x * x * x, 1 - 4 * rest * rest * rest)


EASINGS: Mapping[str, Callable[[ArrayLike], Floats]] = MappingProxyType(
    {
        "linear": linear,
        "smoothstep": smoothstep,
        "smootherstep": smootherstep,
        "ease-in": _ease_in,
        "ease-out": _ease_out,
        "ease-in-out": _ease_in_out,
    }
)
