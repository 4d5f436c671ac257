"""CD4 collisions are events (FAQ Q19, Q30): who touches whom in a tick is an event of the next one, for
whoever has a sense for it.
"""

import numpy as np
import pytest
from builders import character
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.rig.model_buffer import ModelBuffer
from statwalk.services.library.load import load
from statwalk.stage.stage import Stage

MACHINE = """
character: c.glb
initial: IDLE
root: hips
states:
  IDLE: {{motion: {motion}, loop: true}}
table: |
  state | {events}
  IDLE  | {cells}
colliders: {{{colliders}}}
senses: {{{senses}}}
"""
BODY = "body: {sphere: 0.5}"


def role(name, senses="", colliders=BODY, motion="stand", events="NEVER"):
    """A machine whose events do nothing but leave a verdict."""
    names = [one.split(":")[0].strip() for one in senses.split(";") if one]
    columns = " | ".join(names or [events])
    text = MACHINE.format(
        motion=motion,
        events=columns,
        cells=" | ".join("IDLE" for _ in columns.split("|")),
        colliders=colliders,
        senses=senses.replace(";", ", "),
    )
    return Role.build(name, character(), read_machine(text, name), "hips")


def heard(stage, actor, ticks):
    """(tick, event) of what an actor takes in so many ticks."""
    found = []
    for _ in range(ticks):
        stage.step()
        found += [
            (one.tick, one.event)
            for one in stage.effects.verdicts
            if one.actor == actor.id and one.verdict == "taken"
        ]
    return found


def stage_with(*roles_and_places):
    stage = Stage()
    return stage, [
        stage.add(one, position=place, heading=heading) for one, place, heading in roles_and_places
    ]


def test_a_monster_touches_a_player_who_hears_of_it_in_the_next_tick():
    player = role("player", "HIT: {touch: [body, claw]}")
    monster = role("monster", colliders="claw: {sphere: 0.3}", motion="walk")
    # the monster walks 1.5 m/s along +Z from 2 m behind: the spheres meet when 1.2 m are gone, at 0.8 s, in
    # tick 48 (or by rounding 49)
    stage, (hit, other) = stage_with((player, (0, 0, 0), 0), (monster, (0, 0, -2), 0))
    assert heard(stage, hit, 60) in ([(49, "HIT")], [(50, "HIT")])
    assert stage.state.casts["monster"].ids.tolist() == [other.id]


def test_the_event_knows_who_where_and_when():
    stage, (hit, other) = stage_with(
        (role("player", "HIT: {touch: [body, claw]}"), (0, 0, 0), 0),
        (role("monster", colliders="claw: {sphere: 0.3}"), (0.6, 0, 0), 0),
    )
    stage.step()
    (raised,) = stage.state.inbox
    assert (raised.actor, raised.event, raised.other, raised.time) == (hit.id, "HIT", other.id, 0)
    assert raised.point == pytest.approx((0.6 * 0.5 / 0.8, 0, 0))
    stage.step()
    (verdict,) = stage.effects.verdicts
    assert (verdict.event, verdict.other) == ("HIT", other.id)
    assert verdict.reason.startswith("touched at 0.38, 0.00, 0.00 m, 0.00 into the tick")


def test_enter_stay_leave():
    """The monster walks through: one enter, a stay for each tick after it, one leave."""
    player = role(
        "player",
        "IN: {touch: [body, claw]};STAY: {touch: [body, claw], on: stay};OUT: {touch: [body, claw], on: "
        "leave}",
    )
    stage, (hit, _) = stage_with(
        (player, (0, 0, 0), 0),
        (role("monster", colliders="claw: {sphere: 0.3}", motion="walk"), (0, 0, -2), 0),
    )
    events = heard(stage, hit, 180)
    assert [event for _, event in events if event != "STAY"] == ["IN", "OUT"]
    (first, _), (last, _) = events[0], events[-1]
    assert [tick for tick, event in events if event == "STAY"] == list(range(first + 1, last))
    assert last - first == pytest.approx(1.6 / 1.5 * 60, abs=1.5)  # 1.6 m of overlap at 1.5 m/s


