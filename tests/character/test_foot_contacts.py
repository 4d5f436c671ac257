"""Foot contacts found from clips: the walker's strides as they were made, a tread on the spot by hand."""

from dataclasses import replace

import pytest
from paths import GLTF, MACHINES, needs_assets
from statwalk.character.feet import feet_of
from statwalk.character.foot_contacts import contacts_of, joined
from statwalk.files.character_file import load_character_file
from statwalk.services.library.load import load_role
from treads import tread

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


def test_on_the_spot_the_ground_runs():
    character = tread(1.0, 0.2)
    contacts = contacts_of(character, feet_of(character))["tread"]
    assert contacts.drift == pytest.approx((0, -1), abs=0.02)
    assert contacts.feet[0].planted[0] == pytest.approx((0, 0.6), abs=0.03)


def test_a_clip_that_ends_elsewhere_is_no_walk_on_the_spot():
    """The beginning of a jump, say: its feet are pulled back, and do not come round."""
    character = tread(4.0, 0.2, returns=False)
    assert contacts_of(character, feet_of(character))["tread"].drift == (0, 0)


def test_feet_are_no_condition():
    bare = replace(WALKER, clips={"walk": WALKER.clips["walk"]})
    assert contacts_of(bare, ())["walk"].feet == ()


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
