"""Held inputs: they count as waiting again at every END and in every new state, until they are released."""

from ticking import Ticking

TURNS = """state | FORWARD | LEFT | STOP | END
stat | walk | TLFT | stat |
walk | walk | TLFT | stat |
TLFT | walk at end | TLFT! at end | stat | stat"""
TICKS = {"stat": 50, "walk": 8, "TLFT": 10}
CROUCH = "state | CROUCH | END\nstat | CRCH |\nCRCH | CRCH at end | STUP\nSTUP | | stat"


def test_a_held_input_is_taken_once_and_again_in_the_new_state():
    actor = Ticking(TURNS, TICKS)
    actor.step("+FORWARD")
    assert (actor.state, actor.said) == ("walk", ["FORWARD taken"])
    actor.step()
    assert (actor.state, actor.said, actor.waiting) == ("walk", ["FORWARD taken"], [])  # a stay
    actor.step()
    assert actor.said == []


def test_and_at_every_end():
    actor = Ticking(TURNS, TICKS, "cells: {walk/FORWARD: {action: step}}\n")
    actor.step("+FORWARD")
    actor.run(24)
    assert len(actor.actions) == 4  # the new state, then three wraps


def test_a_held_turn_goes_on_until_it_is_released():
    actor = Ticking(TURNS, TICKS)
    actor.step("+LEFT")
    actor.run(10)
    assert (actor.state, actor.last.changes.restart.tolist()) == ("TLFT", [True])
    actor.run(5)
    actor.step("-LEFT")
    assert actor.waiting == []
    assert actor.path(9) == [(21, "stat")]


def test_a_tap_turns_once():
    actor = Ticking(TURNS, TICKS)
    actor.step("+LEFT")
    actor.run(3)
    actor.step("-LEFT")
    assert actor.reasons == ["it was released"]
    assert actor.path(10) == [(11, "stat")]


def test_a_press_of_its_own_outlives_the_release():
    actor = Ticking(TURNS, TICKS)
    actor.step("+LEFT")
    actor.run(2)
    actor.step("LEFT")  # somebody else presses it as well
    actor.step("-LEFT")
    assert actor.waiting == ["LEFT"]


def test_the_first_that_went_down_comes_first():
    actor = Ticking(TURNS, TICKS)
    actor.step("+FORWARD")
    actor.step("+LEFT")
    actor.run(1)
    assert actor.waiting == ["FORWARD", "LEFT"]
    assert actor.path(11) == [(12, "walk"), (13, "TLFT")]


def test_and_not_the_first_column():
    actor = Ticking(TURNS, TICKS)
    actor.step("+LEFT")
    actor.step("+FORWARD")
    actor.run(9)
    actor.step("STOP")
    actor.step()
    assert actor.said[0] == "LEFT taken"


def test_leaving_a_state_does_not_drop_what_is_held():
    actor = Ticking(TURNS, TICKS)
    actor.step("+LEFT")
    actor.step()
    actor.step("STOP")
    assert (actor.said, actor.waiting) == (["STOP taken"], ["LEFT"])


def test_a_second_hold_is_none():
    actor = Ticking(TURNS, TICKS)
    actor.step("+LEFT")
    actor.step("+LEFT")
    assert "LEFT dropped" in actor.said
    actor.step("-LEFT")
    assert actor.path(10) == [(11, "stat")]


def test_a_held_crouch_stays_down_until_the_key_comes_up():
    actor = Ticking(CROUCH, {"stat": 50, "CRCH": 5, "STUP": 5})
    actor.step("+CROUCH")
    assert actor.path(30) == []
    actor.step("-CROUCH")
    assert actor.state == "STUP"


def test_the_same_stay_is_not_reported_in_every_tick():
    actor = Ticking(CROUCH, {"stat": 50, "CRCH": 5, "STUP": 5}, "cells: {CRCH/CROUCH: {action: breathe}}\n")
    actor.step("+CROUCH")
    actor.run(5)
    assert actor.said == ["CROUCH taken"]
    actor.run(20)
    assert (actor.said, actor.actions) == ([], ["breathe"])


def test_held_through_blank_states_it_is_there_at_the_end():
    table = "state | GO | END\nA | | B\nB | | stat\nstat | walk |\nwalk | walk |"
    actor = Ticking(table, {"A": 30, "B": 30, "stat": 9, "walk": 9})
    actor.step("+GO")
    assert actor.path(61) == [(30, "B"), (60, "stat"), (61, "walk")]


def test_release_of_what_is_not_held_means_nothing():
    actor = Ticking(TURNS, TICKS)
    actor.step("-LEFT")
    assert (actor.state, actor.said) == ("stat", [])


def test_what_is_held_leaves_its_verdict_and_action_where_its_alternatives_come_out_another_way():
    """END comes in tick 13, at 12.78 ticks, and is put off until q has changed in tick 30."""
    more = "parameters: {q: {default: 0, min: 0, max: 9}}\n"
    cells = "cells:\n  A/X: {to: [{if: q < 3, to: A, action: ping}, {to: B, action: pong}], when: end}\n"
    actor = Ticking("state | X | END\nA | | \nB | | ", {"A": 12.78, "B": 50}, more + cells)
    actor.run(1)
    actor.step("+X")
    actor.run(27)
    assert (actor.tick, actor.state, actor.actions) == (29, "A", ["ping"])
    actor.set(q=5)
    assert (actor.step(), actor.said, actor.actions) == ("B", ["X taken"], ["ping", "pong"])


def test_and_again_when_they_come_out_as_they_did_before():
    cells = "cells:\n  A/X: {to: [{if: q < 3, to: A, action: ping}, {to: A, action: pong}], when: end}\n"
    actor = Ticking("state | X\nA | ", {"A": 5}, "parameters: {q: {default: 0, min: 0, max: 9}}\n" + cells)
    actor.step("+X")
    for q in (0, 0, 5, 5, 0, 0):
        actor.set(q=q)
        actor.run(4)
    assert actor.actions == ["ping", "pong", "ping"]


RESTARTED = "state | X | Y\nA | A at end | A! at end"


def test_what_is_held_counts_at_every_end_also_where_another_event_has_begun_the_motion_again():
    """END comes in tick 13 and is put off; Y answers it in 20, and the END that comes 12.78 ticks after that,
    in 32, before X.
    """
    actor = Ticking(RESTARTED, {"A": 12.78}, "cells: {A/X: {action: ping}}\n")
    told = {2: ["+X"], 20: ["Y"], 25: ["Y"]}
    pings = [len(actor.actions) for tick in range(1, 46) if actor.step(*told.get(tick, []))]
    assert [tick for tick in range(2, 46) if pings[tick - 1] > pings[tick - 2]] == [13, 32, 45]


def test_but_what_was_pressed_waits_for_the_next_end():
    actor = Ticking(RESTARTED, {"A": 5}, "cells: {A/X: {action: ping}}\n")
    actor.step("Y", "X")
    actor.run(4)
    assert (actor.tick, actor.said, actor.waiting) == (5, ["Y taken"], ["X"])
    actor.run(5)
    assert (actor.tick, actor.said, actor.actions) == (10, ["X taken"], ["ping"])
