"""Held inputs count at every END, also where the motion was restarted; their buffers never begin anew."""

from ticking import Ticking

RESTARTED = "state | X | Y\nA | A at end | A! at end"


def ticks_of_pings(actor, told, until):
    """The ticks in which an action comes out, if the actor is told so in some of them."""
    counts = [0, *(actor.step(*told.get(tick, [])) and len(actor.actions) for tick in range(1, until + 1))]
    return [tick for tick in range(1, until + 1) if counts[tick] > counts[tick - 1]]


def test_an_input_that_has_just_gone_down_counts_at_the_end_that_another_event_has_answered():
    """Y answers END in tick 13 at 13 of 12.78 ticks, X after it; the next END comes at 0.22 + 13, in 26."""
    actor = Ticking(RESTARTED, {"A": 12.78}, "cells: {A/X: {action: ping}}\n")
    assert ticks_of_pings(actor, {2: ["Y"], 3: ["+X"]}, 38) == [13, 26]


def test_so_does_a_held_input_that_was_pressed_as_well():
    """END comes in tick 13, in 26 at 0.22 + 13, and in 39 at 0.44 + 13; Y restarts A in the first two."""
    actor = Ticking(RESTARTED, {"A": 12.78}, "cells: {A/X: {action: ping}}\n")
    assert ticks_of_pings(actor, {2: ["+X"], 5: ["Y"], 16: ["Y"], 18: ["X"]}, 40) == [13, 26, 39]


AT_ONCE = "state | X | Y | GO | END\nA | A at end | A! | B |\nB | | | |"


def test_what_is_held_counts_at_an_end_also_where_an_event_before_it_has_restarted_the_motion_in_that_tick():
    """Y comes in tick 13, before END; A then lasts from 0 to 12.78, to tick 26."""
    actor = Ticking(AT_ONCE, {"A": 12.78, "B": 50}, "cells: {A/X: {action: ping}}\n")
    assert ticks_of_pings(actor, {2: ["+X"], 13: ["Y"]}, 13) == [13]
    assert (actor.said, actor.time_in_ticks) == (["Y taken", "X taken"], 0)
    actor.run(12)
    assert len(actor.actions) == 1
    actor.step()
    assert len(actor.actions) == 2


def test_but_neither_what_was_pressed_nor_the_end_column_does():
    actor = Ticking(AT_ONCE.replace("B |\n", "B | B\n"), {"A": 12.78, "B": 50})
    actor.step("X")
    actor.run(11)
    assert (actor.step("Y"), actor.said, actor.waiting) == ("A", ["Y taken"], ["X"])


def test_nor_what_is_held_where_the_state_has_been_left_in_that_tick():
    actor = Ticking(AT_ONCE.replace("B | | | |", "B | B at end | B! | |"), {"A": 12.78, "B": 50})
    actor.step("+X")
    actor.run(11)
    assert (actor.step("GO", "Y"), actor.said) == ("B", ["GO taken", "Y taken"])


def test_an_end_put_off_that_a_restart_and_the_same_stay_answer_leaves_no_further_action():
    """The END of tick 13 is put off until Y restarts A in 20; it then ends at 12.78, in 33."""
    actor = Ticking(AT_ONCE, {"A": 12.78, "B": 50}, "cells: {A/X: {action: ping}}\n")
    assert ticks_of_pings(actor, {2: ["+X"], 20: ["Y"]}, 40) == [13, 33]


def late(buffer):
    """A loop of 60 ticks; X waits for its marker at 30, and there nothing is true."""
    more = f"defaults: {{buffer: {buffer}}}\nparameters: {{q: {{default: 0, min: 0, max: 9}}}}\n"
    cells = "cells: {a/X: {to: [{if: q > 3, to: a}], when: marker left}}\n"
    return Ticking("state | X\na |", {"a": 60}, more + cells, {"a": {"left": 30}})


def told_by(actor, ticks):
    """(tick, verdicts) where there are some."""
    return [(actor.tick, actor.said) for _ in range(ticks) if actor.step() and actor.said]


def test_the_buffer_of_a_held_input_counts_from_the_end_at_which_it_waits_again():
    """18 ticks from 2, then 18 from 60: nothing is left of them at the marker, in 30 and 90."""
    actor = late(0.3)
    actor.run(1)
    actor.step("+X")
    assert told_by(actor, 120) == [
        (30, ["X dropped"]),
        (60, ["X waits"]),
        (90, ["X dropped"]),
        (120, ["X waits"]),
    ]


def test_and_a_moment_that_was_false_leaves_what_is_left_of_it():
    """39 ticks from 2, so that 11 are left at the marker in 30, for which it then waits on; none in 90.

    The same from 120, with 9 left in 150, to 210.
    """
    actor = late(0.65)
    actor.run(1)
    actor.step("+X")
    assert told_by(actor, 210) == [
        *((30, ["X waits"]), (31, ["X waits"]), (90, ["X dropped"])),
        *((120, ["X waits"]), (150, ["X waits"]), (151, ["X waits"]), (210, ["X dropped"])),
    ]


def test_neither_is_it_counted_from_an_end_at_which_the_input_still_waits():
    """18 ticks from 50, so that 8 are left in 60, where nothing is true, and none in 120; then from 180."""
    more = (
        "parameters: {q: {default: 0, min: 0, max: 9}}\ncells: {a/X: {to: [{if: q > 3, to: a}], when: end}}\n"
    )
    actor = Ticking("state | X\na |", {"a": 60}, "defaults: {buffer: 0.3}\n" + more)
    actor.run(49)
    actor.step("+X")
    actor.run(9)
    assert told_by(actor, 190) == [
        *((60, ["X waits"]), (61, ["X waits"]), (120, ["X dropped"])),
        *((180, ["X waits", "X waits"]), (181, ["X waits"]), (240, ["X dropped"])),
    ]
