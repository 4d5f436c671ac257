"""The nearest value that makes a condition true."""

import numpy as np
import pytest
from statwalk.stage.explain.thresholds import nearest_true


@pytest.mark.parametrize(
    ("condition", "now", "bounds", "value"),
    [
        (lambda x: x > 10, 8.0, (0, 100), 11.0),
        (lambda x: x >= 10, 8.0, (0, 100), 10.0),
        (lambda x: x < 0.25, 0.5, (0, 1), 0.24),
        (lambda x: (x > 3) & (x < 3.5), 5.0, (0, 10), 3.4),
        (lambda x: x > 0.3, 0.0, (0, 0.5), 0.301),
        (lambda x: x * x > 2, 0.0, (-10, 10), -1.5),
        (lambda x: x > 1, 1.0, (0, np.inf), 2.0),
        (lambda x: x == 0, 7.5, (0, 10), 0.0),
    ],
)
def test_the_nearest_round_value(condition, now, bounds, value):
    assert nearest_true(condition, now, *bounds) == pytest.approx(value, abs=1e-12)
    assert condition(nearest_true(condition, now, *bounds))


def test_out_of_reach_is_none():
    assert nearest_true(lambda x: x > 2, 0.0, 0.0, 1.0) is None


def test_what_is_true_stays():
    assert nearest_true(lambda x: x > 0.2, 0.5, 0.0, 1.0) == 0.5
