"""Flocks on a stage: members of one role fly in place of root motion, and their flight sets parameters."""

from dataclasses import replace

import numpy as np
import pytest
from builders import character, definition
from statwalk.character.role import Role
from statwalk.machine.definition.flock_definition import FlockDefinition, GoalDefinition, ObstacleDefinition
from statwalk.machine.definition.parameter_definition import ParameterDefinition
from statwalk.machine.definition.sense_definition import ColliderDefinition
from statwalk.stage.stage import Stage

FLOCK = FlockDefinition(
    1, distance=1, max_speed=3, max_acceleration=20, max_turn_deg=90, goal=GoalDefinition((0, 2, 30))
)
PARAMETERS = {"pace": ParameterDefinition(1, 0, 2, 1)} | {
    name: ParameterDefinition(0, -2, 2, 1) for name in ("rise", "lean")
}


def flock_role(name="bird", **more):
    return Role.build(
        name,
        character(),
        replace(definition(), name=name, flock=replace(FLOCK, **more), parameters=PARAMETERS),
        "hips",
    )


def stage_of(*roles_and_places):
    stage = Stage(seed=3)
    return stage, [stage.add(role, place) for role, place in roles_and_places]


def test_the_flight_takes_the_place_of_root_motion():
    stage, (bird,) = stage_of((flock_role(), (0, 0, 0)))
    stage.send(bird, "TURN")  # a motion that turns by 90 degrees
    stage.step(60)
    assert bird.root.position[2] > 1
    assert bird.root.heading == pytest.approx(0, abs=1e-9)
    assert bird.root.position[1] > 0


def test_others_are_left_alone():
    plain = Role.build("plain", character(), definition(), "hips")
    alone, (first,) = stage_of((plain, (5, 0, 0)))
    mixed, (_, second) = stage_of((flock_role(), (0, 0, 0)), (plain, (5, 0, 0)))
    alone.step(20)
    mixed.step(20)
    assert first.root.position.tolist() == second.root.position.tolist() == [5, 0, 0]


def test_the_heading_turns_no_faster_than_it_may():
    stage, (bird,) = stage_of((flock_role(goal=GoalDefinition((30, 0, 0))), (0, 0, 0)))
    headings = [(stage.step(), bird.root.heading)[1] for _ in range(90)]
    assert max(np.diff([0, *headings])) == pytest.approx(np.radians(90) / 60)
    assert headings[-1] == pytest.approx(np.pi / 2, abs=0.02)


def test_the_heading_takes_the_shorter_way_round():
    stage = Stage()
    bird = stage.add(
        flock_role(goal=GoalDefinition((0, 0, -30))), (0, 0, 0), -3.0
    )  # it flies at π, which is −π
    stage.step(30)
    assert bird.root.heading == pytest.approx(-np.pi, abs=0.02)


def test_speed_climb_and_turn_are_set_within_their_bounds():
    stage, _ = stage_of(
        (
            flock_role(
                sets={"speed": "pace", "climb": "rise", "turn": "lean"}, goal=GoalDefinition((9, 9, 0))
            ),
            (0, 0, 0),
        )
    )
    stage.step(10)
    pace, rise, lean = stage.casts[0].machine.parameters[0]
    velocity = stage.state.flights[0].velocity[0]
    assert pace == pytest.approx(min(np.linalg.norm(velocity), 2))
    assert rise == pytest.approx(velocity[1])
    assert lean == pytest.approx(np.radians(90))


def test_a_goal_goes_round_to_the_left():
    stage, (bird,) = stage_of((flock_role(goal=GoalDefinition((0, 0, 0), 1, 4)), (1, 0, 0)))
    stage.step(240)
    places = [(stage.step(), bird.root.position)[1] for _ in range(240)]
    x, _, z = np.array(places).T
    turned = np.unwrap(np.arctan2(-z, x))
    assert turned[-1] - turned[0] == pytest.approx(2 * np.pi, rel=0.02)


def test_obstacles_are_kept_out_of():
    ball = ObstacleDefinition("sphere", (0, 0, 5), 2)
    stage, (bird,) = stage_of((flock_role(obstacles=(ball,), goal=GoalDefinition((0, 0, 12))), (0, 0, 0)))
    nearest = min(np.linalg.norm((stage.step(), bird.root.position)[1] - (0, 0, 5)) for _ in range(400))
    assert nearest >= 2 - 1e-6
    assert bird.root.position[2] > 8


def test_colliders_of_others_are_avoided_where_they_are_named():
    tower = replace(
        definition(), name="tower", colliders={"tower": ColliderDefinition("sphere", 1, radius=2.0)}
    )
    tower_role = Role.build("tower", character(), tower, "hips")
    stage, (bird, _) = stage_of(
        (flock_role(avoid=("tower",), goal=GoalDefinition((0, 0.1, 12))), (0, 0, 0)), (tower_role, (0, 0, 5))
    )
    assert (
        min(np.linalg.norm((stage.step(), bird.root.position)[1] - (0, 0, 5)) for _ in range(400)) >= 2 - 1e-6
    )


def test_members_may_come_and_go_in_flight():
    role = flock_role(goal=None)
    stage, (first, second) = stage_of((role, (0, 0, 0)), (role, (0.5, 0, 0)))
    stage.step(30)
    before = stage.state.flights[0].velocity[1].copy()
    stage.remove(first)
    stage.step()
    assert stage.state.flights[0].ids.tolist() == [second.id]
    np.testing.assert_allclose(stage.state.flights[0].velocity[0], before)  # it sees nobody, and flies on
    stage.add(role, (2, 0, 0))
    stage.step()
    assert len(stage.state.flights[0].ids) == 2


def test_no_flock_no_flight():
    stage, _ = stage_of((Role.build("plain", character(), definition(), "hips"), (0, 0, 0)))
    stage.step()
    assert stage.state.flights == ()


def test_chance_is_of_seed_actor_and_tick():
    def places(seed, extra):
        role = flock_role(wander=30, reach=0.5, goal=None)
        stage = Stage(seed=seed)
        birds = [stage.add(role, (5 * number, 0, 0)) for number in range(2 + extra)]
        stage.step(20)
        return [bird.root.position.tolist() for bird in birds[:2]]

    assert places(1, 0) == places(1, 5)
    assert places(1, 0) != places(2, 0)
    first, second = places(1, 0)
    assert first != [second[0] - 5, *second[1:]]
