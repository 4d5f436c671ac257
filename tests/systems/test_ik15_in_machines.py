"""IK15 solvers in machine files and in the tick: targets are parameters, weights follow states, no pops."""

import numpy as np
import pytest
from reaching import ARM, joint, role_of
from statwalk.errors import MachineError
from statwalk.stage.stage import Stage

GRIP = (1.05, 1.2, 2.45)
HEAD = "look: {solver: look-at, chain: [Head], target: grip, weight: part, cone_deg: 70}"


def standing(*solvers, place=(1.0, 0.0, 2.0), heading=0.6):
    stage = Stage()
    return stage, stage.add(role_of(*solvers), place, heading)


@pytest.mark.parametrize("solver", ["two-bone", "ccd", "fabrik", "force"])
def test_a_hand_comes_to_a_point_on_the_stage(solver):
    stage, actor = standing(f"reach: {{solver: {solver}, chain: {ARM}, target: grip}}")
    stage.set(actor, "grip", GRIP)
    stage.step(90)
    np.testing.assert_allclose(joint(actor, "Right.hand"), GRIP, atol=1e-4)
    assert actor.reached["reach"].distance == pytest.approx(
        np.linalg.norm(joint(actor, "Right.hand") - GRIP), abs=3e-5
    )
    assert actor.reached["reach"].weight == 1
    assert actor.reached["reach"].reached


def test_a_point_in_model_space_goes_with_the_actor():
    stage, actor = standing(f"reach: {{solver: two-bone, chain: {ARM}, target: grip, space: model}}")
    stage.step()
    inside = actor.matrix[:, :3].T @ (joint(actor, "Right.hand") - actor.matrix[:, 3])
    np.testing.assert_allclose(inside, (-0.35, 1.2, 0.3), atol=1e-5)


def test_the_pole_bends_the_elbow_to_its_side():
    elbows = []
    for side in (1.0, -1.0):
        stage, actor = standing(f"reach: {{solver: two-bone, chain: {ARM}, target: grip, pole: side}}")
        stage.set(actor, "grip", GRIP)
        stage.set(actor, "side", (0.0, side, 0.0))
        stage.step(2)
        elbows.append(joint(actor, "Right.lowerarm")[1])
    assert elbows[0] > elbows[1] + 0.1


def test_without_weight_every_bit_of_the_pose_stays():
    stage, actor = standing(f"reach: {{solver: ccd, chain: {ARM}, target: grip, weight: 0}}")
    bare, other = standing("idle: {solver: look-at, chain: [Head], target: grip, weight: 0}")
    stage.step(30)
    bare.step(30)
    assert (actor.pose.rotation == other.pose.rotation).all()
    assert actor.reached["reach"] == ("reach", 0, 0, False)


def test_a_weight_by_state_is_eased_both_ways():
    stage, actor = standing(
        f"reach: {{solver: two-bone, chain: {ARM}, target: grip, space: model, "
        "weight: {WALK: 0.5}, ease: 0.2}"
    )
    stage.step(5)
    assert actor.reached["reach"].weight == 0
    stage.send(actor, "GO")
    stage.step(4)
    assert 0.05 < actor.reached["reach"].weight < 0.45
    stage.step(30)
    assert actor.reached["reach"].weight == 0.5
    stage.send(actor, "STOP")
    stage.step(60)
    assert actor.reached["reach"].weight == 0


def test_a_weight_by_state_may_be_a_parameter():
    stage, actor = standing(
        f"reach: {{solver: two-bone, chain: {ARM}, target: grip, space: model, "
        "weight: {STAT: 0.25, WALK: part}, ease: 0}"
    )
    stage.set(actor, "part", 0.75)
    stage.step(2)
    assert actor.reached["reach"].weight == 0.25
    stage.send(actor, "GO")
    stage.step(60)
    assert actor.reached["reach"].weight == 0.75
    stage.set(actor, "part", 0.5)
    stage.step(2)
    assert actor.reached["reach"].weight == 0.5


def fastest(chain, weight, step):
    """The most degrees that the chain's first joint turns in one tick of going and stopping."""
    stage, actor = standing(f"reach: {{{chain}, target: grip, space: model, weight: part}}")
    stage.set(actor, "part", weight)
    stage.step(20)
    row = actor.role.character.skeleton.index("Head" if "Head" in chain else "Right.upperarm")
    turns, before = [], actor.pose.rotation[row].astype(float)
    for tick in range(100):
        if tick in (10, 40, 52):
            stage.send(actor, "GO" if tick == 10 or tick == 52 else "STOP")
        stage.step()
        now = actor.pose.rotation[row].astype(float)
        turns.append(np.degrees(2 * np.arccos(min(1.0, abs(now @ before)))))
        before = now
    return turns[step] if step is not None else max(turns)


