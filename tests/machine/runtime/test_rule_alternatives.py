"""Alternatives ("Cells"): the first that is true, or one drawn by weight; all false is like blank without a
default; `off`.
"""

from collections import Counter

import numpy as np
import pytest
from statwalk.machine.compile.compile_machine import MIXED, OFF
from statwalk.machine.runtime.state import fresh
from statwalk.machine.runtime.surroundings import Inputs, Measurements
from ticking import DT, Ticking, machine_of, stepped, verdicts_of

TICKS = {"stat": 20, "JUMP": 10, "STUP": 10}
TABLE = "state | JUMP | GO | END\nstat | | |\nJUMP | | | stat\nSTUP | | | stat"
STAMINA = "parameters: {stamina: {default: 20, min: 0, max: 100}}\n"
JUMP_OR_STUP = (
    f"{STAMINA}cells:\n  stat/JUMP: [{{if: stamina > 10, to: JUMP, blend: 0.1, action: leap}}, "
    f"{{to: STUP}}]\n"
)
ONLY_IF = f"{STAMINA}cells:\n  stat/JUMP: [{{if: stamina > 10, to: JUMP}}]\n"
WEIGHTED = "cells:\n  stat/GO: {JUMP: 4, STUP: 1}\n"


def test_the_first_that_is_true_wins():
    actor = Ticking(TABLE, TICKS, JUMP_OR_STUP)
    assert (actor.step("JUMP"), actor.actions) == ("JUMP", ["leap"])
    assert (actor.reasons, actor.verdicts[0].values) == (["since stamina > 10"], (("stamina", 20.0),))
    assert actor.last.changes.blend.tolist() == [np.float32(0.1)]


def test_or_what_comes_after_it():
    actor = Ticking(TABLE, TICKS, JUMP_OR_STUP)
    actor.set(stamina=5)
    assert (actor.step("JUMP"), actor.actions) == ("STUP", [])
    assert (actor.reasons, actor.verdicts[0].values) == (
        ["since nothing before it is true"],
        (("stamina", 5.0),),
    )


def test_the_verdict_names_the_cell_as_it_is_written():
    actor = Ticking(TABLE, TICKS, 'cells: {"stat/*": {to: JUMP}}\n')
    actor.step("GO")
    assert actor.verdicts[0].cell == ("stat", "*")


def test_all_false_waits_like_a_blank_cell_and_is_looked_up_in_every_tick():
    actor = Ticking(TABLE, TICKS, ONLY_IF)
    actor.set(stamina=5)
    actor.step("JUMP")
    assert (actor.said, actor.reasons) == (
        ["JUMP waits"],
        ["nothing in the cell is true; it waits for 0.3 s"],
    )
    actor.run(5)
    assert (actor.said, actor.waiting) == ([], ["JUMP"])
    actor.set(stamina=11)
    assert actor.step() == "JUMP"


def test_and_is_dropped_when_its_buffer_is_over():
    actor = Ticking(TABLE, TICKS, ONLY_IF)
    actor.set(stamina=5)
    actor.step("JUMP")
    actor.run(17)
    assert actor.waiting == ["JUMP"]
    actor.step()
    assert (actor.waiting, actor.reasons) == ([], ["nothing in the cell is true, and 0.3 s are over"])


def test_it_has_no_default():
    actor = Ticking(TABLE, TICKS, ONLY_IF + '  "*/JUMP": {to: STUP}\n')
    actor.set(stamina=5)
    assert actor.step("JUMP") == "stat"


def test_in_the_end_column_all_false_leaves_it_to_the_idle_event():
    table = "state | GO | END\nA | C |\nB | |\nC | | "
    cells = f"{STAMINA}idle: GO\ncells:\n  A/END: [{{if: stamina < 10, to: B}}]\n"
    ticks = {"A": 4, "B": 9, "C": 9}
    assert Ticking(table, ticks, cells).path(5) == [(4, "C")]
    actor = Ticking(table, ticks, cells)
    actor.set(stamina=5)
    assert actor.path(5) == [(4, "B")]


def test_what_waits_for_the_end_is_asked_then():
    cells = f"{STAMINA}cells:\n  stat/JUMP: {{when: end, to: [{{if: stamina > 10, to: JUMP}}]}}\n"
    for stamina, state in ((5, "stat"), (15, "JUMP")):
        actor = Ticking(TABLE, TICKS, cells)
        actor.step("JUMP")
        actor.run(18)
        actor.set(stamina=stamina)
        assert actor.step() == state


IN_WINDOW = f"{STAMINA}cells:\n  stat/JUMP: {{when: window 0.2..0.4, to: [{{if: stamina > 10, to: JUMP}}]}}\n"
"""of 16 ticks: open from 4 to 6, and so from 20 to 22; the buffer of what comes in 1 is over in 19"""


def test_what_waits_for_a_window_in_which_nothing_was_true_waits_for_the_next_one():
    actor = Ticking(TABLE, TICKS | {"stat": 16}, IN_WINDOW)
    actor.set(stamina=5)
    actor.step("JUMP")
    actor.run(18)
    assert actor.waiting == ["JUMP"]
    actor.set(stamina=15)
    assert actor.path(10) == [(20, "JUMP")]


