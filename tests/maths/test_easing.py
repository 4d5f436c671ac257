"""Easings keep their promises at the ends."""

import numpy as np
import pytest
from statwalk.maths.easing import EASINGS

F = np.linspace(0, 1, 101)


@pytest.mark.parametrize("name", EASINGS)
def test_begins_at_0_ends_at_1_and_never_turns_back(name):
    way = EASINGS[name](F)
    assert (way[0], way[-1]) == (0, 1)
    assert (np.diff(way) >= 0).all()


@pytest.mark.parametrize("name", EASINGS)
def test_holds_beyond_the_ends(name):
    np.testing.assert_array_equal(EASINGS[name]([-1.0, 2.0]), [0, 1])


@pytest.mark.parametrize(
    ("name", "at_start", "at_end"),
    [("smoothstep", 0, 0), ("smootherstep", 0, 0), ("ease-in", 0, 3), ("ease-out", 3, 0)],
)
def test_speed_at_the_ends(name, at_start, at_end):
    way = EASINGS[name](np.array([0, 1e-6, 1 - 1e-6, 1]))
    np.testing.assert_allclose(
        [(way[1] - way[0]) * 1e6, (way[3] - way[2]) * 1e6], [at_start, at_end], atol=1e-4
    )


@pytest.mark.parametrize("name", ["linear", "smoothstep", "smootherstep", "ease-in-out"])
def test_symmetry(name):
    np.testing.assert_allclose(EASINGS[name](F) + EASINGS[name](1 - F), 1, atol=1e-15)


def test_ease_out_is_ease_in_backwards():
    np.testing.assert_allclose(EASINGS["ease-out"](F), 1 - EASINGS["ease-in"](1 - F), atol=1e-15)
