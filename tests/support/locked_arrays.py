"""Immutable things hold no array that can be written."""

import numpy as np
import pytest


def check(record):
    """Every array of a dataclass, also in its NamedTuples, refuses to be written."""
    values = [value if isinstance(value, tuple) else (value,) for value in vars(record).values()]
    arrays = [array for value in values for array in value if isinstance(array, np.ndarray)]
    assert arrays
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0
