"""States that go into a sub-machine, and come out: with their rows, cells, and all that speaks of them."""

import pytest
from edit_texts import DOOR, after, came
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.edited import conflict, edited
from statwalk.files.machine_yaml.edit.operations import (
    AddEvent,
    NestState,
    RenameState,
    SetCell,
    SetInitial,
    SetState,
    SetView,
    UnnestState,
)

ALONE = edited(DOOR, [NestState("OPEN", "WAY")])


def words(text: str) -> list[str]:
    return sorted(text.split())


def test_a_new_sub_machine_has_the_lines_of_the_state_and_the_columns_around_it():
    assert came(NestState("OPEN", "WAY"))[:16] == [
        "  WAY:",
        "    machine:",
        "      initial: OPEN",
        "      states:",
        "        OPEN:",
        "          motion:                                         # it swings",
        "            over: wind",
        "            clips: {still: 0, swing: 1}",
        "          loop: true",
        "      table: |",
        "        state | PUSH | PULL | HAIL | half | END",
        "        OPEN  |      | SHUT |      |      |",
        "      cells:",
        "        OPEN/PUSH: [{if: wind > 0.5, to: SHUT}, {to: OPEN}]",
        "        OPEN/HAIL: {SHUT: 4, OPENING: 1}",
        "        BOW   | WAY.OPEN at end",
    ]


def test_all_that_speaks_of_the_state_has_its_full_name():
    for line in (
        "  OPENING  | SHUT at half |      |       | SHUT | WAY.OPEN",
        "  WAY      |         |      |       |      |",
        "  w:       {change: {WAY.OPEN: {wind: 1}}}",
        "  - WAY.OPEN only after OPENING",
        "  - from SHUT, PUSH reaches WAY.OPEN within 2 s",
        "    WAY.OPEN: [10, 20]",
    ):
        assert line in ALONE.splitlines()


def test_one_more_state_gets_a_row_and_keeps_its_comment():
    assert came(NestState("OPENING", "WAY"), text=ALONE)[:4] == [
        "        OPENING: {motion: open, markers: {half: 0.5}}     # slowly",
        "        state   | PUSH         | PULL | HAIL | half | END",
        "        OPEN    |              | SHUT |      |      |",
        "        OPENING | SHUT at half |      |      | SHUT | OPEN",
    ]


def test_the_table_of_the_sub_machine_gets_the_columns_that_the_row_needs():
    assert came(NestState("OPENING", "GUARD"))[1:5] == [
        "        state   | HAIL        | PUSH         | half | END",
        "        STAND   | BOW         |              |      |",
        "        BOW     | OPEN at end |              |      |",
        "        OPENING |             | SHUT at half | SHUT | OPEN",
    ]


def test_the_first_state_makes_the_sub_machine_the_first():
    text = after([NestState("SHUT", "WAY")])
    assert "initial: WAY\n" in text
    assert "      initial: SHUT\n" in text


def test_a_sub_machine_goes_into_another_one():
    text = after([NestState("GUARD", "HOUSE")])
    assert "              BOW   | OPEN at end" in text.splitlines()
    assert '  "*/PULL":   {to: HOUSE.GUARD.BOW, when: marker half}' in text.splitlines()


def test_where_states_stand_in_brackets_the_row_is_under_cells():
    assert came(NestState("GUARD.STAND", "GUARD.X"))[1].endswith(
        "{X: {machine: {initial: STAND, states: {STAND: {motion: stand}}, cells: {STAND/HAIL: {to: BOW}}}}, "
        "BOW: {motion: bow, final: true}}"
    )


def test_in_a_layer():
    assert came(NestState("LIT", "X", layer="lamp")) == [
        "    states: {OFF: {motion: none}, X: {machine: {initial: LIT, states: {LIT: {motion: glow}}}}}",
        "      OFF   | X.LIT",
    ]


