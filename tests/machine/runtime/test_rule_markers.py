"""Markers and windows (rules 0 to 3 and 5, and `when` of "Cells"): walk takes 20 ticks, its left foot is down
at 5, its right one at 15.
"""

import pytest
from ticking import Ticking

TICKS = {"walk": 20, "JUMP": 30}
MARKERS = {"walk": {"left-down": 5, "right-down": 15}}
AT_LEFT = "state | JUMP | STOP | END\nwalk | JUMP at left-down | JUMP |\nJUMP | | | walk"


def walker(table=AT_LEFT, more="", markers=MARKERS, ticks=TICKS):
    return Ticking(table, ticks, more, markers)


def windowed(window):
    return walker("state | JUMP\nwalk | JUMP\nJUMP |", f"cells: {{walk/JUMP: {{when: window {window}}}}}\n")


def fired(actor, pressed_at, until=45):
    """The tick in which JUMP, pressed at a tick, changes the state."""
    actor.run(pressed_at - 1)
    if actor.step("JUMP") == "JUMP":
        return actor.tick
    return next((tick for tick, _ in actor.path(until)), None)


@pytest.mark.parametrize(("pressed_at", "at"), [(1, 5), (4, 5), (5, 5), (6, 25), (20, 25)])
def test_an_input_waits_for_the_marker_and_round_the_loop(pressed_at, at):
    assert fired(walker(), pressed_at) == at


def test_it_waits_longer_than_its_buffer_and_says_for_what():
    actor = walker(more="defaults: {buffer: 0.05}\n")
    actor.run(6)
    actor.step("JUMP")
    assert (actor.said, actor.reasons) == (["JUMP waits"], ["the cell says: at marker left-down"])
    actor.run(18)
    assert (actor.state, actor.reasons) == ("JUMP", ["marker left-down has come"])


@pytest.mark.parametrize(("place", "at"), [(4.5, 5), (19.5, 20), (20, 20), (0, 20)])
def test_a_marker_between_two_ticks_counts_in_the_later_one_also_at_the_seam(place, at):
    assert fired(walker(markers={"walk": {"left-down": place}}), 2) == at


def test_a_step_that_jumps_over_the_marker_meets_it():
    actor = walker()
    actor.change("speed", {0: 3})  # 3, 6
    assert fired(actor, 1) == 2


def test_what_waits_for_a_marker_is_dropped_when_the_state_is_left():
    actor = walker()
    actor.run(6)
    actor.step("JUMP", "STOP")
    assert (actor.said, actor.reasons[-1]) == (
        ["JUMP waits", "STOP taken", "JUMP dropped"],
        "walk was left before its marker left-down",
    )


@pytest.mark.parametrize(("pressed_at", "at"), [(1, 4), (4, 4), (12, 12), (13, 24)])
def test_a_window_is_open_from_its_first_phase_to_its_last(pressed_at, at):
    assert fired(windowed("0.2..0.6"), pressed_at) == at  # ticks 4 to 12


@pytest.mark.parametrize(("pressed_at", "at"), [(5, 18), (18, 18), (20, 20), (22, 22), (23, 38)])
def test_a_window_may_lie_across_the_seam(pressed_at, at):
    assert fired(windowed("0.9..0.1"), pressed_at) == at  # ticks 18 to 22


@pytest.mark.parametrize(
    ("window", "pressed_at", "at"),
    [("0.2..0.3", 1, 1), ("0.2..0.3", 2, 3), ("0.8..0.9", 1, 2), ("0.95..0.05", 2, 2)],
)
def test_a_step_that_jumps_over_the_window_meets_it(window, pressed_at, at):
    actor = windowed(window)
    actor.change("speed", {0: 10})  # 10, 0, 10, 0
    assert fired(actor, pressed_at) == at


def test_the_pose_that_a_motion_holds_may_lie_in_a_window():
    actor = Ticking("state | GO\nA | B\nB |", {"A": 5, "B": 9}, "cells: {A/GO: {when: window 0.9..1}}\n")
    actor.run(9)
    assert actor.step("GO") == "B"


def test_a_marker_is_an_event_of_the_column_of_its_name():
    actor = walker("state | left-down | END\nwalk | JUMP |\nJUMP | | walk")
    assert actor.path(5) == [(5, "JUMP")]
    assert actor.said == ["left-down taken"]


def test_it_comes_again_in_every_loop():
    actor = walker("state | left-down\nwalk | walk", "cells: {walk/left-down: {action: step}}\n")
    assert [len(actor.actions) for _ in range(45) if actor.step()][::5] == [0, 1, 1, 1, 1, 2, 2, 2, 2]


def test_in_a_blank_cell_a_marker_means_nothing_and_does_not_wait():
    actor = walker("state | left-down | GO\nwalk | | walk\nJUMP | walk |")
    actor.run(4)
    actor.step("GO")
    assert (actor.said, actor.waiting) == (["GO taken"], [])


def test_a_star_is_no_marker():
    actor = walker("state | left-down | GO\nwalk | | \nJUMP | |", 'cells: {"walk/*": {to: JUMP}}\n')
    assert actor.path(15) == []
    assert actor.step("GO") == "JUMP"


def test_markers_of_one_tick_come_by_time():
    table = "state | early | late\nwalk | walk | walk"
    actor = walker(table, markers={"walk": {"late": 4.9, "early": 4.1}})
    actor.run(5)
    assert actor.said == ["early taken", "late taken"]


def test_so_they_do_across_the_seam():
    actor = walker("state | early | late\nwalk | walk | walk", markers={"walk": {"early": 1, "late": 19}})
    actor.change("speed", {0: 9})  # 9, 18, 7: over 19 and 1
    actor.run(3)
    assert actor.said == ["late taken", "early taken"]


