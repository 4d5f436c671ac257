"""Why not: single changes that make an event fire.

Each is applied here by hand, on a stage of its own, and the event seen to fire.
"""

import pytest
from playing import STATES, role_of, text_of
from statwalk.errors import StageError, UnknownNameError
from statwalk.stage.explain.counterfactual import tried
from statwalk.stage.explain.whynot import whynot
from statwalk.stage.stage import Stage

PLAIN = text_of()
TIRED = text_of(more='cells:\n  STAND/HOP: [{if: "stamina > 10 and pace < 1.5", to: HOP}]')
IN_STEP = text_of(more="cells:\n  WALK/HOP: {when: marker left-down}")
SENSED = text_of(more='senses:\n  FAINT: {when: stamina < 2}\ncells:\n  "*/FAINT": {to: TURN}')
OFF = text_of(more="cells:\n  STAND/GO: {off: true, to: TURN}")


def asked(text, *events, ticks=20, event="HOP"):
    """A stage in which events were sent in ticks 1, 11, 21 …, and the question about the last tick."""
    stage = Stage(seed=2)
    actor = stage.add(role_of(text))
    for one in events:
        stage.send(actor, one)
        stage.step(10)
    stage.step(ticks - 10)
    return stage, whynot(stage, 1, event, stage.tick - ticks + 1)


def of_kind(answer, kind):
    return next(one for one in answer.remedies if one.kind == kind)


def test_what_has_fired_needs_no_remedy():
    _, answer = asked(PLAIN, "GO", event="GO")
    assert (answer.fired, answer.reason, answer.remedies) == (True, "taken in STAND", ())


def test_what_nobody_sent_is_sent():
    _, answer = asked(PLAIN, "GO", ticks=5)
    assert (answer.fired, answer.reason) == (False, "it was not sent in this tick")
    assert answer.remedies[0].change == {"kind": "send", "event": "HOP", "tick": 6}


def test_a_condition_names_the_nearest_value_that_makes_it_true():
    _, answer = asked(TIRED, "HOP")
    first = answer.remedies[0]
    assert (first.kind, first.change["parameter"], first.change["value"], first.fires) == (
        "set",
        "stamina",
        pytest.approx(10.1),
        1,
    )
    stage = Stage(seed=2)
    actor = stage.add(role_of(TIRED))
    stage.set(actor, "stamina", first.change["value"])
    stage.send(actor, "HOP")
    stage.step()
    assert actor.state == "HOP"


def test_a_value_that_is_not_enough_alone_is_not_offered():
    stage = Stage()
    actor = stage.add(role_of(TIRED))
    stage.set(actor, "pace", 2.0)
    stage.send(actor, "HOP")
    stage.step(20)
    assert "set" not in [one.kind for one in whynot(stage, 1, "HOP", 1).remedies]


def test_a_sense_names_the_value_that_raises_its_event():
    _, answer = asked(SENSED, "STOP", event="FAINT")
    assert answer.reason == "stamina < 2 is not true: stamina 8"
    assert answer.remedies[0].change == {"kind": "send", "event": "FAINT", "tick": 1}
    value = of_kind(answer, "set").change["value"]
    stage = Stage(seed=2)
    actor = stage.add(role_of(SENSED))
    stage.set(actor, "stamina", value)
    stage.step()
    assert actor.state == "TURN"


def test_a_touch_is_named():
    stage = Stage()
    stage.add(role_of(text_of(more="colliders: {body: {sphere: 0.4}}\nsenses: {HOP: {touch: [body, ball]}}")))
    stage.step(5)
    assert whynot(stage, 1, "HOP", 3).reason == "no ball came to touch its body in the tick before"


def test_a_sense_that_is_on_is_named():
    stage = Stage()
    actor = stage.add(role_of(SENSED))
    stage.set(actor, "stamina", 1)
    stage.step(100)
    assert whynot(stage, 1, "FAINT", 80).reason == "stamina < 2 has been sensed already, and was not released"


def test_what_waits_for_a_marker_names_its_tick():
    """WALK begins in tick 1; half of its second is over in tick 31."""
    _, answer = asked(IN_STEP, "GO", "HOP", ticks=40)
    first = answer.remedies[0]
    assert (first.kind, first.fires, first.text) == ("moment", 31, "HOP in tick 31, 0.33 s later")


def test_a_blank_cell_names_the_next_state_in_which_it_fires():
    """HOP lasts half a second, 30 ticks; TURN is blank in it, and not in STAND."""
    _, answer = asked(PLAIN, "HOP", "TURN", event="TURN", ticks=40)
    assert of_kind(answer, "moment").fires == 32
    assert of_kind(answer, "buffer").change["seconds"] == pytest.approx(22 / 60, abs=1e-3)
    assert of_kind(answer, "hold").fires == 32


