"""The vertices that a muscle or a bulge names by their numbers."""

from __future__ import annotations

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths.arrays import Bools


def chosen_vertices(vertices: frozenset[int], count: int) -> Bools:
    """Returns (V,) whether each of `count` vertices is chosen.

    :raises ContentError: when a number is too large.
    """
    rows = np.array(sorted(vertices), np.int64)
    if len(rows) and rows[-1] >= count:
        raise ContentError(f"there is no vertex {rows[-1]}; the last is {count - 1}")
    return np.isin(np.arange(count), rows)