def test_and_is_dropped_where_nothing_is_true_then_and_nothing_is_left_of_its_buffer():
    actor = Ticking(TABLE, TICKS | {"stat": 16}, IN_WINDOW)
    actor.set(stamina=5)
    actor.step("JUMP")
    actor.run(18)
    assert (actor.waiting, actor.tick) == (["JUMP"], 19)
    actor.step()
    assert (actor.waiting, actor.reasons) == ([], ["nothing in the cell is true, and 0.3 s are over"])


@pytest.mark.parametrize(
    ("condition", "true"),
    [
        ("speed > 1.5", True),
        ("turning < 0", False),
        ("height == 3", True),
        ("phase > 0.2 and phase < 0.3", True),
        ("time >= 0.1", False),
    ],
)
def test_conditions_see_what_was_shown_at_the_tick_before(condition, true):
    """After 5 ticks of 20: phase 0.25, 5/60 s in the state."""
    actor = Ticking(TABLE, TICKS, f"cells:\n  stat/JUMP: [{{if: {condition}, to: JUMP}}]\n")
    actor.measure(speed=2, turning=0.5, height=3)
    actor.run(5)
    assert (actor.step("JUMP") == "JUMP") is true


def test_time_is_that_in_the_state_through_loops_and_restarts():
    table = "state | AGAIN | GO\nstat | stat! | "
    actor = Ticking(table, {"stat": 4}, "cells:\n  stat/GO: [{if: time > 99, to: stat}]\n")
    actor.run(6)
    actor.step("AGAIN")
    actor.run(2)
    actor.step("GO")
    assert actor.verdicts[0].values == (("time", pytest.approx(9 * DT)),)


def drawn(key, tick, event=1, actors=1):
    """The states that actors with the same key are in after GO in some tick."""
    made = machine_of(TABLE, TICKS, WEIGHTED)
    around = Measurements.none(actors)._replace(key=np.full(actors, key, np.uint64))
    done = stepped(
        made.program,
        fresh(made.program, actors),
        tick,
        Inputs.of(np.arange(actors), np.full(actors, event)),
        around,
    )
    return [made.states[row] for row in done.state.state[:, 0]], verdicts_of(made, done)


def test_weights_are_shares():
    counts = Counter(drawn(key, tick)[0][0] for key in range(25) for tick in range(1, 41))
    assert 750 < counts["JUMP"] < 850
    assert counts["JUMP"] + counts["STUP"] == 1000


def test_the_same_key_draws_the_same_in_a_crowd():
    states, verdicts = drawn(key=3, tick=5, actors=4)
    assert set(states) == set(drawn(key=3, tick=5)[0])
    share = {"JUMP": "drawn, 4 of 5", "STUP": "drawn, 1 of 5"}[states[0]]
    assert [one.reason for one in verdicts] == [share] * 4


def test_off_makes_a_cell_a_dash_without_deleting_what_it_says():
    actor = Ticking(TABLE, TICKS, "cells: {stat/GO: {to: JUMP, off: true}}\n")
    assert (actor.step("GO"), actor.reasons) == ("stat", ["the cell is -"])
    assert actor.machine.target[0].tolist()[1] == OFF


def test_cells_of_several_alternatives_are_mixed_in_the_array():
    machine = machine_of(TABLE, TICKS, JUMP_OR_STUP)
    assert machine.target[0, 0] == MIXED
    assert [(one.to, one.weight) for one in machine.alternatives[0, 0]] == [
        ("JUMP", None),
        ("STUP", None),
    ]
    assert machine.text.conditions[:2] == ("stamina > 10", "")


def test_a_tap_on_what_is_never_true_does_not_wait_for_ever_in_a_loop():
    """Its buffer of 18 ticks, counted from tick 1, is over when the first END, in tick 20, finds nothing
    true.
    """
    actor = Ticking(
        TABLE, TICKS, f"{STAMINA}cells:\n  stat/JUMP: {{when: end, to: [{{if: stamina > 10, to: JUMP}}]}}\n"
    )
    actor.set(stamina=5)
    actor.step("JUMP")
    actor.run(19)
    assert (actor.tick, actor.waiting) == (20, [])
    assert actor.reasons == ["nothing in the cell is true, and 0.3 s are over"]


def test_it_has_what_is_left_of_its_buffer_after_a_moment_at_which_nothing_was_true():
    """Sent in tick 10, over in 28: END in 20 finds nothing true, a stay in the queue until END in 40, which
    drops it.
    """
    actor = Ticking(
        TABLE, TICKS, f"{STAMINA}cells:\n  stat/JUMP: {{when: end, to: [{{if: stamina > 10, to: JUMP}}]}}\n"
    )
    actor.set(stamina=5)
    actor.run(9)
    actor.step("JUMP")
    actor.run(10)
    assert (actor.tick, actor.said, actor.waiting) == (20, ["JUMP waits"], ["JUMP"])
    actor.run(20)
    assert (actor.tick, actor.said, actor.waiting) == (40, ["JUMP dropped"], [])
