"""Foot contacts found from clips: the walker's strides as they were made, a tread on the spot by hand."""

from dataclasses import replace

import numpy as np
import pytest
from paths import GLTF, MACHINES, needs_assets
from statwalk.character.character import Character
from statwalk.character.feet import feet_of
from statwalk.character.foot_contacts import contacts_of, joined
from statwalk.files.character_file import load_character_file
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.services.library.load import load_role

WALKER = load_role(MACHINES / "faq-walker").character
FOUND = contacts_of(WALKER, feet_of(WALKER))


def of(clip):
    return {foot.foot: joined(foot.planted) for foot in FOUND[clip].feet}


def test_a_walk_stands_on_each_foot_for_three_fifths():
    """The walker's left heel strikes at phase 0, the right one at 0.5 (guide to motion: stance 60 %)."""
    walk = of("walk")
    assert walk["left"][0] == pytest.approx((0.99, 1.65), abs=0.03)
    assert walk["right"][0] == pytest.approx((0.49, 1.15), abs=0.03)


def test_the_heel_comes_before_the_ball_and_leaves_before_it():
    right = FOUND["walk"].feet[1]
    (heel,), (ball,) = joined(right.heel), joined(right.ball)
    assert heel[0] < ball[0]
    assert heel[1] < ball[1]


def test_standing_is_a_contact_and_flight_is_none():
    assert of("stand") == {"left": ((0.0, 1.0),), "right": ((0.0, 1.0),)}
    assert max(last for spans in of("fly").values() for _, last in spans) < 0.15


def test_contacts_are_found_once():
    feet = feet_of(WALKER)
    assert contacts_of(WALKER, feet) is contacts_of(WALKER, feet)


def tread(speed, lift):
    """A leg whose foot runs back on the ground at `speed` m/s for 0.6 s, and forward in the air for 0.4 s."""
    skeleton, _ = Skeleton.sorted(["LeftUpLeg", "LeftLeg", "LeftFoot"], [None, "LeftUpLeg", "LeftLeg"])
    pose = rest(3)
    pose.translation[:] = [[0, 1, 0], [0, -0.5, 0], [0, -0.5, 0]]
    times = np.array([0, 0.6, 0.7, 0.9, 1.0], np.float32)
    place = np.zeros((5, 3), np.float32)
    place[:, 1], place[:, 2] = [-0.5, -0.5, -0.5 + lift, -0.5 + lift, -0.5], [0.3, -0.3, -0.25, 0.25, 0.3]
    place[:, 2] *= speed
    clip = Clip("tread", (Channel(2, "translation", times, place),), 1.0, pose)
    return Character("tread", skeleton, np.arange(3, dtype=np.int32), pose, {"tread": clip})


def test_on_the_spot_the_ground_runs():
    character = tread(1.0, 0.2)
    contacts = contacts_of(character, feet_of(character))["tread"]
    assert contacts.drift == pytest.approx((0, -1), abs=0.02)
    assert contacts.feet[0].planted[0] == pytest.approx((0, 0.6), abs=0.03)


def test_a_foot_that_stands_in_place_has_no_running_ground():
    character = tread(0.01, 0.2)
    contacts = contacts_of(character, feet_of(character))["tread"]
    assert contacts.drift == (0, 0)
    assert contacts.feet[0].planted[0] == pytest.approx((0, 0.6), abs=0.03)


def test_a_loop_joins_the_ends():
    assert joined([(0.0, 0.15), (0.4, 1.0)]) == ((0.4, 1.15),)
    assert joined([(0.1, 0.2), (0.4, 1.0)]) == ((0.1, 0.2), (0.4, 1.0))
    assert joined([(0.0, 1.0)]) == ((0.0, 1.0),)


@needs_assets
def test_a_walk_on_the_spot_of_another_rig():
    knight = load_character_file(GLTF / "KayKit_Knight.glb")
    walk = contacts_of(knight, feet_of(knight))["Walking_A"]
    (left,), (right,) = (foot.planted for foot in walk.feet)
    assert walk.drift[1] < -0.5
    assert right[0] - left[0] == pytest.approx(0.5, abs=0.02)


def test_a_clip_without_time_has_no_contacts():
    clips = {"pose": replace(WALKER.clips["walk"], name="pose", channels=(), duration=0.0)}
    character = replace(WALKER, clips=clips)
    assert [foot.planted for foot in contacts_of(character, feet_of(character))["pose"].feet] == [(), ()]
