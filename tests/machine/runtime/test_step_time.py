"""Rules 0, 4 and 6: motions advance, END comes once, at each wrap of a loop, and what is left of the tick is
carried on.
"""

import numpy as np
import pytest
from statwalk.machine.runtime.state import fresh
from statwalk.machine.runtime.surroundings import NOTHING, Measurements
from ticking import DT, Ticking, stepped

CHAIN = "state | GO | END\nA | | B\nB | | C\nC | |"


def test_end_comes_in_the_tick_in_which_the_motion_reaches_its_end():
    assert Ticking(CHAIN, {"A": 3, "B": 2, "C": 9}).path(8) == [(3, "B"), (5, "C")]


def test_sixty_sixtieths_are_one():
    assert Ticking(CHAIN, {"A": 60, "B": 33, "C": 9}).path(100) == [(60, "B"), (93, "C")]


def test_the_time_left_after_end_is_carried_into_the_next_motion():
    actor = Ticking(CHAIN, {"A": 2.25, "B": 2.5, "C": 9})
    assert (actor.run(3), actor.time_in_ticks) == ("B", 0.75)
    assert (actor.run(2), actor.time_in_ticks) == ("C", 0.25)  # 0.75 + 2 - 2.5


def test_a_motion_shorter_than_a_tick_ends_in_the_next():
    assert Ticking(CHAIN, {"A": 2, "B": 0.25, "C": 9}).path(6) == [(2, "B"), (3, "C")]
    assert Ticking(CHAIN, {"A": 2, "B": 0, "C": 9}).path(6) == [(2, "B"), (3, "C")]


def test_a_loop_shorter_than_a_tick_raises_end_once_a_tick():
    actor = Ticking("state | GO | END\na | | a", {"a": 0.25}, "cells: {a/END: {action: round}}")
    actor.run(3)
    assert actor.actions == ["round"] * 3


def test_end_comes_at_each_wrap_of_a_loop():
    actor = Ticking("state | GO | END\na | | a", {"a": 2.5}, "cells: {a/END: {action: round}}")
    counts = [(actor.run(1), len(actor.actions))[1] for _ in range(8)]
    assert counts == [0, 0, 1, 1, 2, 2, 2, 3]
    assert actor.effects.wraps.tolist() == [[1]]


def test_end_comes_once_and_then_the_last_pose_holds():
    actor = Ticking("state | GO | END\nA | | A", {"A": 2}, "cells: {A/END: {action: done}}")
    actor.run(6)
    assert (actor.actions, actor.time_in_ticks) == (["done"], 2)


def test_a_restart_at_end_begins_the_motion_again():
    actor = Ticking("state | GO | END\nA | | A!", {"A": 2.5})
    assert (actor.run(3), actor.time_in_ticks, actor.last.changes.restart.tolist()) == ("A", 0.5, [True])


def test_the_idle_event_takes_the_place_of_an_end_that_says_nothing():
    table = "state | STOP | WAIT | END\nA | b | |\nb | C | | -\nC | | |"
    actor = Ticking(table, {"A": 2, "b": 2, "C": 1}, "idle: STOP\n")
    assert actor.path(3) == [(2, "b")]
    actor.step("+WAIT")
    assert actor.run(9) == "b"  # there the END column is `-`: nothing, idle or not


def test_speed_is_a_factor_of_time_and_carries_over_in_seconds():
    actor = Ticking(CHAIN, {"A": 5, "B": 8, "C": 9})
    actor.change("speed", {0: 2, 1: 4})
    assert (actor.run(3), actor.time_in_ticks) == (
        "B",
        2,
    )  # A: 2, 4, 6; half a tick is left, of which B makes two
    assert actor.path(3) == [(5, "C")]


def test_speed_may_be_a_parameter():
    more = "parameters: {pace: {default: 1, min: 0, max: 4}}\n"
    one = Ticking("state | GO\na | ", {"a": 100}, more)
    one.change("speed_parameter", {0: 0})
    two = fresh(one.program, 2)._replace(parameters=np.array([[1.0], [3.0]]))
    assert stepped(one.program, two, 1, NOTHING, Measurements.none(2)).state.time[:, 0] == pytest.approx(
        [DT, 3 * DT]
    )


def test_the_old_motion_is_reported_as_far_as_it_got():
    actor = Ticking(CHAIN, {"A": 2.25, "B": 2.5, "C": 9})
    actor.run(3)
    assert actor.effects.before[0, 0] == pytest.approx(2 * DT)
    assert actor.effects.reached[0, 0] == pytest.approx(2.25 * DT)
