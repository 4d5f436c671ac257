"""Memory aligned to a cache line: vectors of 16 floats are then never split over two lines."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

CACHE_LINE = 64


def zeros(count: int) -> NDArray[np.float32]:
    """Returns `count` float32 zeros, the first at a multiple of 64 bytes."""
    room = np.zeros(count * 4 + CACHE_LINE, np.uint8)
    start = -room.ctypes.data % CACHE_LINE
    return room[start : start + count * 4].view(np.float32)


def copy(values: NDArray[np.float32]) -> NDArray[np.float32]:
    """Returns a flat, aligned copy of the values."""
    out = zeros(values.size)
    out[:] = values.reshape(-1)
    return out


def of(values: Any, dtype: np.dtype[Any]) -> NDArray[Any]:
    """Returns an aligned, contiguous copy of the values (…), converted to `dtype`."""
    source = np.asarray(values)
    room = np.zeros(source.size * dtype.itemsize + CACHE_LINE, np.uint8)
    start = -room.ctypes.data % CACHE_LINE
    copied: NDArray[Any] = room[start : start + len(room) - CACHE_LINE].view(dtype).reshape(source.shape)
    copied[...] = source
    return copied
