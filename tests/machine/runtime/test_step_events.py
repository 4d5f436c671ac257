"""Rules 1 to 3: events in order, each looked up in the state that the ones before it have led to; what waits,
and for how long.
"""

import pytest
from ticking import Ticking

TABLE = """state | GO | JUMP | X | END
A | B | | - | B
B | | C | | A
C | | | | """
TICKS = {"A": 60, "B": 60, "C": 60}


def test_an_event_is_taken_in_its_tick():
    actor = Ticking(TABLE, TICKS)
    assert (actor.step("GO"), actor.said, actor.time_in_ticks) == ("B", ["GO taken"], 0)


def test_each_event_is_looked_up_where_the_one_before_has_led():
    assert Ticking(TABLE, TICKS).step("GO", "JUMP") == "C"


def test_a_dash_drops_at_once():
    actor = Ticking(TABLE, TICKS)
    actor.step("X")
    assert (actor.said, actor.reasons, actor.waiting) == (["X dropped"], ["the cell is -"], [])


def test_in_a_blank_cell_an_event_waits_for_its_buffer():
    actor = Ticking(TABLE, TICKS)  # 0.3 s are 18 ticks
    actor.step("JUMP")
    assert (actor.said, actor.waiting) == (["JUMP waits"], ["JUMP"])
    actor.run(17)
    assert (actor.said, actor.waiting) == ([], ["JUMP"])
    actor.step()
    assert (actor.said, actor.waiting) == (["JUMP dropped"], [])
    assert actor.reasons == ["the cell is blank, and 0.3 s are over"]


def test_it_waits_through_changes_of_state():
    actor = Ticking(TABLE, TICKS)
    actor.step("JUMP")
    assert actor.step("GO") == "B"
    assert actor.step() == "C"  # what waits comes first in the next tick


def test_a_change_by_end_is_no_exception():
    actor = Ticking(TABLE, TICKS)
    actor.run(55)
    actor.step("JUMP")
    assert actor.path(6) == [(60, "B"), (61, "C")]


def test_an_event_has_its_own_buffer_or_none():
    actor = Ticking(TABLE, TICKS, "events: {JUMP: {buffer: 0.05}, GO: {buffer: 0}}\n")
    actor.step("JUMP")
    actor.run(3)
    assert actor.said == ["JUMP dropped"]
    actor.step("GO")
    assert (actor.step("GO"), actor.said) == ("B", ["GO dropped"])


def test_a_newer_one_renews_the_older_in_its_place():
    actor = Ticking(TABLE, TICKS)
    actor.step("JUMP", "GO", "GO")
    assert actor.waiting == ["JUMP", "GO"]
    actor.run(1)
    actor = Ticking("state | A1 | B1\nA | |", {"A": 99})
    actor.step("A1", "B1")
    actor.run(9)
    actor.step("A1")
    assert actor.waiting == ["A1", "B1"]
    actor.run(8)
    assert actor.waiting == ["A1"]  # B1's 18 ticks are over, A1 has 9 more
    actor.run(10)
    assert actor.waiting == []


def test_at_most_16_wait_and_the_oldest_goes():
    names = [f"E{number}" for number in range(17)]
    actor = Ticking("state | " + " | ".join(names) + "\nA" + " | " * 17, {"A": 99})
    actor.step(*names)
    assert actor.waiting == names[1:]
    assert actor.said[-2:] == ["E0 dropped", "E16 waits"]
    assert "16" in actor.reasons[-2]


def test_an_event_for_the_end_waits_for_it():
    actor = Ticking("state | GO | END\nA | B at end | C\nB | |\nC | |", {"A": 40, "B": 9, "C": 9})
    actor.step("GO")
    assert actor.said == ["GO waits"]
    assert actor.path(50) == [(40, "B")]  # longer than the buffer, and before the END column


def test_when_end_may_be_the_default():
    actor = Ticking("state | GO\nA | B\nB |", {"A": 5, "B": 9}, "defaults: {when: end}\n")
    actor.step("GO")
    assert actor.path(9) == [(5, "B")]


def test_what_waits_for_the_end_is_dropped_when_the_state_is_left():
    actor = Ticking("state | GO | STOP\nA | B at end | C\nB | |\nC | |", {"A": 40, "B": 9, "C": 9})
    actor.step("GO")
    actor.step("STOP")
    assert (actor.state, actor.said, actor.reasons[-1]) == (
        "C",
        ["STOP taken", "GO dropped"],
        "A was left before its end",
    )
    assert actor.verdicts[-1].from_state == actor.machine.states.index("A")


def test_the_first_that_changes_the_state_ends_the_matter():
    table = "state | STAY | GO | RUN | END\nA | A at end | B at end | C at end | C\nB | | | |\nC | | | |"
    actor = Ticking(table, {"A": 5, "B": 9, "C": 9})
    actor.step("STAY", "GO", "RUN")
    actor.run(4)
    assert (actor.state, actor.said) == ("B", ["STAY taken", "GO taken", "RUN dropped"])


def test_a_stay_at_end_comes_before_the_end_column():
    actor = Ticking("state | STAY | END\na | a at end | B\nB | |", {"a": 5, "B": 9})
    actor.step("STAY")
    assert actor.path(10) == [(10, "B")]  # the loop went on once


def test_where_the_motion_does_not_loop_end_is_owed_after_a_stay():
    actor = Ticking("state | STAY | END\nA | A at end | B\nB | |", {"A": 5, "B": 9})
    actor.step("STAY")
    assert actor.path(10) == [(6, "B")]


def test_at_end_is_now_where_the_motion_has_ended():
    actor = Ticking("state | GO | END\nA | B at end |\nB | |", {"A": 5, "B": 9})
    actor.run(8)
    assert (actor.step("GO"), actor.reasons) == ("B", ["the motion has ended"])


def test_a_name_that_is_no_state_never_fires():
    actor = Ticking("state | GO | END\nA | TLFG | TRGY", {"A": 5})
    actor.step("GO")
    assert (actor.state, actor.said, actor.reasons) == ("A", ["GO dropped"], ["TLFG is no state"])
    actor.run(4)
    assert (actor.state, actor.said) == ("A", ["END dropped"])


def test_end_is_no_input():
    actor = Ticking(TABLE, TICKS)
    actor.step("END")
    assert (actor.state, actor.said) == ("A", ["END dropped"])


@pytest.mark.parametrize(("walk", "left_at"), [("walk", 24), ("WALK", 21)])
def test_the_printed_way_nobody_touching_it_means_stop(walk, left_at):
    table = f"state | GO | STOP\nSTAT | {walk} | STAT\n{walk} | {walk} | STAT"
    actor = Ticking(table, {"STAT": 4, walk: 4}, "defaults: {when: end}\nidle: STOP\n")
    actor.step("+GO")
    assert actor.path(19) == [(4, walk)]  # held: walks on
    actor.step("-GO")
    while actor.state == walk and actor.tick < 99:
        actor.step()
    assert actor.tick == left_at  # a loop goes on to its end; one that has ended was only held there
