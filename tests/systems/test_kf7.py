"""KF7 step: RTCA Listing 2 switches between two key poses at the half-way point; glTF's STEP holds a key until the next."""

import numpy as np
import pytest
from statwalk.maths import curves
from textcharacter import from_text, keyed, place

BONE = "Root --- - - - -\nArm Root 2 1 0 0\n"
PLACES = np.array([[1.0, 0, 0], [2, 0, 0], [3, 0, 0]])


SWITCHED = {"step": {0.0: 1, 0.49: 1, 0.5: 2, 1.0: 2, 1.49: 2, 1.5: 3, 2.0: 3}, "hold": {0.0: 1, 0.5: 1, 0.99: 1, 1.0: 2, 2.0: 3}}
CASES = [(name, time, value) for name, row in SWITCHED.items() for time, value in row.items()]


@pytest.mark.parametrize(("interpolation", "time", "expected"), CASES)
def test_a_clip_switches(tmp_path, interpolation, time, expected):
    arm = from_text(tmp_path, BONE, jump=(keyed([0, 1, 2], "#translate", "Arm", PLACES), f"interpolation: {interpolation}"))
    np.testing.assert_array_equal(place(arm, arm.clip("jump").sample(time), "Arm"), [expected, 0, 0])


def test_the_clip_keeps_its_duration(tmp_path):
    arm = from_text(tmp_path, BONE, jump=(keyed([0, 1, 2], "#translate", "Arm", PLACES), "interpolation: step"))
    assert arm.clip("jump").duration == 2


@pytest.mark.parametrize(("f", "expected"), [(0.0, 1), (0.4999, 1), (0.5, 2), (1.0, 2)])
def test_listing_2(f, expected):
    assert curves.step(PLACES[0], PLACES[1], f)[0] == expected
