"""Travelling: an actor goes to a state by the shortest way; the plan is told, can be followed, and can be
called off.
"""

import pytest
from playing import TABLE, role_of, text_of
from statwalk.errors import StageError, UnknownNameError
from statwalk.stage.stage import Stage

ONE_WAY = """
state | GO   | HOP | END
STAND | WALK |     |
WALK  |      | HOP |
HOP   |      |     | TURN
TURN  |      |     |
"""
ROLE = role_of(text_of(ONE_WAY))


def on_the_way(to="TURN"):
    stage = Stage()
    actor = stage.add(ROLE)
    return stage, actor, stage.travel(actor, to)


def test_the_plan_names_the_events_and_the_time():
    _, _, plan = on_the_way()
    assert [(step.state, step.event) for step in plan.steps] == [
        ("STAND", "GO"),
        ("WALK", "HOP"),
        ("HOP", "END"),
    ]
    assert plan.seconds == pytest.approx(0.5, abs=0.1)


def test_an_actor_follows_the_plan():
    """GO in tick 1, HOP in tick 2; it lasts half a second, 30 ticks."""
    stage, actor, _ = on_the_way()
    seen = []
    for _ in range(40):
        stage.step()
        seen.append(actor.state)
    assert [(state, seen.index(state) + 1) for state in dict.fromkeys(seen)] == [
        ("WALK", 1),
        ("HOP", 2),
        ("TURN", 32),
    ]


def test_on_arrival_the_goal_is_gone():
    stage, _, _ = on_the_way()
    stage.step(40)
    assert stage.casts[0].machine.goal.tolist() == [-1]


def test_who_is_there_already_has_no_way_to_go():
    stage, actor, plan = on_the_way("STAND")
    stage.step(5)
    assert (plan.steps, plan.seconds, actor.state) == ((), 0, "STAND")


def test_a_journey_can_be_called_off():
    stage, actor, _ = on_the_way()
    stage.step()
    stage.cancel_travel(actor)
    stage.step(40)
    assert actor.state == "WALK"


def test_another_goal_takes_the_place_of_the_first():
    stage, actor, _ = on_the_way()
    stage.travel(actor, "WALK")
    stage.step(40)
    assert actor.state == "WALK"


def test_whoever_is_pushed_aside_finds_another_way():
    stage = Stage()
    actor = stage.add(role_of(text_of(TABLE)))
    stage.travel(actor, "HOP")
    stage.send(actor, "TURN")  # counts, for it comes first in the tick; HOP is blank in TURN
    stage.step()
    assert actor.state == "TURN"
    stage.step(20)  # STOP leads out of TURN, which would take a second
    assert (actor.state, stage.casts[0].machine.goal.tolist()) == ("HOP", [-1])


def test_where_no_way_leads_it_is_said_what_can_be_reached():
    stage, actor, _ = on_the_way()
    stage.step(10)
    with pytest.raises(StageError, match="no way leads from HOP to WALK; from there can be reached: TURN"):
        stage.travel(actor, "WALK")


def test_an_unknown_state_is_named():
    stage, actor, _ = on_the_way()
    with pytest.raises(UnknownNameError, match="no state is called 'WAKL'; did you mean WALK"):
        stage.travel(actor, "WAKL")


def test_an_event_that_does_not_help_at_once_is_sent_again():
    text = text_of(ONE_WAY, more='cells:\n  STAND/GO: [{if: "stamina > 10", to: WALK}]')
    stage = Stage()
    actor = stage.add(role_of(text))
    stage.travel(actor, "WALK")
    stage.step(100)
    assert actor.state == "STAND"
    stage.set(actor, "stamina", 12)
    stage.step(15)
    assert actor.state == "WALK"


def test_an_event_that_waits_is_not_sent_again():
    stage = Stage()
    actor = stage.add(role_of(text_of(ONE_WAY, more="cells:\n  STAND/GO: {to: WALK, when: end}")))
    stage.travel(actor, "WALK")
    stage.step(121)
    assert [one.verdict for one in stage.verdicts if one.event == "GO"] == ["waits", "taken"]
    assert actor.state == "WALK"
