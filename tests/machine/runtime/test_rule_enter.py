"""Where a new motion begins (`enter` of "Cells", rule 6): at a phase, or at that of the old motion, by their
markers.
"""

import numpy as np
import pytest
from statwalk.machine.compile.compile_machine import MATCH
from ticking import Ticking, machine_of

TICKS = {"walk": 20, "run": 10, "JUMP": 40}
TABLE = "state | RUN | JUMP | END\nwalk | run | JUMP |\nrun | | |\nJUMP | | | run"


def walker(cells, markers=None):
    return Ticking(TABLE, TICKS, f"cells: {{{cells}}}\n", markers)


def test_a_motion_is_entered_at_a_phase():
    actor = walker("walk/JUMP: {enter: 0.15}")
    assert (actor.step("JUMP"), actor.time_in_ticks) == ("JUMP", 6)  # 0.15 of 40
    assert actor.last.changes.time.tolist() == pytest.approx([0.1])
    assert actor.path(40) == [(35, "run")]  # the other 34 ticks


def test_markers_before_that_phase_do_not_come():
    actor = Ticking(
        "state | GO | one | two\nA | B | |\nB | | B | B",
        {"A": 9, "B": 20},
        "cells: {A/GO: {enter: 0.5}}\n",
        {"B": {"one": 5, "two": 10}},
    )
    actor.step("GO")
    assert [said for _ in range(9) if actor.step() for said in actor.said] == ["two taken"]


def test_the_time_left_after_end_comes_on_top():
    actor = Ticking(
        "state | GO | END\nA | | B\nB | |", {"A": 2.25, "B": 10}, "cells: {A/END: {enter: 0.5}}\n"
    )
    assert (actor.run(3), actor.time_in_ticks) == ("B", 5.75)


def test_it_is_carried_at_the_speed_of_the_new_motion():
    actor = Ticking(
        "state | GO | END\nA | | B\nB | |", {"A": 2.25, "B": 10}, "cells: {A/END: {enter: 0.5}}\n"
    )
    actor.change("speed", {1: 2})
    assert (actor.run(3), actor.time_in_ticks) == ("B", 6.5)


@pytest.mark.parametrize(("pressed_at", "enters"), [(1, 0.5), (10, 5), (19, 9.5), (20, 0)])
def test_match_without_markers_is_the_same_phase(pressed_at, enters):
    actor = walker("walk/RUN: {enter: match}")
    actor.run(pressed_at - 1)
    assert (actor.step("RUN"), actor.time_in_ticks) == ("run", enters)


@pytest.mark.parametrize(("pressed_at", "enters"), [(5, 1), (10, 3), (15, 5), (18, 6.8), (20, 8)])
def test_match_goes_by_the_markers_that_both_have(pressed_at, enters):
    """left 0.25 -> 0.1, right 0.75 -> 0.5: half way between left and right is 0.3; from right to left 0.5 of
    walk are 0.6 of run.
    """
    markers = {"walk": {"left": 5, "right": 15}, "run": {"left": 1, "right": 5}}
    actor = walker("walk/RUN: {enter: match}", markers)
    actor.run(pressed_at - 1)
    actor.step("RUN")
    assert actor.time_in_ticks == pytest.approx(enters, abs=1e-6)


def test_it_stands_in_the_program_as_an_array():
    machine = machine_of(TABLE, TICKS, "cells: {walk/RUN: {enter: match}, walk/JUMP: {enter: 0.25}}\n")
    program = machine.program
    assert program.enter[program.alternatives[0] : program.alternatives[2]].tolist() == [MATCH, 0.25]


def test_a_motion_begins_in_the_tick_of_its_event_with_its_own_blend_and_curve():
    actor = walker("walk/JUMP: {blend: {seconds: 0.1, curve: quintic}}, JUMP/END: {blend: 0.3}")
    actor.step("JUMP")
    assert (actor.last.changes.blend.tolist(), actor.last.changes.curve.tolist()) == ([np.float32(0.1)], [1])
    actor.run(40)
    assert (actor.last.changes.blend.tolist(), actor.last.changes.curve.tolist()) == ([np.float32(0.3)], [0])
