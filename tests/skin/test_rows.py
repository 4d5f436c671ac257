import numpy as np
import pytest
from statwalk.skin import rows

UP = np.array([[0.0], [1], [0]], np.float32)


def matrix(linear):
    return np.concatenate([np.array(linear, np.float32), np.zeros((3, 1), np.float32)], axis=1).reshape(12, 1)


@pytest.mark.parametrize(
    ("linear", "expected"),
    [
        (np.diag([1, -1, 1]), [0, -1, 0]),
        (np.diag([-1, 1, 1]), [0, 1, 0]),
        (np.diag([1e-12, 1e-12, 1e-12]), [0, 1, 0]),
        (np.diag([1, 0, 1]), [0, 1, 0]),
        (np.zeros((3, 3)), [0, 1, 0]),
        ([[1, 1, 0], [0, 1, 0], [0, 0, 1]], [0, 1, 0]),
        ([[1, 0, 0], [1, 1, 0], [0, 0, 1]], [-np.sqrt(0.5), np.sqrt(0.5), 0]),
        ([[1, 0, 0], [0, 1, 0], [0, 1, 1]], [0, 1, 0]),
    ],
    ids=["mirrored along", "mirrored across", "tiny", "flattened", "vanished", "sheared along x", "sheared along y", "sheared along z"],
)
def test_normals_stay_unit_and_right(linear, expected):
    assert rows.normals(matrix(linear), UP)[:, 0] == pytest.approx(expected, abs=1e-6)


def test_a_vector_without_length_becomes_what_is_said_instead():
    assert rows.unit(np.zeros((3, 1)), np.zeros((3, 1)))[:, 0].tolist() == [0, 0, 1]
