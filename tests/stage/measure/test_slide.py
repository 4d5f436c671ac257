"""Slides and sinks of a foot that a test moves by hand."""

import numpy as np
import pytest
from recordings_by_hand import ANKLE, foot, recording, standing
from statwalk.character.skin_points import SkinPoints
from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.stage.measure.slide import NEAR, sinks, slides

EVERY = np.ones((10, 1), bool)
STEP = (GroundDefinition((-1, -1), (1, 1), 0.2, 0),)


def test_a_foot_that_stands_does_not_slide():
    assert slides(recording(standing(10)), (foot(),), EVERY)[0] == 0


def test_a_foot_slides_as_far_as_it_is_dragged():
    joints = standing(10)
    joints[:, ANKLE, 2] = 0.01 * np.arange(10)
    assert slides(recording(joints), (foot(),), EVERY)[0] == pytest.approx(0.09)


def test_the_actor_drags_its_feet_along():
    position = np.zeros((10, 3))
    position[:, 0] = 0.02 * np.arange(10)
    assert slides(recording(standing(10), position=position), (foot(),), EVERY)[0] == pytest.approx(0.18)


def test_in_the_air_nothing_slides_and_each_contact_counts_by_itself():
    joints = standing(10)
    joints[:, ANKLE, 2] = 0.01 * np.arange(10)
    joints[4, ANKLE, 1] = 2 * NEAR  # ticks 0…3 and 5…9 are on the ground
    assert slides(recording(joints), (foot(),), EVERY)[0] == pytest.approx(0.04)


def test_a_point_above_the_floor_counts_less():
    joints = standing(10)
    joints[:, ANKLE, 2] = 0.01 * np.arange(10)
    joints[:, ANKLE, 1] = NEAR / 2
    assert slides(recording(joints), (foot(),), EVERY)[0] == pytest.approx(0.09 * (2 - 2**0.5))


def test_only_watched_ticks_count():
    joints = standing(10)
    joints[:, ANKLE, 2] = 0.01 * np.arange(10)
    watched = np.arange(10)[:, None] >= 7
    assert slides(recording(joints), (foot(),), watched)[0] == pytest.approx(0.02)


def test_skin_sinks_as_far_as_its_lowest_point():
    joints = standing(10)
    joints[3, ANKLE, 1] = -0.012
    skin = SkinPoints.of_joints_themselves(range(3), 3)
    assert sinks(recording(joints), skin, EVERY)[0] == pytest.approx(0.012)
    assert sinks(recording(standing(10)), skin, EVERY)[0] == 0


def test_on_a_step_a_foot_slides_and_sinks_as_on_the_floor():
    joints = standing(10) + np.array([0, 0.2, 0])
    joints[:, ANKLE, 2] = 0.01 * np.arange(10)
    joints[3, ANKLE, 1] = 0.196
    skin = SkinPoints.of_joints_themselves(range(3), 3)
    assert slides(recording(joints), (foot(),), EVERY, STEP)[0] == pytest.approx(0.09)
    assert sinks(recording(joints), skin, EVERY, STEP)[0] == pytest.approx(0.004)
    assert slides(recording(joints), (foot(),), EVERY)[0] == 0


def test_a_foot_that_pokes_into_the_side_of_a_step_sinks_and_does_not_slide():
    joints = standing(10) + np.array([0, 0.1, -0.992])
    joints[:, ANKLE, 0] = 0.01 * np.arange(10)
    skin = SkinPoints.of_joints_themselves([ANKLE], 3)
    assert slides(recording(joints), (foot(),), EVERY, STEP)[0] == 0
    assert sinks(recording(joints), skin, EVERY, STEP)[0] == pytest.approx(0.01, abs=0.0021)
