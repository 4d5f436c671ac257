"""The ground that trials meet: heights, depths and places, against numbers by hand and `crossings.py`."""

import numpy as np
import pytest
from crossings import depths as depths_all_round
from crossings import heights_at as heights_of_corners
from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.stage.measure.measured_ground import Spot, depths, heights_at, mean_heights, places_on

GROUND = load_role(MACHINES / "terrain").definition.ground
STAIR, LANDING, RAMP = GROUND[0], GROUND[3], GROUND[4]
CHANCE = np.random.default_rng(5)


def test_heights_are_those_of_the_file():
    x, z = CHANCE.uniform(-2, 2, 500), CHANCE.uniform(-1, 9, 500)
    assert heights_at(GROUND, x, z) == pytest.approx(heights_of_corners(GROUND, x, z))
    assert heights_at(GROUND, np.array([0.0]), np.array([5.9]))[0] == pytest.approx(0.24)


def test_without_ground_the_floor_is_at_0():
    assert heights_at((), np.ones(3), np.ones(3)).tolist() == [0, 0, 0]
    assert places_on(()) == [Spot()]


def test_a_point_is_as_deep_as_the_nearest_way_out():
    points = np.array([[0, 0.45, 3.4], [1.19, 0.2, 3.4], [0, 0.05, 1.51], [0, 0.5, 3.4]])
    assert depths(GROUND, points) == pytest.approx([0.03, 0.01, 0.01, 0], abs=0.0021)


def test_depths_are_those_that_are_found_all_round():
    points = CHANCE.uniform((-1.4, -0.1, 1.4), (1.4, 0.5, 7.5), (300, 3))
    there = depths_all_round(GROUND, points)
    shallow = there < 0.1
    assert shallow.sum() > 100
    assert np.abs(depths(GROUND, points) - there)[shallow].max() < 0.0045


def test_trials_begin_at_the_origin_and_on_every_piece_both_ways():
    places = places_on(GROUND)
    assert len(places) == 1 + 2 * len(GROUND)
    assert places[-2:] == [Spot(0, 5.9, 0), Spot(0, 5.9, np.pi)]


def test_a_root_begins_at_the_mean_height_of_the_ground():
    heights = mean_heights(GROUND, [Spot(0, -3), Spot(0, 3.4), Spot(0, 5.9, np.pi)], 1.0)
    assert heights == pytest.approx([0, 0.48, 0.24])
