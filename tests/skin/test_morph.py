import numpy as np
import pytest
from statwalk.skin.morph import inbetween


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize(("fraction", "expected"), [(0, 2), (0.25, 3), (1, 6)])
def test_inbetweening_runs_forwards(fraction, expected, kind):
    start, end = np.full((2, 3), 2.0, kind), np.full((2, 3), 6.0, kind)
    assert inbetween(start, end, fraction).tolist() == [[expected] * 3] * 2


def test_meshes_of_different_lengths_are_refused():
    with pytest.raises(ValueError):
        inbetween(np.zeros(100, np.float32), np.zeros(50, np.float32), 0.5)


def test_meshes_out_of_order_are_inbetweened_too():
    start, end = np.zeros((3, 20), np.float32).T, np.ones((20, 3), np.float32)
    out = np.empty((20, 3), np.float32)
    assert inbetween(start, end, 0.5, out) is out
    assert out.tolist() == [[0.5] * 3] * 20
