import numpy as np
from statwalk.maths.simd import aligned


def test_memory_starts_on_a_cache_line():
    assert [aligned.zeros(count).ctypes.data % 64 for count in (1, 5, 16, 1000)] == [0] * 4


def test_a_copy_is_flat_and_its_own():
    values = np.arange(6, dtype=np.float32).reshape(2, 3)
    copied = aligned.copy(values)
    copied[0] = 9
    assert (copied.tolist(), values[0, 0]) == ([9, 1, 2, 3, 4, 5], 0)
