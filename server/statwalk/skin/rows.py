"""Vectors at unit length and finite numbers, for all input values."""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats

SMALLEST_SQUARE, LARGEST_SQUARE = 1e-30, 1e30


def unit(vectors: Floats, otherwise: Floats) -> Floats:
    """Returns vectors (3,V) at unit length; a vector without length becomes the unit vector along `otherwise`
    or, if that has none either, +Z.
    """
    squared = vectors[0] * vectors[0] + vectors[1] * vectors[1] + vectors[2] * vectors[2]
    good = (squared > SMALLEST_SQUARE) & (squared < LARGEST_SQUARE)
    if good.all():
        return np.asarray(vectors / np.sqrt(squared))
    out = np.where(good, vectors / np.sqrt(np.where(good, squared, 1)), 0)
    out[:, ~good] = _repaired(vectors[:, ~good], np.broadcast_to(otherwise, vectors.shape)[:, ~good])
    return out


def _repaired(vectors: Floats, otherwise: Floats) -> Floats:
    """The slow path of `unit`: scales each vector first, so that tiny and huge vectors keep their
    direction.
    """
    whole = np.where(_largest(vectors) > 0, vectors, otherwise)
    size = _largest(whole)
    whole = np.where(size > 0, whole / np.where(size > 0, size, 1), np.array([[0], [0], [1]], vectors.dtype))
    return np.asarray(
        whole / np.sqrt(whole[0] * whole[0] + whole[1] * whole[1] + whole[2] * whole[2]), vectors.dtype
    )


def _largest(vectors: Floats) -> Floats:
    """(V,) the size of each vector's largest component; 0 if a component is not finite."""
    sizes = np.abs(vectors).max(axis=0)
    return np.where(np.isfinite(sizes), sizes, 0)


def finite(values: Floats) -> Floats:
    """Returns the values; an overflow becomes the largest finite number, as neither JSON nor glTF has
    infinity.
    """
    return values if np.isfinite(values).all() else np.nan_to_num(values)
