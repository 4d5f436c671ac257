import numpy as np
import pytest
from statwalk.maths.kernels import morphing

CHANCE = np.random.default_rng(5)


@pytest.mark.parametrize("length", [0, 1, 63, 64, 65, 1000])
def test_an_inbetween_of_any_length(length):
    start, end = CHANCE.normal(size=(2, length)).astype(np.float32)
    out = np.full(length, np.nan, np.float32)
    morphing.inbetween(start, end, 0.25, out)
    assert out == pytest.approx(0.75 * start + 0.25 * end, abs=1e-6)


def test_targets_may_lie_anywhere_and_in_any_order():
    base, displacements = (
        CHANCE.normal(size=96).astype(np.float32),
        CHANCE.normal(size=300).astype(np.float32),
    )
    out = np.empty(96, np.float32)
    morphing.morphed(base, displacements, np.array([0.5, -2], np.float32), np.array([200, 7]), out)
    assert out == pytest.approx(base + 0.5 * displacements[200:296] - 2 * displacements[7:103], abs=1e-5)