def test_the_way_to_another_state_is_given():
    _, answer = asked(PLAIN, "STOP", event="STOP")
    remedy = of_kind(answer, "state")
    assert (remedy.change["state"], [one["event"] for one in remedy.change["steps"]]) == ("WALK", ["GO"])
    stage = Stage(seed=2)
    actor = stage.add(role_of(PLAIN))
    stage.travel(actor, "WALK")
    stage.step()
    stage.send(actor, "STOP")
    stage.step()
    assert stage.verdicts[-1][3:5] == ("STOP", "taken")


def test_a_cell_that_is_off_is_put_back():
    _, answer = asked(OFF, "GO", event="GO")
    assert of_kind(answer, "cell").change | {"kind": ""} == {
        "kind": "",
        "layer": 0,
        "state": "STAND",
        "event": "GO",
        "to": "TURN",
        "restart": False,
        "text": "TURN",
    }


def test_an_end_that_nothing_answers_gets_a_cell():
    stage, _ = asked(PLAIN, "GO")
    (remedy,) = whynot(stage, 1, "END", 15).remedies
    assert (remedy.change["state"], remedy.change["event"], remedy.fires) == ("WALK", "END", 61)


def test_what_is_held_is_released_first():
    stage = Stage()
    actor = stage.add(role_of(PLAIN))
    stage.hold(actor, "TURN")
    stage.step(70)  # the second turn: TURN is held, and blank there
    stage.hold(actor, "TURN")
    stage.step(5)
    assert "held already" in whynot(stage, 1, "TURN", 71).reason


@pytest.mark.parametrize(
    ("text", "events", "event", "ticks"),
    [
        (TIRED, ["HOP"], "HOP", 20),
        (IN_STEP, ["GO", "HOP"], "HOP", 40),
        (PLAIN, ["HOP", "TURN"], "TURN", 40),
        (PLAIN, ["STOP"], "STOP", 20),
        (OFF, ["GO"], "GO", 20),
        (PLAIN, ["HOP"], "END", 20),
    ],
)
def test_the_first_remedy_makes_it_fire(text, events, event, ticks):
    stage, answer = asked(text, *events, event=event, ticks=ticks)
    before, tick = stage.hash, stage.tick - ticks + 1
    first = answer.remedies[0]
    trial = tried(stage, 1, event, tick, first.change)
    fired = [(one.event, one.verdict, one.tick) for one in trial.stage.effects.verdicts if one.event == event]
    assert (event, "taken", first.fires) in fired
    assert stage.hash == before


def test_what_would_be_watched_for_too_long_is_named_and_not_tried():
    """TURN lasts half a second, at that speed for 25 s; until then its cells are blank."""
    states = STATES.replace("TURN: {motion: turn}", "TURN: {motion: turn, speed: 0.02}")
    stage = Stage()
    actor = stage.add(role_of(text_of(states=states)))
    stage.send(actor, "TURN")
    stage.step(20)
    answer = whynot(stage, 1, "GO", 10)
    assert {"moment", "hold", "buffer"}.isdisjoint(one.kind for one in answer.remedies)
    assert answer.cut.startswith("not tried to the end, for the stage would have to be played for more than ")
    assert answer.cut.endswith("s: a later tick")
    assert of_kind(answer, "cell").fires == 10


def test_what_was_tried_to_its_end_is_not_said_to_be_cut():
    _, answer = asked(PLAIN, "HOP", "TURN", event="TURN", ticks=40)
    assert answer.cut == ""


def test_remedies_come_cheapest_first():
    _, answer = asked(PLAIN, "HOP", "TURN", event="TURN", ticks=40)
    kinds = [one.kind for one in answer.remedies]
    assert kinds.index("moment") < kinds.index("buffer") < kinds.index("cell")


def test_what_is_not_there_is_named():
    stage, _ = asked(PLAIN, "GO")
    with pytest.raises(UnknownNameError, match="no event is called 'JUMP'"):
        whynot(stage, 1, "JUMP", 1)
    with pytest.raises(UnknownNameError, match="no actor is called '9'"):
        whynot(stage, 9, "GO", 1)
    with pytest.raises(StageError, match="0 … 20"):
        whynot(stage, 1, "GO", 99)
    with pytest.raises(StageError, match="the first step makes tick 1"):
        whynot(stage, 1, "GO", 0)