def test_who_goes_right_through_within_a_tick_enters_and_leaves():
    wire = "wire: {plane: [0, 0, 1], at: [0, 1, 0], radius: 2}"
    player = role("door", "IN: {touch: [wire, tip]};OUT: {touch: [wire, tip], on: leave}", colliders=wire)
    # a point on the walker's chest: it crosses the plane within one tick, and is on neither side for long
    stage, (door, _) = stage_with(
        (player, (0, 0, 0), 0),
        (role("walker", colliders="tip: {sphere: 0, joint: chest}", motion="walk"), (0, 0, -0.7), 0),
    )
    events = heard(stage, door, 60)
    assert [event for _, event in events] == ["IN", "OUT"]
    assert (
        events[0][0] == events[1][0] == 30
    )  # 0.7 m at 0.025 m a tick: in the 28th or 29th, heard in the one after


def test_nobody_touches_itself():
    stage, (only,) = stage_with(
        (role("twin", "HIT: {touch: [left, right]}", "left: {sphere: 1}, right: {sphere: 1}"), (0, 0, 0), 0)
    )
    assert heard(stage, only, 3) == []


def test_both_hear_of_it_where_both_have_the_sense():
    one = role("bumper", "HIT: {touch: [body, body]}")
    stage, (first, second, far) = stage_with((one, (0, 0, 0), 0), (one, (0.9, 0, 0), 0), (one, (5, 0, 0), 0))
    stage.step(2)
    assert [(each.actor, each.event, each.other) for each in stage.effects.verdicts] == [
        (first.id, "HIT", second.id),
        (second.id, "HIT", first.id),
    ]
    assert far.id not in {each.actor for each in stage.verdicts}


def test_who_is_put_right_onto_another_enters():
    one = role("bumper", "HIT: {touch: [body, body]}")
    stage, (first,) = stage_with((one, (0, 0, 0), 0))
    stage.step(5)
    stage.add(one, position=(0.1, 0, 0))
    assert heard(stage, first, 3) == [(7, "HIT")]


def test_who_is_left_alone_hears_that_the_other_is_gone():
    one = role("bumper", "OUT: {touch: [body, body], on: leave}")
    stage, (first, second) = stage_with((one, (0, 0, 0), 0), (one, (0.1, 0, 0), 0))
    stage.step(5)
    stage.remove(second)
    assert heard(stage, first, 3) == [(7, "OUT")]


def test_a_collider_rides_on_its_joint_and_turns_with_the_actor():
    arm = role("arm", colliders="tip: {sphere: 0.1, joint: arm, at: [0.2, 0, 0]}")
    stage, (actor,) = stage_with((arm, (10, 0, 0), np.pi / 2))
    model = ModelBuffer.room(arm.colliders.joints, 1)
    model.fill(stage.casts[0].shown)
    placed = arm.colliders.placed(model, np.array([[10.0, 0, 0]]), np.array([np.pi / 2]))
    expected = actor.world[2] @ [0.2, 0, 0, 1]
    np.testing.assert_allclose(placed.center[0, 0], expected[:3], atol=1e-6)


def test_a_joint_that_is_not_there_is_an_error_with_its_line():
    with pytest.raises(
        MachineError, match=r"line 10: collider tip: no joint is called 'arn'; did you mean arm"
    ):
        role("arm", colliders="tip: {sphere: 0.1, joint: arn}")


def test_the_same_touches_whatever_else_is_on_the_stage():
    def told(crowd):
        one = role("bumper", "HIT: {touch: [body, body]}")
        stage, (first, _) = stage_with(
            (one, (0, 0, 0), 0), (role("monster", motion="walk"), (0.03, 0, -2.01), 0.01)
        )
        for number in range(crowd):
            stage.add(one, position=(20 + number, 0, 7))
        events = [
            each
            for _ in range(120)
            for each in (stage.step(), stage.state.inbox)[1]
            if each.actor == first.id
        ]
        return events, first.hash

    assert told(0) == told(40)
    assert told(0)[0]


def test_going_back_in_time_finds_the_same_touches():
    one = role("bumper", "IN: {touch: [body, body]};OUT: {touch: [body, body], on: leave}")
    stage, _ = stage_with((one, (0, 0, 0), 0), (role("monster", motion="walk"), (0, 0, -2), 0))
    hashes = [(stage.step(), stage.hash)[1] for _ in range(150)]
    stage.seek(40)
    assert [(stage.step(), stage.hash)[1] for _ in range(110)] == hashes[40:]


def test_a_shipped_machine_that_touches_nothing_pays_nothing():
    stage = Stage()
    stage.add(load("faq-walker"))
    stage.step()
    assert stage.state.contacts.bodies is None
