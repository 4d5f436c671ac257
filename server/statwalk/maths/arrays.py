"""Names for the kinds of arrays; shapes and units stand in the docstring of whoever takes them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.floating[Any]]
Ints = NDArray[np.integer[Any]]
Bools = NDArray[np.bool_]


def floats(values: ArrayLike) -> Floats:
    """The values as an array of floats: float32 and float64 stay what they are, all else becomes float64."""
    array = np.asarray(values)
    return array if array.dtype.kind == "f" else array.astype(np.float64)
