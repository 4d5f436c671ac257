"""CD2 line and sphere (FAQ Q32): A t² + B t + C = 0; a missile meets a character at the smallest root on its
way.
"""

import numpy as np
import pytest
from statwalk.maths.intersect import line_sphere, segment_sphere

CENTER, RADIUS = np.array([1.0, 2, 3]), np.array(2.0)


def at(*offset):
    """A place given from the sphere's centre."""
    return CENTER + offset


@pytest.mark.parametrize(
    ("offset", "count", "first", "second"),
    [
        ((0, 0), 2, 0.3, 0.7),
        ((0, 1.2), 2, 0.5 - 0.16, 0.5 + 0.16),
        ((0, 2), 1, 0.5, 0.5),
        ((0, 2.1), 0, 0, 0),
    ],
)
def test_two_roots_one_or_none(offset, count, first, second):
    # ten metres along X past the middle, beside the centre by 0 m, 1.2 m (half chord 1.6 m), 2 m (grazes),
    # 2.1 m
    roots = line_sphere(at(-5.0, *offset), np.array([10.0, 0, 0]), CENTER, RADIUS)
    assert roots.roots == count
    assert (roots.first, roots.second) == pytest.approx((first, second))


def test_the_printed_coefficients_do_not_meet_it():
    # As printed A = Pdx + Pdy + Pdz (no squares): it is 0 for the step (3, -3, 0), which goes right through
    # the middle, and the quadratic is none. The correct A is 18, and the way of 3·sqrt 2 m enters 2 m before
    # the middle.
    step = np.array([3.0, -3, 0])
    assert step.sum() == 0
    roots = line_sphere(CENTER - step, step, CENTER, RADIUS)
    assert roots.first == pytest.approx(1 - 2 / np.sqrt(18))


@pytest.mark.parametrize(
    ("start", "end", "fraction"),
    [
        ((-5, 0, 0), (5, 0, 0), 0.3),
        ((5, 0, 0), (-5, 0, 0), 0.3),
        ((-5, 0, 0), (-2, 0, 0), 1),
        ((-1, 0, 0), (-9, 0, 0), 0),
    ],
    ids=["through", "back through", "just reaches", "starts inside"],
)
def test_the_hit_is_the_smallest_root_in_the_segment(start, end, fraction):
    hit = segment_sphere(at(*start), at(*end), CENTER, RADIUS)
    assert hit.is_hit
    assert hit.fraction == pytest.approx(fraction)


@pytest.mark.parametrize(
    ("start", "end"),
    [
        ((-5, 0, 0), (-2.1, 0, 0)),
        ((3, 0, 0), (9, 0, 0)),
        ((-5, 2.1, 0), (5, 2.1, 0)),
        ((-5, 0, 0), (-5, 0, 0)),
    ],
    ids=["stops before", "flies away", "passes by", "does not move"],
)
def test_no_hit(start, end):
    assert not segment_sphere(at(*start), at(*end), CENTER, RADIUS).is_hit


def test_who_stands_inside_is_hit():
    assert segment_sphere(at(1, 0, 0), at(1, 0, 0), CENTER, RADIUS).is_hit


def test_a_missile_that_would_skip_the_character_between_two_ticks_hits():
    # 600 m/s is 10 m a tick; the character's sphere is 0.5 m
    assert segment_sphere(at(-4, 0.3, 0), at(6, 0.3, 0), CENTER, np.array(0.5)).is_hit


def test_a_far_start_costs_no_accuracy():
    hit = segment_sphere(np.array([-1e6, 0, 0]), np.array([1e6, 0, 0]), np.zeros(3), np.array(1e-3))
    assert hit.fraction * 2e6 == pytest.approx(1e6 - 1e-3, abs=1e-9)


def test_one_of_many_has_the_bits_of_one_alone():
    chance = np.random.default_rng(3)
    starts, ends, centers = chance.normal(size=(3, 101, 3))
    many = segment_sphere(starts, ends, centers, np.full(101, 0.8))
    alone = [
        segment_sphere(starts[row], ends[row], centers[row], np.array(0.8)).fraction for row in range(101)
    ]
    np.testing.assert_array_equal(many.fraction, alone)
