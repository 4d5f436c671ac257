"""Easing: how a share of time 0…1 becomes a share of the way 0…1 (slow in and slow out, FAQ Q1). Arguments beyond are held at the ends."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths.arrays import Floats, floats


def clamp01(f: ArrayLike) -> Floats:
    """f held between 0 and 1."""
    return np.minimum(np.maximum(floats(f), 0), 1)


def linear(f: ArrayLike) -> Floats:
    """Even speed."""
    return clamp01(f)


def smoothstep(f: ArrayLike) -> Floats:
    """3f² − 2f³: starts and ends at rest."""
    x = clamp01(f)
    return x * x * (3 - 2 * x)


def smootherstep(f: ArrayLike) -> Floats:
    """6f⁵ − 15f⁴ + 10f³: starts and ends at rest and without force (Perlin)."""
    x = clamp01(f)
    return x * x * x * (x * (x * 6 - 15) + 10)


def ease_in(f: ArrayLike) -> Floats:
    """f³: slow at first."""
    x = clamp01(f)
    return x * x * x


def ease_out(f: ArrayLike) -> Floats:
    """1 − (1−f)³: slow at last."""
    rest = 1 - clamp01(f)
    return 1 - rest * rest * rest


def ease_in_out(f: ArrayLike) -> Floats:
    """Slow at both ends, each half a cubic."""
    x = clamp01(f)
    rest = 1 - x
    return np.where(x < 0.5, 4 * x * x * x, 1 - 4 * rest * rest * rest)


EASINGS: Mapping[str, Callable[[ArrayLike], Floats]] = MappingProxyType(
    {
        "linear": linear,
        "smoothstep": smoothstep,
        "smootherstep": smootherstep,
        "ease-in": ease_in,
        "ease-out": ease_out,
        "ease-in-out": ease_in_out,
    }
)
