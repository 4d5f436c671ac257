"""Phases that correspond: at common markers, straight between them, round the circle."""

import locked_arrays
import numpy as np
import pytest
from statwalk.maths.phases import match, warp

WALK = (("left", 0.0), ("right", 0.5))
RUN = (("left", 0.3), ("right", 0.7))
GRID = np.linspace(0, 1, 201, endpoint=False)


def test_markers_of_the_same_name_correspond():
    assert match(WALK, RUN, [0.0, 0.5]) == pytest.approx([0.3, 0.7])


def test_between_markers_it_is_straight():
    assert match(WALK, RUN, [0.25, 0.75]) == pytest.approx([0.5, 0.0])


def test_it_is_the_same_as_interpolating_the_knots():
    knots = [-0.5, 0, 0.5, 1], [-0.3, 0.3, 0.7, 1.3]
    assert match(WALK, RUN, GRID) == pytest.approx(np.interp(GRID, *knots) % 1)


def test_the_way_back_undoes_it():
    there = match(WALK, RUN, GRID)
    back = match(RUN, WALK, there)
    assert np.abs((back - GRID + 0.5) % 1 - 0.5).max() < 1e-12


def test_nothing_in_common_is_the_same_phase():
    assert (match(WALK, (("clap", 0.4),), GRID) == GRID).all()


def test_the_same_markers_are_the_same_phase_to_the_bit():
    assert (match(RUN, RUN, GRID) == GRID).all()


def test_one_common_marker_shifts():
    assert match((("left", 0.1),), (("left", 0.9),), [0.1, 0.3]) == pytest.approx([0.9, 0.1])


def test_repeated_names_correspond_in_their_order():
    old, new = (("step", 0.1), ("step", 0.6)), (("step", 0.2), ("step", 0.9))
    assert match(old, new, [0.1, 0.6, 0.85]) == pytest.approx([0.2, 0.9, 0.05])


def test_repeated_names_are_counted_from_one_that_is_not():
    """Both feet make a step; which one is said by `left`."""
    old = (("left", 0.1), ("step", 0.1), ("step", 0.6))
    new = (("left", 0.7), ("step", 0.2), ("step", 0.7))
    assert match(old, new, [0.1, 0.6]) == pytest.approx([0.7, 0.2])


def test_markers_in_another_order_do_not_turn_time_back():
    old, new = (("a", 0.0), ("b", 0.3), ("c", 0.6)), (("a", 0.0), ("b", 0.8), ("c", 0.4))
    assert (np.diff(warp(old, new).lift(GRID)) > 0).all()


def test_laps_are_counted_through():
    lifted = warp(WALK, RUN).lift(np.linspace(0, 3, 601))
    assert (np.diff(lifted) > 0).all()
    assert lifted[-1] - lifted[0] == pytest.approx(3)


def test_a_motion_that_does_not_loop_begins_and_ends_with_the_other():
    assert match((("hit", 0.4),), (("hit", 0.6),), [0.0, 0.2, 0.4, 0.7, 1.0], loop=False) == pytest.approx(
        [0, 0.3, 0.6, 0.8, 1.0]
    )


def test_one_phase_is_the_same_alone_and_among_many():
    assert match(WALK, RUN, GRID[77]) == match(WALK, RUN, GRID)[77]


@pytest.mark.parametrize("seed", range(5))
def test_any_markers_give_a_way_that_goes_on(seed):
    rng = np.random.default_rng(seed)
    marks = [
        [(str(name), phase) for name, phase in zip(rng.integers(0, 3, 5), rng.random(5), strict=True)]
        for _ in range(2)
    ]
    lifted = warp(*marks).lift(np.linspace(-1, 1, 4001))
    assert np.isfinite(lifted).all()
    assert (np.diff(lifted) >= 0).all()


def test_the_knots_of_a_warp_cannot_be_written():
    locked_arrays.check(warp((), ()))
