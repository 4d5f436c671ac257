"""Kernels that cannot be kept on the disk are compiled all the same."""

import numpy as np
from statwalk.maths.kernels import compiling

SOURCE = "def double(numbers):\n    for row in range(numbers.shape[0]):\n        numbers[row] *= 2\n"


def test_a_kernel_without_a_file_works():
    place = {}
    exec(SOURCE, place)
    numbers = np.array([1, 2], np.float32)
    compiling.kernel(compiling.write(compiling.FLOAT, 1))(place["double"])(numbers)
    assert numbers.tolist() == [2, 4]


def test_sums_of_products_are_not_fused_behind_ones_back():
    source = "def product(a, out):\n    out[0] = a[0] * a[1] + a[2]\n"
    place = {}
    exec(source, place)
    a = np.array([1 + 2**-12, 1 + 2**-12, -1 - 2**-11], np.float32)
    out = np.empty(1, np.float32)
    compiling.kernel(compiling.read(compiling.FLOAT, 1), compiling.write(compiling.FLOAT, 1))(place["product"])(a, out)
    assert out[0] == 0  # the product is rounded before the sum; fused it would be 2**-24