@pytest.mark.parametrize("weight", [0.3, 0.7, 1.0])
@pytest.mark.parametrize(
    "chain",
    [f"solver: two-bone, chain: {ARM}", "solver: look-at, chain: [Head]", f"solver: fabrik, chain: {ARM}"],
)
def test_a_transition_during_a_reach_does_not_pop(chain, weight):
    assert fastest(chain, weight, None) < 2.6  # degrees; a second pull of weight 0.7 would turn by 5 to 20


def test_a_force_travels_and_does_not_snap():
    stage, actor = standing(
        f"reach: {{solver: force, chain: {ARM}, target: grip, weight: part, travel: 0.5}}"
    )
    stage.set(actor, "part", 0.0)
    stage.set(actor, "grip", GRIP)
    stage.step(10)
    path = [joint(actor, "Right.hand")]
    stage.set(actor, "part", 1.0)
    for _ in range(60):
        stage.step()
        path.append(joint(actor, "Right.hand"))
    steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
    whole = np.linalg.norm(path[-1] - path[0])
    assert whole > 0.4
    assert steps.max() < 0.12 * whole
    np.testing.assert_allclose(path[-1], GRIP, atol=1e-3)


def test_out_of_reach_a_force_points_at_its_target():
    stage, actor = standing(f"reach: {{solver: force, chain: {ARM}, target: grip}}")
    stage.set(actor, "grip", (400.0, 1.0, 2.0))
    stage.step(120)
    shoulder, hand = joint(actor, "Right.upperarm"), joint(actor, "Right.hand")
    aim = (np.array([400.0, 1.0, 2.0]) - shoulder) / np.linalg.norm([400.0 - shoulder[0], 0, 0])
    assert (hand - shoulder) @ aim / np.linalg.norm(hand - shoulder) > 0.999
    assert actor.reached["reach"].distance > 390
    assert not actor.reached["reach"].reached


def test_a_look_stays_in_its_cone():
    stage, actor = standing(HEAD, place=(0, 0, 0), heading=0.0)
    row = actor.role.character.skeleton.index("Head")
    for target, angle, reached in (((1.0, 1.5, 1.0), 45, True), ((1.0, 1.5, -8.0), 70, False)):
        stage.set(actor, "grip", target)
        stage.step(2)
        sight = actor.world[row, :3, 2]
        assert np.degrees(np.arccos(sight[2])) == pytest.approx(angle, abs=5)
        assert actor.reached["look"].reached is reached
    assert np.degrees(np.arccos(sight[2])) == pytest.approx(70, abs=0.1)


def test_alone_and_in_a_crowd_and_replayed_the_bits_are_the_same():
    solvers = (f"reach: {{solver: force, chain: {ARM}, target: grip}}", HEAD)
    role = role_of(*solvers)
    stage = Stage(seed=4)
    actors = [stage.add(role, (0.1 * k, 0, 0)) for k in range(19)]
    alone = Stage(seed=4)
    lone = alone.add(role, (0.0, 0, 0))
    for where, who in ((stage, actors[0]), (alone, lone)):
        where.set(who, "grip", (0.4, 1.3, 0.4))
        where.step(20)
        where.send(who, "GO")
        where.step(30)
    assert actors[0].hash == lone.hash
    after = stage.hash
    stage.seek(25)
    stage.seek(50)
    assert stage.hash == after


@pytest.mark.parametrize(
    ("solver", "words"),
    [
        (
            "solver: two-bone, chain: [Right.uperarm, Right.lowerarm, Right.hand], target: grip",
            "Right.upperarm",
        ),
        ("solver: two-bone, chain: [Right.upperarm, Right.hand], target: grip", "three joints"),
        ("solver: ccd, chain: [Right.hand, Right.upperarm], target: grip", "not below"),
        (f"solver: ccd, chain: {ARM}, target: grip, sensitivity: {{Head: 0.5}}", "Head"),
    ],
)
def test_wrong_joints_are_refused_with_the_line(solver, words):
    with pytest.raises(MachineError, match=words) as caught:
        role_of(f"reach: {{{solver}}}")
    assert "line 12" in str(caught.value)