def test_the_events_of_a_tick_have_their_order():
    """Rule 1: waiting ones, markers, inputs, END; in the fifth tick of A, which is as long, all of them are
    there.
    """
    table = "state | IN | mark | WAITS | END\nA | A | A | A at mark | A"
    actor = Ticking(table, {"A": 5}, "", {"A": {"mark": 5}})
    actor.step("WAITS")
    actor.run(3)
    actor.step("IN")
    assert actor.said == ["WAITS taken", "mark taken", "IN taken", "END taken"]


def test_a_change_of_state_clears_the_markers_of_the_old_motion():
    """Rule 5: what waited for one marker has changed the state, so that the other, later in the same tick, is
    not met.
    """
    table = "state | GO | other\nwalk | JUMP at left-down | walk\nJUMP | | JUMP"
    actor = walker(table, markers={"walk": {"left-down": 5, "other": 5}})
    actor.step("GO")
    actor.run(4)
    assert (actor.state, actor.said) == ("JUMP", ["GO taken"])


def test_a_marker_at_the_beginning_comes_in_the_tick_after_it_began():
    actor = Ticking("state | start | END\nA | | B\nB | B |", {"A": 3, "B": 9}, "", {"B": {"start": 0}})
    assert (actor.run(3), actor.said) == ("B", ["END taken"])
    actor.step()
    assert actor.said == ["start taken"]
    actor.step()
    assert actor.said == []


def test_so_does_one_that_the_time_left_over_has_passed():
    """A ends at 2.25, so that B is at 0.75 in the third tick, past its marker at 0.5."""
    actor = Ticking("state | mark | END\nA | | B\nB | B |", {"A": 2.25, "B": 9}, "", {"B": {"mark": 0.5}})
    assert actor.run(3) == "B"
    actor.step()
    assert actor.said == ["mark taken"]


def test_a_marker_whose_alternatives_are_all_false_leaves_no_verdict_and_does_not_wait():
    cells = "cells: {walk/left-down: {to: [{if: q > 3, to: JUMP}]}}\n"
    more = f"parameters: {{q: {{default: 0, min: 0, max: 9}}}}\n{cells}"
    actor = walker("state | left-down\nwalk |\nJUMP | walk", more)
    assert [actor.step() and (actor.said, actor.waiting) for _ in range(24)] == [([], [])] * 24
    actor.set(q=5)
    assert (actor.step(), actor.said) == ("JUMP", ["left-down taken"])


def test_a_loop_that_is_entered_at_its_end_begins():
    actor = Ticking(
        "state | GO | mark\nA | b |\nb | | b",
        {"A": 9, "b": 9},
        "cells: {A/GO: {enter: 1}}\n",
        {"b": {"mark": 0}},
    )
    assert (actor.step("GO"), actor.time_in_ticks) == ("b", 0)
    actor.step()
    assert actor.said == ["mark taken"]


BLEND = """
character: c.glb
initial: MOVE
states:
  MOVE: {motion: {over: pace, clips: {walk: 1, run: 3}}, loop: true, markers: {middle: 0.5}}
  JUMP: {motion: jump}
parameters: {pace: {default: 1, min: 0, max: 4}}
table: |
  state | left-down | middle
  MOVE | MOVE | MOVE
"""


def test_the_markers_of_a_blend_are_those_of_its_first_clip_and_its_own_by_phase():
    """The walk alone has weight: its marker stands at 5 of its 20 ticks, the state's own half way."""
    actor = Ticking.of(
        BLEND, {"walk": 20, "run": 30, "jump": 9}, {"walk": {"left-down": 5}, "run": {"left-down": 3}}
    )
    met = [(actor.tick, actor.said) for _ in range(20) if actor.step() and actor.said]
    assert met == [(5, ["left-down taken"]), (10, ["middle taken"])]


def test_half_way_between_two_clips_a_marker_comes_half_way_between_theirs():
    """It takes 25 ticks; the marker stands at 0.25 of the walk and at 0.1 of the run: at 0.175 of 25 ticks.
    The middle of the walk is a third of the way from there to the end.
    """
    actor = Ticking.of(
        BLEND.replace("default: 1", "default: 2").replace("loop: true", "loop: false"),
        {"walk": 20, "run": 30, "jump": 9},
        {"walk": {"left-down": 5}, "run": {"left-down": 3}},
    )
    met = [(actor.tick, actor.said) for _ in range(25) if actor.step() and actor.said]
    assert pytest.approx((4.375, 11.25)) == (0.175 * 25, (0.175 + 0.825 / 3) * 25)
    assert met == [(5, ["left-down taken"]), (12, ["middle taken"])]


def test_a_blend_that_is_shorter_now_runs_faster():
    """Counted in ticks of the longest clip, 30: a lap takes 20 ticks."""
    actor = Ticking.of(BLEND, {"walk": 20, "run": 30, "jump": 9})
    assert actor.run(4) == "MOVE"
    assert actor.time_in_ticks == 6


def test_a_window_never_opens_where_there_is_no_motion():
    """Not even one from the beginning: nothing has a phase there."""
    layer = (
        "layers: {arms: {initial: REST, states: {REST: {motion: none}}, cells: {'*/X': {to: REST!, when: "
        "window 0..0.5}}}}\n"
    )
    actor = Ticking("state | GO | X\nwalk | |", {"walk": 20}, layer)
    actor.step("X")
    assert [actor.step() and actor.said for _ in range(40)] == [[]] * 40
