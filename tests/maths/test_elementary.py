"""Our sines against NumPy's, and the law that matters most: one number alone gives the same bits as in a
crowd.
"""

import numpy as np
import pytest
from statwalk.maths import elementary

ANGLES = np.linspace(-1000, 1000, 20011)
MAGNITUDES = 10.0 ** np.linspace(-300, 300, 9973)
PAIRS = [
    ("sin", np.sin, ANGLES),
    ("cos", np.cos, ANGLES),
    ("exp", np.exp, np.linspace(-700, 700, 9973)),
    ("log", np.log, 10.0 ** np.linspace(-300, 300, 9973)),
]


@pytest.mark.parametrize(("name", "reference", "x"), PAIRS)
def test_float64_is_right_to_1e_14(name, reference, x):
    np.testing.assert_allclose(getattr(elementary, name)(x), reference(x), rtol=1e-14, atol=4e-16)


@pytest.mark.parametrize(("name", "reference", "x"), PAIRS[:2])
def test_float32_is_right_to_the_last_bits(name, reference, x):
    x32 = x.astype(np.float32)
    result = getattr(elementary, name)(x32)
    assert result.dtype == np.float32
    np.testing.assert_allclose(result, reference(x32.astype(np.float64)), rtol=1.3e-7, atol=1e-10)


@pytest.mark.parametrize(("name", "reference", "x"), PAIRS)
def test_alone_and_in_a_crowd_are_the_same_bits(name, reference, x):
    function = getattr(elementary, name)
    crowd = function(x[:99])
    assert [function(value).tobytes() for value in x[:99]] == [value.tobytes() for value in crowd]


def test_sincos_is_sin_and_cos():
    sine, cosine = elementary.sincos(ANGLES)
    assert (sine == elementary.sin(ANGLES)).all()
    assert (cosine == elementary.cos(ANGLES)).all()


def test_atan2_in_all_quadrants():
    y, x = np.random.default_rng(2).normal(size=(2, 5000)) * 10.0 ** np.random.default_rng(3).integers(
        -8, 8, (2, 5000)
    )
    np.testing.assert_allclose(elementary.atan2(y, x), np.arctan2(y, x), rtol=1e-14)


@pytest.mark.parametrize("y", [0.0, -0.0, 1.0, -1.0])
@pytest.mark.parametrize("x", [0.0, -0.0, 1.0, -1.0])
def test_atan2_on_the_axes(x, y):
    assert elementary.atan2(y, x) == pytest.approx(np.arctan2(y, x), rel=1e-15, abs=0)


def test_acos():
    x = np.linspace(-1, 1, 4001)
    np.testing.assert_allclose(elementary.acos(x), np.arccos(x), rtol=1e-14)


def test_acos_beyond_the_ends_is_that_of_the_end():
    assert elementary.acos(1.0 + 1e-9) == 0.0
