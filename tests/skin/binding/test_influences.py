"""The four strongest influences."""

import numpy as np
from statwalk.skin.binding.influences import strongest


def test_the_four_largest_of_six_sum_to_one() -> None:
    joints, weights = strongest(np.array([[0.05, 0.3, 0.1, 0.25, 0.2, 0.1]]))
    assert joints.tolist() == [[1, 3, 4, 2]]
    np.testing.assert_allclose(weights, np.array([[0.3, 0.25, 0.2, 0.1]]) / 0.85, rtol=1e-6)


def test_what_hardly_counts_is_left_out() -> None:
    joints, weights = strongest(np.array([[1.0, 1e-5], [0.0, 0.0]]))
    assert joints.tolist() == [[0, 0, 0, 0], [0, 0, 0, 0]]
    assert weights.tolist() == [[1, 0, 0, 0], [1, 0, 0, 0]]
