import numpy as np
import pytest
from statwalk.skin.weights import normalised, used_where_normalised

JOINTS = np.array([[3, 1, 2, 0]] * 3)


def test_sums_become_one_and_the_vertices_that_were_off_are_counted():
    _, weights, off = normalised(
        JOINTS, np.array([[0.1, 0.2, 0.1, 0], [0.5, 0.5, 0, 0], [3, 1, 0, 0]], np.float32)
    )
    assert weights.sum(axis=1) == pytest.approx([1, 1, 1])
    assert off == 2


def test_the_largest_influence_comes_first_and_empty_columns_go():
    joints, weights, _ = normalised(JOINTS, np.array([[0.25, 0.75, 0, 0]] * 3, np.float32))
    assert joints.tolist() == [[1, 3]] * 3
    assert weights.tolist() == [[0.75, 0.25]] * 3


def test_a_vertex_without_weights_follows_its_first_joint():
    joints, weights, off = normalised(JOINTS[:1], np.zeros((1, 4), np.float32))
    assert (joints.tolist(), weights.tolist(), off) == ([[3]], [[1]], 1)


def test_the_error_of_eight_bits_is_not_reported():
    assert normalised(JOINTS[:1], np.array([[128, 127, 0.3, 0]], np.float32) / 255)[2] == 0


@pytest.mark.parametrize(
    ("row", "used"),
    [
        ([1, 0, 0, 0], 1),
        ([0.5, 0.5, 0, 0], 2),
        ([0.4, 0.3, 0.3, 0], 3),
        ([0.25, 0.25, 0.25, 0.25], 4),
        ([0.5, 0, 0.5, 0], 0),
        ([1.5, -0.5, 0, 0], 0),
        ([0.5, 0.4, 0, 0], 0),
        ([1.25, 0, 0, -0.25], 0),
        ([np.nan, 0, 0, 0], 0),
    ],
)
@pytest.mark.parametrize("after", [0, 30])
def test_weights_that_are_right_already(row, used, after):
    right = [[1, 0, 0, 0]]
    assert used_where_normalised(np.float32([*right * 5, row, *right * after])) == used
