"""Root motion: what is taken from the pose moves the actor, and together they are what the clip said."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk.maths import quat, transform
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.motion.root import compose, extract, relative
from statwalk.motion.single import Single

TIMES = np.linspace(0, 2, 21).astype(np.float32)
ONE = np.zeros(1, np.int64)


def displacement(root, start, end, wraps):
    """The way along a root track, as a motion in a state goes it."""
    return Single(walk(), root).way(start, end, wraps, np.zeros((len(start), 0)))


def walk(speed=1.5, turn=0.0, sway=0.0):
    """Two seconds along +Z while turning left by `turn` radians, hips at 0.9 m, swaying sideways."""
    part = TIMES / 2
    place = np.stack([sway * np.sin(np.pi * TIMES), 0.9 + 0 * TIMES, speed * TIMES], -1)
    turns = Rotation.from_rotvec(np.stack([0 * part, turn * part, 0 * part], -1)) * Rotation.from_euler(
        "x", 0.2
    )
    keys = (place.astype(np.float32), turns.as_quat().astype(np.float32))
    channels = (Channel(0, "translation", TIMES, keys[0]), Channel(0, "rotation", TIMES, keys[1]))
    return Clip("walk", channels, 2.0, rest(2))


def together(clip, root, time):
    """The root joint's position and turn in the world: the actor's place, then the pose."""
    place, pose = root.at(np.array([time])), clip.sample(time)
    turn = quat.from_axis_angle(np.array([0.0, 1, 0]), place[0, 2])
    return np.array([place[0, 0], 0, place[0, 1]]) + quat.rotate(
        turn, pose.translation[0].astype(float)
    ), quat.mul(turn, pose.rotation[0])


@pytest.mark.parametrize("loop", [False, True])
@pytest.mark.parametrize("time", [0.0, 0.37, 1.0, 1.999])
def test_place_and_pose_make_the_motion_again(loop, time):
    clip = walk(turn=1.0, sway=0.05)
    position, turn = together(*extract(clip, 0, loop), time)
    assert position == pytest.approx(clip.sample(time).translation[0], abs=1e-3)
    assert abs(quat.dot(turn, clip.sample(time).rotation[0])) == pytest.approx(1, abs=1e-5)


def test_the_pose_stays_in_place():
    clip, _ = extract(walk(), 0, False)
    assert clip.sample(TIMES).translation[:, 0] == pytest.approx(np.tile([0, 0.9, 0], (21, 1)), abs=1e-5)


def test_pitch_stays_in_the_pose():
    clip, _ = extract(walk(turn=1.0), 0, False)
    assert Rotation.from_quat(clip.sample(1.0).rotation[0]).as_euler("xyz") == pytest.approx(
        [0.2, 0, 0], abs=1e-5
    )


def test_a_turn_to_the_left_is_positive():
    _, root = extract(walk(turn=np.pi / 2), 0, False)
    assert root.places[-1, 2] == pytest.approx(np.pi / 2, abs=1e-5)


def test_a_looping_motion_moves_the_root_evenly_and_sways_in_the_pose():
    clip, root = extract(walk(sway=0.05), 0, True)
    ways = relative(root.at(np.arange(0, 2, 0.1)), root.at(np.arange(0, 2, 0.1) + 0.1))
    assert ways == pytest.approx(np.tile([0, 0.15, 0], (20, 1)), abs=1e-4)
    assert clip.sample(0.5).translation[0, 0] == pytest.approx(0.05, abs=1e-3)


def test_displacement_is_in_the_frame_of_the_actor():
    _, root = extract(walk(turn=np.pi / 2), 0, False)
    way = displacement(root, np.array([1.9]), np.array([2.0]), ONE)[0]
    assert way[:2] == pytest.approx(
        0.15 * np.array([-np.sin(0.475 * np.pi), np.cos(0.475 * np.pi)]), abs=1e-3
    )


@pytest.mark.parametrize("loop", [False, True])
def test_the_way_does_not_depend_on_how_time_is_cut(loop):
    _, root = extract(walk(turn=1.0, sway=0.1), 0, loop)
    cuts = np.linspace(0.1, 1.9, 50)
    place = np.zeros((1, 3))
    for start, end in pairwise(cuts):
        place = compose(place, displacement(root, np.array([start]), np.array([end]), ONE))
    assert place == pytest.approx(displacement(root, cuts[:1], cuts[-1:], ONE), abs=1e-9)


@pytest.mark.parametrize("wraps", [1, 2, 3])
def test_repeats_add_up(wraps):
    _, root = extract(walk(turn=1.0), 0, True)
    way = displacement(root, np.array([0.5]), np.array([0.25]), np.array([wraps]))
    place = displacement(root, np.array([0.5]), np.array([2.0]), ONE)
    for _ in range(wraps - 1):
        place = compose(place, displacement(root, np.zeros(1), np.array([2.0]), ONE))
    assert way == pytest.approx(
        compose(place, displacement(root, np.zeros(1), np.array([0.25]), ONE)), abs=1e-9
    )


def test_four_quarter_turns_of_a_walk_close_a_circle():
    _, root = extract(walk(turn=np.pi / 2), 0, True)
    place = np.zeros((1, 3))
    for _ in range(4):
        place = compose(place, displacement(root, np.zeros(1), np.array([2.0]), ONE))
    assert place[0] == pytest.approx([0, 0, 2 * np.pi], abs=1e-4)


def test_actors_are_moved_apart():
    _, root = extract(walk(turn=1.0), 0, True)
    start, end, wraps = np.array([0.1, 1.5, 1.9]), np.array([0.4, 1.5, 0.2]), np.array([0, 0, 1])
    alone = [displacement(root, start[i : i + 1], end[i : i + 1], wraps[i : i + 1])[0] for i in range(3)]
    assert (displacement(root, start, end, wraps) == alone).all()


def test_a_joint_in_another_frame_moves_in_the_characters_space():
    """An exporter's armature: Z up, centimetres."""
    frame = transform.from_trs(
        np.zeros(3), Rotation.from_euler("x", -90, degrees=True).as_quat(), np.full(3, 0.01)
    )
    keys = np.stack([0 * TIMES, -150 * TIMES, 90 + 0 * TIMES], -1).astype(
        np.float32
    )  # its −Y is the character's +Z
    clip, root = extract(
        Clip("walk", (Channel(0, "translation", TIMES, keys),), 2.0, rest(1)), 0, False, frame
    )
    assert root.places[-1] == pytest.approx([0, 3.0, 0], abs=1e-5)
    assert clip.sample(2.0).translation[0] == pytest.approx([0, 0, 90], abs=1e-3)


def test_a_clip_that_does_not_move_the_joint_is_left_alone():
    clip = walk()
    assert extract(clip, 1, True)[0] is clip
