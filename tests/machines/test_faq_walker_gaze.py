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


def sight(actor, joint="Head"):
    """The direction in which his head, or an eye, looks."""
    return actor.world[actor.role.character.skeleton.index(joint), :3, 2]


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


@pytest.mark.parametrize("eye", ["Left.eye", "Right.eye"])
def test_his_eyes_meet_the_point_in_every_tick(walker, eye):
    stage, actor = walker
    stage.set(actor, "look", 1.0)
    stage.set(actor, "gaze", (1.19, 1.53, 0.61))
    stage.step(200)
    for _ in range(60):
        stage.step()
        place = actor.world[actor.role.character.skeleton.index(eye), :3, 3].astype(float)
        way, look = np.array([1.19, 1.53, 0.61]) - place, sight(actor, eye).astype(float)
        passed = np.linalg.norm(np.cross(way, look)) / np.linalg.norm(look)
        told = actor.reached[eye.lower().replace(".", "-")]
        assert told.distance == pytest.approx(passed, abs=2e-6)
        assert told.reached


def test_he_does_not_look_behind_himself(walker):
    stage, actor = walker
    stage.set(actor, "look", 1.0)
    stage.set(actor, "gaze", (1.0, 1.5, -9.0))
    stage.step(90)
    assert np.degrees(np.arccos(sight(actor)[2])) == pytest.approx(70, abs=1)
    assert not actor.reached["gaze"].reached
