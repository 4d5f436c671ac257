import numpy as np
import pytest
from statwalk.skin import _kernels
from statwalk.skin.morph import inbetween

CHANCE = np.random.default_rng(5)


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


@pytest.mark.parametrize("length", [0, 1, 63, 64, 65, 1000])
def test_an_inbetween_of_any_length(length):
    start, end = CHANCE.normal(size=(2, length)).astype(np.float32)
    out = np.full(length, np.nan, np.float32)
    _kernels.inbetween(start, end, 0.25, out)
    assert out == pytest.approx(0.75 * start + 0.25 * end, abs=1e-6)


def test_targets_may_lie_anywhere_and_in_any_order():
    base, displacements = (
        CHANCE.normal(size=96).astype(np.float32),
        CHANCE.normal(size=300).astype(np.float32),
    )
    out = np.empty(96, np.float32)
    _kernels.morphed(base, displacements, np.array([0.5, -2], np.float32), np.array([200, 7]), out)
    assert out == pytest.approx(base + 0.5 * displacements[200:296] - 2 * displacements[7:103], abs=1e-5)
