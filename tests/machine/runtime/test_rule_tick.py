"""Rules 0 to 6 of "One tick", one after the other, each on a machine of its own and tick by tick; more of
each in the other files here.
"""

import numpy as np
from ticking import Ticking


def trace(actor, *ticks):
    """(state, ticks into its motion, what was said) after each tick; a tick is the inputs that come in it."""
    return [(actor.step(*inputs.split()), actor.time_in_ticks, " ".join(actor.said)) for inputs in ticks]


def test_rule_0_motions_advance_and_the_time_left_after_end_is_carried_on():
    """A of 2.5 ticks has 0.5 left in its third; B of 1.25 then 0.5 + 1 - 1.25 in the fourth; the marker of C
    at 1 comes at 1.25.
    """
    actor = Ticking(
        "state | mark | END\nA | | B\nB | | C\nC | C |", {"A": 2.5, "B": 1.25, "C": 9}, "", {"C": {"mark": 1}}
    )
    assert trace(actor, "", "", "", "", "", "") == [
        ("A", 1, ""),
        ("A", 2, ""),
        ("B", 0.5, "END taken"),
        ("C", 0.25, "END taken"),
        ("C", 1.25, "mark taken"),
        ("C", 2.25, ""),
    ]


def test_rule_1_waiting_markers_senses_inputs_end_each_looked_up_where_the_one_before_has_led():
    table = (
        "state | W | mark | TIRED | IN | END\nA | B at mark | | | | \nB | | | C | |\nC | | | | D |\n"
        "D | | | | | A"
    )
    actor = Ticking(
        table, dict.fromkeys("ABCD", 3), "senses: {TIRED: {when: speed > 1}}\n", {"A": {"mark": 3}}
    )
    assert trace(actor, "W", "") == [("A", 1, "W waits"), ("A", 2, "")]
    actor.measure(speed=2)
    # the marker is met by W; then the sense finds B, the input C; the END of A is gone with A
    assert trace(actor, "IN") == [("D", 0, "W taken TIRED taken IN taken")]


def test_rule_1_a_held_input_counts_again_at_every_end_and_in_every_new_state():
    actor = Ticking("state | GO | END\nA | B at end |\nB | A at end |", {"A": 2, "B": 3})
    assert trace(actor, "+GO", "", "", "", "", "", "-GO", "", "") == [
        ("A", 1, "GO waits"),
        ("B", 0, "GO taken"),  # at the end of A; in B it waits again from the next tick
        ("B", 1, "GO waits"),
        ("B", 2, ""),
        ("A", 0, "GO taken"),
        ("A", 1, "GO waits"),
        ("A", 2, "GO dropped"),
        ("A", 2, ""),
        ("A", 2, ""),
    ]


def test_rule_2_an_event_is_taken_waits_or_is_dropped_and_the_reason_is_kept():
    actor = Ticking("state | GO | LATER | NEVER | END\nA | A | A at end | - |", {"A": 9})
    actor.step("GO", "LATER", "NEVER")
    assert [(one.verdict, one.reason) for one in actor.verdicts] == [
        ("taken", "stays"),
        ("waits", "the cell says: at end"),
        ("dropped", "the cell is -"),
    ]


def test_rule_3_a_newer_event_renews_the_older_in_its_place():
    """With 3 ticks of buffer: X from tick 1 to 4, renewed in 3, so to 6; Y from 2 to 5."""
    actor = Ticking("state | X | Y\nA | | ", {"A": 99}, "defaults: {buffer: 0.05}\n")
    waiting = []
    for inputs in (["X"], ["Y"], ["X"], [], [], []):
        actor.step(*inputs)
        waiting.append(actor.waiting)
    assert waiting == [["X"], ["X", "Y"], ["X", "Y"], ["X", "Y"], ["X"], []]


def test_rule_3_what_waits_for_a_moment_is_dropped_with_the_state_and_what_waits_in_a_blank_cell_is_not():
    actor = Ticking(
        "state | X | Y | GO | END\nA | B at end | | B |\nB | | C | |\nC | | | |", {"A": 9, "B": 9, "C": 9}
    )
    assert trace(actor, "X Y", "GO", "") == [
        ("A", 1, "X waits Y waits"),
        ("B", 0, "GO taken X dropped"),
        ("C", 0, "Y taken"),
    ]


def test_rule_4_end_what_waits_for_it_first_then_its_column_then_idle_then_the_last_pose_holds():
    table = "state | X | STOP | END\nA | B at end | C | C\nB | | C | A\nC | | A |"
    actor = Ticking(table, {"A": 2, "B": 2, "C": 2}, "idle: STOP\n")
    assert trace(actor, "X", "", "", "", "", "", "", "") == [
        ("A", 1, "X waits"),
        ("B", 0, "X taken"),  # not C, as the END column says
        ("B", 1, ""),
        ("A", 0, "END taken"),  # not C, as STOP says
        ("A", 1, ""),
        ("C", 0, "END taken"),
        ("C", 1, ""),
        ("A", 0, "STOP taken"),  # END is blank
    ]
    holds = Ticking("state | STOP | END\nD | - |", {"D": 2}, "idle: STOP\n")
    assert trace(holds, "", "", "", "") == [("D", 1, ""), ("D", 2, ""), ("D", 2, ""), ("D", 2, "")]


def test_rule_4_a_loop_raises_end_at_each_wrap():
    actor = Ticking("state | END\na | a", {"a": 2.5})
    assert [time for _, time, said in trace(actor, *[""] * 10) if said] == [0.5, 0, 0.5, 0]


def test_rule_5_a_change_clears_end_and_markers_of_the_old_motion():
    """In its third tick A has its marker and its END; the input comes after the marker, and before END."""
    table = "state | IN | mark | END\nA | B | A | C\nB | | C | C\nC | | |"
    actor = Ticking(table, {"A": 3, "B": 9, "C": 9}, "", {"A": {"mark": 2.5}})
    assert trace(actor, "", "", "IN", "") == [
        ("A", 1, ""),
        ("A", 2, ""),
        ("B", 0, "mark taken IN taken"),
        ("B", 1, ""),
    ]


def test_rule_5_at_most_8_changes_and_the_rest_comes_first_in_the_next_tick():
    actor = Ticking("state | GO | X\nA | B | A\nB | A | B", {"A": 99, "B": 99})
    said = "GO taken " * 8 + "GO waits"
    assert trace(actor, "GO " * 9, "X") == [("A", 0, said), ("B", 0, "GO taken X taken")]
    assert len(actor.last.changes.actor) == 1


def test_rule_6_the_new_motion_starts_in_the_same_tick_and_says_how_it_blends():
    actor = Ticking("state | GO\nA | B\nB |", {"A": 9, "B": 9}, "cells: {A/GO: {blend: 0.25}}\n")
    assert trace(actor, "", "GO", "") == [("A", 1, ""), ("B", 0, "GO taken"), ("B", 1, "")]
    actor = Ticking("state | GO\nA | B\nB |", {"A": 9, "B": 9}, "cells: {A/GO: {blend: 0.25}}\n")
    actor.step("GO")
    assert actor.last.changes.blend.tolist() == [np.float32(0.25)]


def test_rule_6_a_motion_shorter_than_a_tick_raises_end_once_a_tick():
    actor = Ticking("state | END\nA | B\nB | A", {"A": 0.25, "B": 0})
    assert [state for state, _, _ in trace(actor, "", "", "", "")] == ["B", "A", "B", "A"]
