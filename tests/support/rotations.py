"""Hypothesis draws: vectors, unit vectors, unit quaternions (xyzw), sensible float64 numbers."""

import numpy as np
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy

NUMBERS = st.floats(-1e3, 1e3, allow_subnormal=False)
FRACTIONS = st.floats(0.0, 1.0, allow_subnormal=False)
ANGLES = st.floats(-3.1, 3.1, allow_subnormal=False)


def vectors(size: int = 3) -> SearchStrategy[np.ndarray]:
    return st.lists(st.floats(-10, 10, allow_subnormal=False), min_size=size, max_size=size).map(np.array)


def unit_vectors(size: int = 3) -> SearchStrategy[np.ndarray]:
    return vectors(size).filter(lambda v: np.linalg.norm(v) > 0.1).map(lambda v: v / np.linalg.norm(v))


def quaternions() -> SearchStrategy[np.ndarray]:
    return unit_vectors(4)


def same_rotation(a: np.ndarray, b: np.ndarray, tolerance: float = 1e-12) -> bool:
    """Whether two quaternions turn alike: they may differ in sign."""
    return bool(min(np.abs(a - b).max(), np.abs(a + b).max()) <= tolerance)
