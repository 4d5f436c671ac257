"""Jumps of tracks worked out by hand."""

import numpy as np
import pytest
from statwalk.stage.measure.jump import changes_of, jump_of

STEADY = np.zeros((10, 2, 3))
STEADY[:, 0, 0] = 0.01 * np.arange(10)
"""joint a moves 10 mm a tick, joint b stands"""


def test_changes_are_of_position_and_of_velocity():
    track = STEADY.copy()
    track[5:, 0, 0] += 0.03
    assert changes_of(STEADY)[:, 0] == pytest.approx([0.01, 0])
    assert changes_of(track)[:, 0] == pytest.approx([0.04, 0.03])


def test_a_jump_is_relative_to_the_motions():
    track, most = STEADY.copy(), np.array([[0.01, 0.002], [0.005, 0.001]])
    track[5:, 1, 1] = 0.02
    jump = jump_of(track, [most], ["a", "b"])
    assert jump.body == pytest.approx(0.02 / 0.005)  # the velocity of b against that of a, the liveliest
    assert jump.joint == pytest.approx(0.02 / (0.001 + 1e-4))
    assert (jump.name, jump.what) == ("b", "velocity")


def test_within_its_own_motion_nothing_jumps():
    assert jump_of(STEADY, [changes_of(STEADY)], ["a", "b"]).body == pytest.approx(1)
