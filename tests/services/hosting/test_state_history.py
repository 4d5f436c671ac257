"""The history of states where a stage remembers no more than its newest verdicts."""

from collections import deque

from statwalk.services.hosting.state_history import state_changes
from statwalk.services.library.load import load
from statwalk.stage.replay import replay
from statwalk.stage.stage import LONGEST_HISTORY, Stage
from statwalk.stage.state.frame import Verdict


def test_a_full_memory_begins_with_its_oldest_verdict() -> None:
    stage = Stage()
    stage.add(load("faq-walker"))
    oldest = Verdict(500, 1, 0, "FORWARD", "taken", "", "WALK", "")
    stage.verdicts = deque([oldest] * LONGEST_HISTORY, maxlen=LONGEST_HISTORY)
    assert [(change.tick, change.state) for change in state_changes(stage)] == [(500, "WALK")]


def test_who_has_no_verdict_in_a_full_memory_is_where_it_was() -> None:
    stage = Stage()
    busy, _ = stage.add(load("faq-walker")), stage.add(stage.roles["faq-walker"])
    stage.step(10)
    oldest = Verdict(5, busy.id, 0, "FORWARD", "taken", "", "WALK", "")
    stage.verdicts = deque([oldest] * LONGEST_HISTORY, maxlen=LONGEST_HISTORY)
    assert [(change.tick, change.actor, change.state) for change in state_changes(stage)] == [
        (5, 1, "WALK"),
        (5, 2, "STAT"),
    ]


def test_a_stage_that_has_forgotten_its_past_begins_later() -> None:
    stage = Stage()
    stage.add(load("faq-walker"))
    for number in range(40):
        stage.send(1, ("FORWARD", "STOP")[number % 2])
        stage.step(40)
    whole = [change for change in state_changes(stage) if change.tick > 0]
    stage.forget(10)
    changes = state_changes(stage)
    assert changes[0].tick == stage.first
    assert changes[1:] == [change for change in whole if change.tick > stage.first]
    assert changes[0].state == [change for change in whole if change.tick <= stage.first][-1].state


def test_a_stage_that_came_back_says_nothing_about_what_it_does_not_remember() -> None:
    stage = Stage()
    stage.add(load("faq-walker"))
    for number in range(40):
        stage.send(1, ("FORWARD", "STOP")[number % 2])
        stage.step(40)
    changes = state_changes(stage)
    again = replay(stage.dump(), load, until=0)
    again.resume(stage.head, {tick: data for tick, data in stage.snapshots.data.items() if tick % 600 == 0})
    remembered = state_changes(again)
    assert remembered[0].tick == again.remembered_from == 1200
    assert remembered[1:] == [change for change in changes if change.tick > 1200]
    assert list(again.actions) == [action for action in stage.actions if action.tick > 1200]
