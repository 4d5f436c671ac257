"""The history of states where a stage remembers no more than its newest verdicts."""

from collections import deque

from statwalk.services.hosting.state_history import state_changes
from statwalk.services.library.load import load
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
