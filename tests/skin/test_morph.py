import numpy as np
import pytest
from kernelsets import kernel_set  # noqa: F401 - a fixture
from statwalk.skin.morph import Morph, inbetween, morphed

BASE = np.zeros((3, 4), np.float32)
TARGETS = np.stack([np.ones((3, 2)), np.full((3, 2), 10)]).astype(np.float32)


def test_displacements_are_weighted_and_stay_in_their_span():
    moved = morphed(BASE, (Morph(slice(1, 3), 1, TARGETS),), np.array([9, 0.5, 0.25], np.float32))
    assert moved[0].tolist() == [0, 3, 3, 0]


def test_the_base_is_left_alone():
    morphed(BASE, (Morph(slice(0, 2), 0, TARGETS),), np.ones(2, np.float32))
    assert not BASE.any()


@pytest.mark.usefixtures("kernel_set")
@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize(("fraction", "expected"), [(0, 2), (0.25, 3), (1, 6)])
def test_inbetweening_runs_forwards(fraction, expected, kind):
    start, end = np.full((2, 3), 2.0, kind), np.full((2, 3), 6.0, kind)
    assert inbetween(start, end, fraction).tolist() == [[expected] * 3] * 2


@pytest.mark.usefixtures("kernel_set")
def test_meshes_of_different_lengths_are_refused():
    with pytest.raises(ValueError):
        inbetween(np.zeros(100, np.float32), np.zeros(50, np.float32), 0.5)


@pytest.mark.usefixtures("kernel_set")
def test_meshes_out_of_order_are_inbetweened_too():
    start, end = np.zeros((3, 20), np.float32).T, np.ones((20, 3), np.float32)
    out = np.empty((20, 3), np.float32)
    assert inbetween(start, end, 0.5, out) is out
    assert out.tolist() == [[0.5] * 3] * 20
