"""Motions by themselves over uneven ground: livelier than on the floor where feet must rise."""

from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.stage.measure.jump import joints_shown, most_of
from statwalk.stage.measure.measured_ground import Spot
from statwalk.stage.measure.over_ground import most_over
from statwalk.stage.measure.subject import Subject

TERRAIN = load_role(MACHINES / "terrain")
WALK, JOINTS = TERRAIN.machine.states.index("WALK"), joints_shown(TERRAIN)


def test_far_from_the_ground_a_motion_is_about_as_lively_as_on_the_floor():
    there = most_over(TERRAIN, WALK, JOINTS, [Spot(0, -9)])
    ratios = there.max(1) / most_of(TERRAIN, WALK, JOINTS).max(1)
    assert (ratios > 0.9).all()
    assert (ratios < 1.5).all()


def test_on_stairs_a_walk_is_livelier_and_transitions_are_measured_against_that():
    stairs = most_over(TERRAIN, WALK, JOINTS, [Spot(0, 1.65)])
    assert stairs[1].max() > 1.2 * most_of(TERRAIN, WALK, JOINTS)[1].max()
    subject = Subject(TERRAIN)
    subject.places = [Spot(0, 1.65)]
    assert (subject.most(WALK) >= stairs).all()
