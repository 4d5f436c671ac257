"""Each sentence of "Cells" in shared words: one test a sentence, one tick after the other.

A takes 10 ticks, b loops in 10, C takes 10.
"""

import pytest
from ticking import Ticking

TICKS = {"A": 10, "b": 10, "C": 10}


def actor_of(a="", b="", c="", more="", start="A"):
    """A machine with one input, GO, and END; each state's row is written `GO | END`."""
    table = f"state | GO | END\nA | {a or '|'}\nb | {b or '|'}\nC | {c or '|'}"
    ticks = {start: TICKS[start]} | TICKS
    return Ticking(table, ticks, more)


def test_blank_means_nothing_yet_it_waits_for_its_buffer():
    actor = actor_of(more="events: {GO: {buffer: 0.05}}\n")  # 3 ticks
    said = [(actor.step(*inputs), tuple(actor.said))[1] for inputs in (("GO",), (), (), (), ())]
    assert said == [("GO waits",), (), (), ("GO dropped",), ()]


def test_a_dash_means_nothing_here_no_default_no_waiting():
    actor = actor_of(a="- | ", more='cells: {"*/GO": {to: b}}\n')
    assert (actor.step("GO"), actor.said, actor.waiting) == ("A", ["GO dropped"], [])


def test_a_states_own_name_is_a_stay_the_motion_goes_on():
    actor = actor_of(a="A | ", more="cells: {A/GO: {action: nod}}\n")
    actor.run(3)
    assert (actor.step("GO"), actor.time_in_ticks, actor.actions) == ("A", 4, ["nod"])


def test_with_an_exclamation_mark_the_motion_begins_again():
    actor = actor_of(a="A! | ")
    actor.run(3)
    assert (actor.step("GO"), actor.time_in_ticks) == ("A", 0)


@pytest.mark.parametrize(("start", "at"), [("A", 10), ("b", 10)])
def test_when_end_is_that_of_the_motion_or_of_its_loop(start, at):
    actor = actor_of(a="C at end |", b="C at end |", start=start)
    actor.step("GO")
    assert actor.path(25) == [(at, "C")]


def test_when_now_is_said_of_all_others():
    actor = actor_of(a="C |", more="defaults: {when: end}\ncells: {A/GO: {when: now}}\n")
    assert actor.step("GO") == "C"


DEFAULTS = {
    "cell": ("C |", '"A/*": {to: b}, "*/GO": {to: b}, "*/*": {to: b}'),
    "row": ("|", '"A/*": {to: C}, "*/GO": {to: b}, "*/*": {to: b}'),
    "column": ("|", '"*/GO": {to: C}, "*/*": {to: b}'),
    "table": ("|", '"*/*": {to: C}'),
}


@pytest.mark.parametrize("kind", DEFAULTS)
def test_the_first_default_that_exists_counts(kind):
    written, cells = DEFAULTS[kind]
    assert actor_of(a=written, more=f"cells: {{{cells}}}\n").step("GO") == "C"


def test_a_star_is_never_end():
    actor = actor_of(more='cells: {"*/*": {to: b}}\n')
    assert actor.run(15) == "A"


NESTED = """
character: c.glb
initial: OUT
states:
  OUT:
    machine:
      initial: IN
      states: {IN: {motion: in, loop: true}}
      table: |
        state | GO
        IN | INNER
      cells: {"*/GO": {to: INNERSTAR}, "*/*": {to: INNERALL}}
  b: {motion: b, loop: true}
  C: {motion: c, loop: true}
table: |
  state | GO | OTHER
  OUT | OUTER |
  b | |
  C | |
cells: {"OUT/*": {to: OUTERROW}, "*/GO": {to: b}, "*/*": {to: b}}
"""
ORDER = ("INNER", "INNERSTAR", "INNERALL", "OUTER", "OUTERROW")


@pytest.mark.parametrize("first", range(len(ORDER)))
def test_those_of_the_enclosing_state_come_after_the_inner_ones_and_before_the_columns(first):
    """All before the one that is to count are taken away; it leads to C, those after it to b."""
    text = NESTED.replace("IN | INNER\n", "IN | \n" if first > 0 else "IN | C\n")
    text = text.replace(
        "OUT | OUTER |", "OUT | |" if first > 3 else "OUT | C |" if first == 3 else "OUT | b |"
    )
    inner = (
        ['"*/GO": {to: C}', '"*/*": {to: C}'] if first in (1, 2) else ['"*/GO": {to: b}', '"*/*": {to: b}']
    )
    inner = inner[(first == 2) :] if first < 3 else []
    text = text.replace('"*/GO": {to: INNERSTAR}, "*/*": {to: INNERALL}', ", ".join(inner)).replace(
        "OUTERROW", "C" if first == 4 else "b"
    )
    actor = Ticking.of(text, {"in": 10, "b": 10, "c": 10})
    assert actor.step("GO") == "C"
