"""Knees and hands that a test moves by hand."""

import numpy as np
import pytest
from paths import MACHINES
from recordings_by_hand import ANKLE, KNEE, foot, recording, standing
from statwalk.services.library.load import load_role
from statwalk.stage.measure.limbs import hand_accelerations, hands_of, knees

EVERY = np.ones((10, 1), bool)


def test_a_knee_behind_its_leg_is_measured_and_a_bent_one_is_not():
    """The leg points nowhere at rest, so it bends along +Z."""
    behind, bent = standing(10), standing(10)
    behind[4, KNEE, 2], bent[4, KNEE, 2] = -0.03, 0.2
    assert knees(recording(behind), (foot(),), EVERY)[0] == pytest.approx(0.03)
    assert knees(recording(bent), (foot(),), EVERY)[0] == 0


def test_a_hand_is_as_fast_as_its_parabola():
    joints, seconds = standing(10), np.arange(10) / 60
    joints[:, ANKLE, 0] = 20 * seconds**2
    fastest = hand_accelerations(recording(joints), np.array([ANKLE]), EVERY)
    assert fastest[0] == pytest.approx(40)


def test_hands_are_found_by_their_names():
    walker = load_role(MACHINES / "faq-walker").character
    assert [walker.skeleton.names[joint] for joint in hands_of(walker)] == ["Left.hand", "Right.hand"]
