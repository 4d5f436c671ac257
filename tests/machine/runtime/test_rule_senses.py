"""Senses, touches and raised events (rule 1): thresholds with hysteresis, and what other actors do to this
one.
"""

import numpy as np
import pytest
from statwalk.machine.runtime.surroundings import RAISED, TOUCH, TRAVEL, Inputs
from ticking import Ticking

TICKS = {"walk": 20, "run": 20}
TABLE = "state | RUN | HIT | GO\nwalk | run | run | \nrun | | | walk"
SENSES = "senses:\n  RUN: {when: speed > 2.0, release: speed < 1.6}\n"


def runner(senses=SENSES, table="state | RUN\nwalk | walk", more=""):
    return Ticking(table, TICKS, f"{senses}cells: {{walk/RUN: {{action: puff}}}}\n{more}")


def raised(actor, speeds):
    """The ticks (from 1) in which RUN comes, for speeds that were shown before each."""
    found = []
    for speed in speeds:
        actor.measure(speed=speed)
        actor.step()
        found += [actor.tick] if "RUN taken" in actor.said else []
    return found


def test_an_event_comes_when_the_condition_becomes_true():
    assert raised(runner(), [1, 2, 2.1, 3, 3]) == [3]


def test_and_again_only_after_release_was_true():
    assert raised(runner(), [3, 1.7, 3, 1.6, 3, 1.5, 3]) == [1, 7]


def test_without_release_after_it_was_false():
    assert raised(runner("senses:\n  RUN: {when: speed > 2.0}\n"), [3, 3, 1.9, 2.1]) == [1, 4]


def test_the_column_need_not_be_in_the_table():
    actor = Ticking("state | GO\nwalk | run\nrun |", TICKS, SENSES + 'cells: {"walk/RUN": {to: run}}\n')
    actor.measure(speed=3)
    assert (actor.step(), actor.reasons) == ("run", ["sensed: speed > 2.0"])


def test_what_is_sensed_waits_in_a_blank_cell_as_an_input_does():
    actor = Ticking(TABLE, TICKS, SENSES)
    actor.step("HIT")
    actor.measure(speed=3)
    actor.step()
    assert (actor.state, actor.waiting, actor.reasons) == (
        "run",
        ["RUN"],
        ["sensed: speed > 2.0; the cell is blank; it waits for 0.3 s"],
    )
    actor.step("GO")
    assert actor.step() == "run"


def test_senses_come_before_inputs():
    actor = Ticking("state | GO | RUN\nwalk | walk | walk", TICKS, SENSES)
    actor.measure(speed=3)
    actor.step("GO")
    assert actor.said == ["RUN taken", "GO taken"]


def test_markers_come_before_senses():
    actor = Ticking("state | mark | RUN\nwalk | walk | walk", TICKS, SENSES, {"walk": {"mark": 1}})
    actor.measure(speed=3)
    actor.step()
    assert actor.said == ["mark taken", "RUN taken"]


def test_a_sense_sees_parameters_smoothed():
    parameters = "parameters: {wish: {default: 0, min: 0, max: 4, smooth: 0.25}}\n"
    actor = runner("senses:\n  RUN: {when: wish > 2}\n", more=parameters)
    actor.set(wish=4)
    ticks = [actor.tick for _ in range(15) if actor.step() and actor.said]
    before = 4 - 4 * (1 + 26.5534 * 3 / 60) * np.exp(
        -26.5534 * 3 / 60
    )  # after 3 ticks, of a spring that has 0.01 left after 15
    after = 4 - 4 * (1 + 26.5534 * 4 / 60) * np.exp(-26.5534 * 4 / 60)
    assert (before < 2 < after, ticks) == (True, [4])


@pytest.mark.parametrize("kind", [TOUCH, RAISED])
def test_what_others_do_is_an_event_and_its_action_knows_who_did_it(kind):
    actor = Ticking(TABLE, TICKS, "cells: {walk/HIT: {action: 'drop(coins, 3)'}}\n")
    actor.give(Inputs.of(*([part] for part in (0, 1, kind, 17))))
    assert (actor.state, actor.verdicts[0].other) == ("run", 17)
    action = actor.done[0]
    assert (action.name, action.arguments, action.other) == ("drop", ("coins", 3.0), 17)


def test_who_did_it_is_known_when_the_event_has_waited():
    actor = Ticking("state | HIT\nwalk | run at end\nrun |", TICKS, "cells: {walk/HIT: {action: ouch}}\n")
    actor.give(Inputs.of(*([part] for part in (0, 0, TOUCH, 17))))
    assert actor.memory.waiting_other[0, 0, 0] == 17
    assert (actor.run(19), actor.done[0].other) == ("run", 17)


def test_raise_comes_out_as_an_action():
    actor = Ticking(TABLE, TICKS, "cells: {walk/HIT: {action: 'raise(HIT, other)'}}\n")
    actor.step("HIT")
    assert [(one.name, one.arguments) for one in actor.done] == [("raise", ("HIT", "other"))]


def travel(actor, goal):
    return actor.give(Inputs.of(*([part] for part in (0, goal, TRAVEL, -1))))


def test_a_goal_is_kept_until_the_actor_is_there():
    actor = Ticking(TABLE, TICKS)
    travel(actor, 1)
    assert actor.memory.goal.tolist() == [1]
    actor.step("RUN")
    assert (actor.memory.goal.tolist(), actor.reasons) == ([-1], ["arrived, the journey is over"])


def test_it_is_cleared_at_once_when_it_is_there_already_and_when_it_is_cancelled():
    for goal in (0, -1):
        actor = Ticking(TABLE, TICKS)
        travel(actor, 1)
        travel(actor, goal)
        assert actor.memory.goal.tolist() == [-1]
