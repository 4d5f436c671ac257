"""Feet: the joints of legs by their names, and the points of their soles."""

import numpy as np
import pytest
from paths import GLTF, MACHINES, needs_assets
from statwalk.character.feet import MOST_POINTS, feet_of
from statwalk.errors import UnknownNameError
from statwalk.files.character_file import load_character_file
from statwalk.maths import transform
from statwalk.rig.evaluate import world_from_local
from statwalk.services.library.load import load_role

WALKER = load_role(MACHINES / "faq-walker").character


def names_of(character, foot):
    return [character.skeleton.names[joint] for joint in foot.leg]


def test_the_walker_has_two_legs():
    left, right = feet_of(WALKER)
    assert (left.name, names_of(WALKER, left)) == ("left", ["Left.upperleg", "Left.lowerleg", "Left.foot"])
    assert (right.name, right.toe, right.hangs) == ("right", -1, True)


def test_soles_are_the_lowest_points_and_as_long_as_the_foot():
    world = world_from_local(WALKER.skeleton, WALKER.bind_pose).astype(float)
    lowest = min(part.positions[:, 1].min() for part in WALKER.vertices(WALKER.bind_pose))
    for foot in feet_of(WALKER):
        points = transform.apply(world[foot.carriers], foot.points)
        assert np.abs(points - foot.skin.at(world)).max() < 1e-6
        assert points[:, 1].min() == pytest.approx(lowest, abs=1e-6)
        assert np.ptp(points[:, 1]) < 0.033  # a fiftieth of the height of the highest joint, the eyes
        assert 0.2 < np.ptp(points[:, 2]) < 0.3
        assert points[foot.is_front, 2].min() > points[~foot.is_front, 2].max()
        assert 4 <= len(points) <= MOST_POINTS


def test_a_leg_is_as_long_as_its_bones():
    world = world_from_local(WALKER.skeleton, WALKER.bind_pose)
    assert feet_of(WALKER)[0].length(world) == pytest.approx(0.43 + 0.42, abs=1e-5)


def test_joints_that_names_do_not_tell_are_named():
    (left, _, tail) = feet_of(WALKER, {"left": {"ankle": "Left.foot"}, "tail": {"ankle": "Left.hand"}})
    assert names_of(WALKER, left) == ["Left.upperleg", "Left.lowerleg", "Left.foot"]
    assert names_of(WALKER, tail) == ["Left.upperarm", "Left.lowerarm", "Left.hand"]
    with pytest.raises(UnknownNameError, match=r"did you mean Left\.foot"):
        feet_of(WALKER, {"left": {"ankle": "Left.foott"}})


@needs_assets
@pytest.mark.parametrize(
    ("model", "leg", "hangs"),
    [
        ("KayKit_Knight", ["upperleg.l", "lowerleg.l", "foot.l"], True),
        ("M2M_rig_human", ["thigh_l", "calf_l", "foot_l"], True),
        ("RobotExpressive", ["UpperLeg.L", "LowerLeg.L", "Foot.L"], False),
    ],
)
def test_legs_of_other_conventions(model, leg, hangs):
    character = load_character_file(GLTF / f"{model}.glb")
    left = feet_of(character)[0]
    assert (names_of(character, left), left.hangs) == (leg, hangs)


@needs_assets
def test_a_character_without_feet_has_none():
    assert feet_of(load_character_file(GLTF / "M2M_snake.glb")) == ()
