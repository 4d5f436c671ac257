"""Names for the types of arrays; shapes and units are in the docstring of the function that takes
the array.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.floating[Any]]
Ints = NDArray[np.integer[Any]]
Bools = NDArray[np.bool_]


def floats(values: ArrayLike) -> Floats:
    """Returns the values as an array of floats: float32 and float64 stay, all else becomes float64."""
    array = np.asarray(values)
    return array if array.dtype.kind == "f" else array.astype(np.float64)
