"""The walker looks at the point `gaze` as much as `look` says; by default his motions are as they were."""

import numpy as np
import pytest
import statwalk
from statwalk.stage.stage import Stage


@pytest.fixture
def walker():
    stage = Stage()
    actor = stage.add(statwalk.load("faq-walker"))
    stage.step(2)
    return stage, actor


def sight(actor):
    """The direction in which his head looks."""
    return actor.world[actor.role.character.skeleton.index("Head"), :3, 2]


def test_by_default_he_plays_his_motion(walker):
    _, actor = walker
    clip = actor.role.character.clips["stand"].sample(actor.time)
    head = actor.role.character.skeleton.index("Head")
    np.testing.assert_allclose(actor.pose.rotation[head], clip.rotation[head], atol=1e-6)
    assert actor.reached["gaze"].weight == 0


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_he_looks_at_a_point_beside_him(walker, side):
    stage, actor = walker
    stage.set(actor, "look", 1.0)
    stage.set(actor, "gaze", (2.0 * side, 1.5, 2.0))
    stage.step(90)
    assert np.degrees(np.arctan2(*sight(actor)[[0, 2]])) == pytest.approx(45 * side, abs=3)
    assert actor.reached["gaze"].reached


def test_he_does_not_look_behind_himself(walker):
    stage, actor = walker
    stage.set(actor, "look", 1.0)
    stage.set(actor, "gaze", (1.0, 1.5, -9.0))
    stage.step(90)
    assert np.degrees(np.arccos(sight(actor)[2])) == pytest.approx(70, abs=1)
    assert not actor.reached["gaze"].reached
