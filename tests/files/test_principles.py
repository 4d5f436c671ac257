"""Principles that play in a tick, against closed forms and SciPy: springs, added motion, clips in a row."""

from dataclasses import replace

import numpy as np
import pytest
import statwalk
from builders import character
from scipy.spatial.transform import Rotation
from statwalk.errors import ContentError, UnknownNameError
from statwalk.motion.clip import Channel, Clip

TINY = character()
CHEST, ARM = 1, 2
SPRING = {"half_life": 0.2, "frequency": 2}


def stopping() -> statwalk.Character:
    """The hips go half a metre along +X in a second, and stop: the chest is half a metre above them."""
    times = np.array([0, 1, 3], np.float32)
    places = np.array([[0, 1, 0], [0.5, 1, 0], [0.5, 1, 0]], np.float32)
    chest = TINY.bind_pose.translation.copy()
    chest[ARM] = [0, 0.3, 0]
    rest = TINY.bind_pose._replace(translation=chest)
    clip = Clip("stop", (Channel(0, "translation", times, places),), 3.0, rest)
    return replace(TINY, bind_pose=rest, clips={"stop": clip})


def played(role: statwalk.Role, ticks: int) -> list[statwalk.Pose]:
    """The actor's pose at tick 0, 1, 2 …"""
    stage = statwalk.Stage(seed=1)
    actor, poses = stage.add(role), []
    for _ in range(ticks):
        poses.append(actor.pose)
        stage.step(1)
    return poses


def arm_of(rotations: np.ndarray) -> Rotation:
    return Rotation.from_quat(rotations[:, ARM])


def test_what_hangs_on_a_spring_goes_on_when_its_character_stops():
    poses = played(statwalk.follow_through(stopping(), "stop", {"chest": SPRING}), 120)
    ways = Rotation.from_quat([pose.rotation[CHEST] for pose in poses]).apply([0, 0.3, 0])
    seconds, swing = np.arange(60) / 60, 2 * np.pi * 2
    away = 0.5 / swing * np.exp(-np.log(2) / 0.2 * seconds) * np.sin(swing * seconds)
    np.testing.assert_allclose(ways[:60], np.tile([0, 0.3, 0], (60, 1)), atol=1e-5)
    np.testing.assert_allclose(ways[60:, 0], 0.3 * away / np.hypot(away, 0.3), atol=1e-4)


@pytest.mark.parametrize("weight", [1.0, 0.4])
def test_a_secondary_action_adds_its_way_from_its_first_pose(weight):
    role = statwalk.secondary(TINY, "walk", "hop", ["arm"], weight)
    shown = arm_of(np.stack([pose.rotation for pose in played(role, 25)]))
    seconds = np.arange(25) / 60
    walk, hop = (arm_of(TINY.clip(name).sample(seconds).rotation) for name in ("walk", "hop"))
    expected = walk * Rotation.from_rotvec(weight * (hop[0].inv() * hop).as_rotvec())
    assert (shown.inv() * expected).magnitude().max() < 1e-4


def test_a_secondary_action_leaves_other_joints_alone():
    (*_, last) = played(statwalk.secondary(TINY, "walk", "turn", ["arm"]), 25)
    np.testing.assert_allclose(last.rotation[0], TINY.clip("walk").sample(24 / 60).rotation[0], atol=1e-6)


def test_straight_ahead_plays_one_clip_after_the_other():
    poses = played(statwalk.straight_ahead(TINY, ["walk", "hop", "walk"]), 170)
    for name, first, ticks in (("walk", 0, 60), ("hop", 60, 30), ("walk", 90, 60)):
        expected = TINY.clip(name).sample(np.arange(ticks) / 60)
        shown = np.stack([pose.rotation for pose in poses[first : first + ticks]])
        np.testing.assert_allclose(shown, expected.rotation, atol=1e-5)
    np.testing.assert_allclose(poses[-1].rotation, TINY.clip("walk").sample(1.0).rotation, atol=1e-5)


def test_straight_ahead_repeats_its_row_when_told_to():
    poses = played(statwalk.straight_ahead(TINY, ["hop", "turn"], repeat=True), 100)
    np.testing.assert_allclose(poses[95].rotation, TINY.clip("hop").sample(5 / 60).rotation, atol=1e-5)


def test_pose_to_pose_blends_on_the_way():
    """Two poses an arm's quarter turn apart: each tick goes a little of the way, no tick goes it all."""
    turns = Rotation.from_euler("z", [[0], [90]], degrees=True).as_quat().astype(np.float32)
    times = np.array([0, 0.5], np.float32)
    clips = {
        name: Clip(name, (Channel(ARM, "rotation", times, np.stack([turn, turn])),), 0.5, TINY.bind_pose)
        for name, turn in zip("ab", turns, strict=True)
    }
    role = statwalk.straight_ahead(replace(TINY, clips=clips), ["a", "b"], blend=0.4)
    shown = arm_of(np.stack([pose.rotation for pose in played(role, 60)]))
    arm = shown.as_euler("xyz", degrees=True)[:, 2]
    assert arm[29] == pytest.approx(0, abs=1e-3)
    assert 0 < np.diff(arm[29:54]).max() < 10
    np.testing.assert_allclose(arm[55:], 90, atol=1e-3)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: statwalk.follow_through(TINY, "walk", {"arn": SPRING}), "did you mean arm"),
        (lambda: statwalk.follow_through(TINY, "walk", {"arm": {"half_life": 0}}), "from 0.001 to 60"),
        (lambda: statwalk.follow_through(TINY, "walk", {"arm": {}}), "`half_life` is missing"),
        (lambda: statwalk.secondary(TINY, "walk", "hop", weight=2), "secondary: '2' is not"),
        (lambda: statwalk.secondary(TINY, "walk", "hop", ["arn"]), "did you mean arm"),
        (lambda: statwalk.straight_ahead(TINY, []), "at least one clip"),
        (lambda: statwalk.straight_ahead(TINY, ["walk"], blend=-1), "from 0 to 60"),
    ],
)
def test_what_a_principle_cannot_do_is_refused(make, words):
    with pytest.raises(ContentError, match=words):
        make()


def test_an_unknown_clip_is_refused_with_the_nearest():
    with pytest.raises(UnknownNameError, match="did you mean walk"):
        statwalk.straight_ahead(TINY, ["hop", "wlak"])
