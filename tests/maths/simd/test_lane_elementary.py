"""Sines and angles of sixteen at a time against NumPy in float64, and the same bits in any lane."""

import numpy as np
import pytest
from late_kernel import late_kernel
from statwalk.maths.compiling import FLOAT, read, write
from statwalk.maths.simd.lane_elementary import angle, arc_cosine, cosine, sine
from statwalk.maths.simd.lanes import load, store

RNG = np.random.default_rng(4)
HARD = [0, np.pi / 2, np.pi, -np.pi, 2 * np.pi, 1e-20, -1e-7, 1e4]


@late_kernel(read(FLOAT, 2), read(FLOAT, 2), write(FLOAT, 3))
def evaluated(x, y, out):
    width = x.size
    for at in range(0, x.size, 16):
        a, b = load(x, at), load(y, at)
        store(out, at, sine(a))
        store(out, at + width, cosine(a))
        store(out, at + 2 * width, angle(a, b))
        store(out, at + 3 * width, arc_cosine(b))


def results(x, y):
    out = np.zeros((4, *x.shape), np.float32)
    evaluated(x, y, out)
    return out.astype(np.float64)


def rows(numbers):
    """Filled up to whole rows of sixteen."""
    return np.resize(np.asarray(numbers, np.float32), (-(-len(numbers) // 16), 16))


ANGLES = rows([*HARD, *RNG.uniform(-10, 10, 4000), *RNG.uniform(-1e4, 1e4, 1000)])
COSINES = rows([-1, 1, 0, -0.0, 0.99999994, -0.99999994, 1e-8, 1.0000001, *RNG.uniform(-1, 1, 5000)])


def test_sine_and_cosine():
    found, exact = results(ANGLES, ANGLES), ANGLES.astype(np.float64)
    assert np.abs(found[0] - np.sin(exact)).max() < 3e-7
    assert np.abs(found[1] - np.cos(exact)).max() < 3e-7


def test_the_sine_of_little_is_exact_to_its_last_digits():
    little = rows(RNG.uniform(1e-12, 1e-3, 256))
    assert results(little, little)[0] == pytest.approx(np.sin(little.astype(np.float64)), rel=2e-7)


def test_the_angle_of_a_point():
    rise, run = (
        rows([0, 0, 1, 1e-12, 1, *RNG.uniform(0, 1, 4000)]),
        rows([0, 1, 0, 1, 1, *RNG.uniform(0, 1, 4000) ** 8]),
    )
    assert results(rise, run)[2] == pytest.approx(
        np.arctan2(rise.astype(np.float64), run), rel=3e-7, abs=1e-30
    )


def test_the_angle_of_a_cosine():
    expected = np.arccos(np.clip(COSINES.astype(np.float64), -1, 1))
    assert np.abs(results(COSINES, COSINES)[3] - expected).max() < 4e-7


@pytest.mark.parametrize("shift", [1, 7, 15])
def test_a_lane_does_not_matter(shift):
    here = results(ANGLES[:4], COSINES[:4])
    there = results(*(np.roll(array[:4], shift, 1) for array in (ANGLES, COSINES)))
    assert np.roll(here, shift, 2).tobytes() == there.tobytes()
