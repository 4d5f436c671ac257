"""The height at which a leg hovers that a test moves by hand."""

from dataclasses import replace

import numpy as np
import pytest
from recordings_by_hand import ANKLE, HIP, foot, recording, standing
from statwalk.character.skin_points import SkinPoints
from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.stage.measure.hover import hovers

EVERY = np.ones((10, 1), bool)
STEP = (GroundDefinition((-1, -1), (1, 1), 0.2, 0),)


def lifted(heights):
    """The joints of a leg whose sole has these heights (metres) from tick 3 on."""
    joints = standing(10)
    joints[3 : 3 + len(heights), ANKLE, 1] = heights
    return joints


def hover(joints, watched=EVERY, ground=(), **parts):
    return hovers(recording(joints, **parts), (foot(),), watched, ground)[0]


def test_a_leg_that_stands_does_not_hover_and_one_that_is_lifted_does():
    assert hover(standing(10)) == 0
    assert hover(lifted([0.01, 0.03, 0.02, 0.02])) == pytest.approx(0.02)


def test_two_ticks_are_too_short_to_be_seen():
    assert hover(lifted([0.05, 0.05])) == 0


def test_one_foot_on_the_ground_is_enough():
    on_the_hip = replace(foot(), skin=SkinPoints.of_joints_themselves([HIP], 3))
    joints = lifted([0.02] * 7) - np.array([[0, 1.0, 0], [0, 0, 0], [0, 0, 0]])  # the hip is on the ground
    assert hovers(recording(joints), (foot(), on_the_hip), EVERY)[0] == 0
    assert hovers(recording(joints), (foot(),), EVERY)[0] == pytest.approx(0.02)


def test_what_the_motion_lifts_does_not_hover():
    low = np.array([0.0] * 3 + [0.004] * 3 + [0.3] * 4)
    assert hover(lifted([0.02] * 7), low=low) == pytest.approx(0.016)


def test_what_comes_down_from_a_jump_does_not_hover():
    low, left = np.array([0.3] * 3 + [0.0] * 7), np.linspace(0.9, 0.1, 10)
    assert hover(lifted([0.02] * 7), low=low, left=left) == 0
    assert hover(lifted([0.02] * 7), low=low) == pytest.approx(0.02)


def test_only_watched_ticks_count():
    assert hover(lifted([0.02] * 7), watched=np.arange(10)[:, None] < 5) == 0


def test_on_a_step_a_leg_hovers_over_the_step():
    joints = lifted([0.02] * 7) + np.array([0, 0.2, 0])
    assert hover(joints, ground=STEP) == pytest.approx(0.02)
    assert hover(joints, low=np.full(10, 0.005)) == pytest.approx(0.215)
