"""Rule 5 and what a cell does: a change clears END, at most 8 a tick; stay, restart, actions and blends."""

import numpy as np
import pytest
from ticking import Ticking

RING = "state | GO | END\nA | B |\nB | A |"


def test_a_change_clears_the_end_of_the_old_motion():
    actor = Ticking("state | GO | END\nA | B | C\nB | | C\nC | |", {"A": 3, "B": 9, "C": 9})
    actor.run(2)
    assert (actor.step("GO"), actor.time_in_ticks, actor.said) == ("B", 0, ["GO taken"])


def test_at_most_8_changes_a_tick_and_the_rest_comes_first_in_the_next():
    actor = Ticking(RING, {"A": 99, "B": 99})
    actor.step(*["GO"] * 9)
    assert (actor.state, len(actor.last.changes.actor), actor.said[-1], actor.waiting) == (
        "A",
        8,
        "GO waits",
        ["GO"],
    )
    assert (actor.step(), actor.said) == ("B", ["GO taken"])


def test_the_ninth_of_a_name_renews_the_first_that_waits():
    actor = Ticking(RING, {"A": 99, "B": 99})
    actor.step(*["GO"] * 12)
    assert actor.waiting == ["GO"]


def test_a_stay_goes_on_and_its_action_comes_out():
    actor = Ticking("state | GO\nA | A", {"A": 9}, "cells: {A/GO: {action: wave}}\n")
    actor.run(3)
    actor.step("GO")
    assert (actor.time_in_ticks, actor.actions, len(actor.last.changes.actor), actor.reasons) == (
        4,
        ["wave"],
        0,
        ["stays"],
    )


def test_a_restart_begins_again():
    actor = Ticking("state | GO\nA | A!", {"A": 9})
    actor.run(3)
    actor.step("GO")
    assert (actor.time_in_ticks, actor.last.changes.restart.tolist()) == (0, [True])


def test_a_change_says_all_that_the_stage_needs():
    actor = Ticking("state | GO\nA | B\nB |", {"A": 9, "B": 9}, "cells: {A/GO: {blend: 0.4, action: leap}}\n")
    actor.step("GO")
    change = actor.last.changes
    assert (change.actor[0], change.layer[0], change.event[0], change.from_state[0], change.to_state[0]) == (
        0,
        0,
        0,
        0,
        1,
    )
    assert (change.action[0], change.blend[0], change.curve[0], change.restart[0], change.time[0]) == (
        0,
        np.float32(0.4),
        0,
        False,
        0.0,
    )


def test_actions_come_out_in_order():
    more = "cells: {A/GO: {action: one}, B/GO: {action: two}, B/END: {action: three, to: A}}\n"
    actor = Ticking(RING, {"A": 9, "B": 9}, more)
    actor.step("GO", "GO")
    assert actor.actions == ["one", "two"]
    assert [action.actor for action in actor.done] == [0, 0]


def test_the_verdict_says_from_where_to_where():
    actor = Ticking(RING, {"A": 9, "B": 9})
    actor.step("GO")
    verdict = actor.verdicts[0]
    assert (verdict.actor, verdict.layer, verdict.from_state, verdict.to_state) == (0, 0, 0, 1)


@pytest.mark.parametrize("event", ["GO", "+GO"])
def test_a_held_swing_is_bounded(event):
    actor = Ticking(RING, {"A": 9, "B": 9})
    for _ in range(20):
        actor.step(event)
        assert len(actor.last.changes.actor) <= 8