def test_a_state_comes_out_with_its_row_and_is_final_no_more():
    lines = came(UnnestState("GUARD.BOW"))
    assert lines[1] == "  BOW:     {motion: bow}"
    assert "  BOW     |         |      | OPEN at end |      |" in lines
    assert lines[-1] == '  "*/PULL":   {to: BOW, when: marker half}'


def test_the_table_around_gets_the_columns_of_the_row_before_its_end():
    text = after([AddEvent("KNOCK", composite="GUARD"), SetCell("GUARD.BOW", "KNOCK", "STAND")])
    assert "  state   | PUSH    | PULL | HAIL        | half | KNOCK       | END" in came(
        UnnestState("GUARD.BOW"), text=text
    )


def test_the_last_state_takes_the_place_of_its_sub_machine():
    """So a sub-machine made by mistake goes without a trace, but for spaces; its place in the graph goes."""
    assert words(after([UnnestState("WAY.OPEN")], ALONE)) == words(DOOR)
    two = after([NestState("OPENING", "WAY"), SetView({"WAY": (1, 2)})], ALONE)
    again = after([UnnestState("WAY.OPENING"), UnnestState("WAY.OPEN")], two)
    assert words(again) == words(DOOR)


def test_what_led_to_the_sub_machine_leads_to_its_last_state():
    text = after([SetCell("SHUT", "END", "WAY at half")], ALONE)
    assert (
        "  SHUT     | OPENING | -    | GUARD |      | OPEN at half"
        in after([UnnestState("WAY.OPEN")], text).splitlines()
    )


@pytest.mark.parametrize(
    ("operation", "words"),
    [
        (NestState("OPEN", "SHUT"), "SHUT is a state and no sub-machine"),
        (NestState("OPEN", "OPEN"), "OPEN cannot be in OPEN"),
        (
            NestState("OPEN", "A.B"),
            "A.B would not stand in the table of OPEN; name a sub-machine in that table",
        ),
        (NestState("GUARD.BOW", "HOUSE"), "in that table, as GUARD.FIGHT"),
        (NestState("OPEN", "a b"), "no name for the sub-machine"),
        (NestState("SHUT", "GUARD"), "SHUT is the initial state; choose another one first"),
        (NestState("OPNE", "GUARD"), "did you mean OPEN"),
        (NestState("GUARD.BOW", "GUARD.OPEN"), "'OPEN' would be taken for another state in GUARD"),
        (UnnestState("OPEN"), "OPEN stands in no sub-machine"),
        (UnnestState("GUARD.STAND"), "GUARD.STAND is the initial state; choose another one first"),
    ],
)
def test_refused(operation, words):
    with pytest.raises(MachineError, match=words):
        edited(DOOR, [operation])


@pytest.mark.parametrize(
    ("operations", "words"),
    [
        ([RenameState("SHUT", "BOW2"), RenameState("GUARD.BOW", "BOW2"), NestState("BOW2", "GUARD")], "BOW2"),
        ([RenameState("GUARD.BOW", "GUARD"), UnnestState("GUARD.GUARD")], "have one name; rename"),
        (
            [SetInitial("GUARD.BOW"), UnnestState("GUARD.STAND"), UnnestState("GUARD.BOW")],
            "has cells of its own: GUARD/PUSH, GUARD/END; make these cells blank, or delete GUARD",
        ),
    ],
)
def test_refused_after_other_operations(operations, words):
    with pytest.raises(MachineError, match=words):
        edited(DOOR, operations)


def test_two_editors():
    nested = edited(DOOR, [NestState("OPEN", "WAY")])
    assert conflict(DOOR, nested, [SetState("SHUT", {"loop": None})]) is None
    assert conflict(DOOR, nested, [SetState("OPEN", {"loop": None})]) == ("name", "state", "base", "OPEN")
    assert conflict(DOOR, nested, [NestState("GUARD", "WAY")]) == ("name", "state", "base", "WAY")
