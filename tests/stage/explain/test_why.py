"""Why: event -> cell -> what it saw -> verdict -> blend -> joints, for any tick, from the log alone."""

import numpy as np
import pytest
from builders import CLIPS, role
from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.definition.cell_definition import CellDefinition
from statwalk.stage.explain.why import why
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage

ROLE = role(
    cells={
        ("STAND", "GO"): CellDefinition("WALK", 7, blend=0.3, curve="quintic"),
        ("*", "STOP"): CellDefinition("", 9, off=True),
    }
)


@pytest.fixture
def stage():
    """GO in tick 11, STOP in 41 (WALK), HOP in 51, TURN in 52, where it waits."""
    stage = Stage(seed=1)
    actor = stage.add(ROLE)
    for ticks, event in ((10, "GO"), (30, "STOP"), (10, "HOP"), (1, "TURN")):
        stage.step(ticks)
        stage.send(actor, event)
    stage.step(60)
    return stage


def test_an_event_is_followed_to_its_cell_and_blend(stage):
    (one,) = why(stage, 1, 11).events
    assert (one.event, one.verdict, one.from_state, one.to_state) == ("GO", "taken", "STAND", "WALK")
    assert (one.cell, one.source, one.line) == (("STAND", "GO"), "cell", 7)
    assert (one.blend_seconds, one.curve) == (pytest.approx(0.3), "quintic")


def test_the_joints_are_those_between_what_was_shown_and_what_begins(stage):
    """Only the arm differs: it was where standing had brought it in tick 10, and walking begins at its first
    key.
    """
    (one,) = why(stage, 1, 11).events
    shown, begun = CLIPS["stand"].sample(10 / 60).rotation[2], CLIPS["walk"].sample(0).rotation[2]
    between = 2 * np.degrees(np.arccos(abs(float(np.dot(shown.astype(np.float64), begun)))))
    assert [(moved.joint, moved.degrees) for moved in one.joints if moved.degrees > 0.01] == [
        ("arm", pytest.approx(between, abs=0.01))
    ]


def test_the_cell_is_named_as_it_is_written(stage):
    (one,) = [one for one in why(stage, 1, 41).events if one.event == "STOP"]
    assert (one.cell, one.verdict, one.to_state) == (("WALK", "STOP"), "taken", "STAND")


def test_what_waits_has_a_reason_and_no_blend(stage):
    (one,) = why(stage, 1, 52).events
    assert (one.event, one.verdict, one.cell, one.blend_seconds, one.joints) == (
        "TURN",
        "waits",
        None,
        None,
        (),
    )
    assert "blank" in one.reason


def test_a_default_is_named_as_one():
    stage = Stage()
    stage.send(
        stage.add(
            role(cells={("*", "STOP"): CellDefinition("STAND", 9)}, table="state | STOP\nSTAND |\nWALK |")
        ),
        "STOP",
    )
    stage.step()
    (one,) = why(stage, 1, 1).events
    assert (one.cell, one.source, one.line) == (("*", "STOP"), "column default", 9)


def test_a_tick_without_events_says_where_the_actor_is_and_since_when(stage):
    quiet = why(stage, 1, 30)
    assert (quiet.states, quiet.since, quiet.events) == (("WALK",), (11,), ())


def test_tick_0_has_no_events(stage):
    assert why(stage, 1, 0).events == ()


def test_it_moves_nothing(stage):
    before = stage.hash
    why(stage, 1, 11)
    assert (stage.tick, stage.hash) == (111, before)


def test_a_replay_gives_the_same_reasons(stage):
    again = replay(stage.dump(), {"tiny": ROLE}.__getitem__)
    assert [why(again, 1, tick) for tick in (11, 41, 51, 52)] == [
        why(stage, 1, tick) for tick in (11, 41, 51, 52)
    ]


def test_others_are_left_out(stage):
    stage.send(stage.add(ROLE), "GO")
    stage.send(1, "STOP")
    stage.step()
    assert [one.event for one in why(stage, 2, stage.tick).events] == ["GO"]


def test_what_is_not_there_is_named(stage):
    with pytest.raises(UnknownNameError, match="There are: 1"):
        why(stage, 7, 11)
    with pytest.raises(StageError, match=r"0 … 111"):
        why(stage, 1, 112)
