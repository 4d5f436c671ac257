"""Vectors (…, 3): products and lengths, written out element by element so that one actor and a thousand get
the same bits.

The order of a NumPy reduction may depend on the memory layout; the order of these sums is fixed.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats

_YZX = np.array([1, 2, 0])


def dot(a: Floats, b: Floats) -> Floats:
    """Returns a · b over the last axis of length 3 -> (…)."""
    products = a * b
    return products[..., 0] + products[..., 1] + products[..., 2]


def cross(a: Floats, b: Floats) -> Floats:
    """Returns a × b, (…, 3)."""
    return (a * b.take(_YZX, -1) - a.take(_YZX, -1) * b).take(_YZX, -1)


def length(a: Floats) -> Floats:
    """Returns |a| over the last axis -> (…)."""
    return np.sqrt(dot(a, a))


def unit(a: Floats) -> Floats:
    """Returns a / |a|; a zero vector stays zero."""
    size = length(a)[..., None]
    return a / np.where(size > 0, size, 1)


def perpendicular(a: Floats) -> Floats:
    """Returns a unit vector at right angles to the unit vector `a`: a × the axis along which `a` is
    smallest.
    """
    least = np.abs(a).argmin(-1)[..., None] == np.arange(3)
    return unit(cross(a, least.astype(a.dtype)))
