"""A cell changed in the text of a machine file, and nothing else."""

from __future__ import annotations

import difflib

import pytest
from edit_texts import DOOR, came, lines
from paths import MACHINES
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.cell_edits import SetCell
from statwalk.files.machine_yaml.edit.edited import edited

WALKER = (MACHINES / "faq-walker" / "machine.yaml").read_text()
NESTED = """character: c.glb
initial: REST
states:
  REST: {motion: rest}
  FIGHT:
    machine:
      initial: GUARD
      states: {GUARD: {motion: guard}, HIT: {motion: hit, final: true}}
      table: |
        state | GO
        GUARD | HIT
table: |
  | state | FIGHT | GO |
  |-------|-------|----|
  | REST  | FIGHT |    |
layers:
  arms:
    initial: OFF
    states: {OFF: {motion: none}, WAVE: {motion: wave}}
    table: |
      state | GO
      OFF   | WAVE
cells:
  REST/FIGHT: {to: FIGHT, blend: 0.1}
"""


def changed(text, layer, state, event, new):
    """The lines that went and came."""
    after = edited(text, [SetCell(state, event, new, layer=layer)])
    return [line for line in difflib.ndiff(text.splitlines(), after.splitlines()) if line[0] in "+-"]


def test_a_cell_keeps_its_width():
    assert changed(WALKER, "base", "WALK", "LEFT", "STAT") == [
        "-   WALK  | WALK        | TLFT         | TRGT         | CSTP | JUMP |             |",
        "+   WALK  | WALK        | STAT         | TRGT         | CSTP | JUMP |             |",
    ]


def test_a_longer_one_pushes_the_rest_of_its_row():
    assert changed(WALKER, "base", "WALK", "STOP", "CSTP! at end")[1] == (
        "+   WALK  | WALK        | TLFT         | TRGT         | CSTP! at end | JUMP |             |"
    )


def test_the_last_column():
    assert changed(WALKER, "base", "STUP", "END", "WALK")[1].endswith("| WALK")


def test_a_cell_made_blank():
    assert changed(WALKER, "base", "WALK", "JUMP", "")[1].endswith(
        "| TRGT         | CSTP |      |             |"
    )


def test_a_row_that_was_not_there():
    assert changed(NESTED, "arms", "WAVE", "GO", "OFF") == ["+       WAVE  | OFF"]


def test_within_a_sub_machine():
    assert changed(NESTED, "base", "FIGHT.GUARD", "GO", "GUARD!")[1] == "+         GUARD | GUARD!"


def test_bars_around_the_line():
    assert changed(NESTED, "base", "REST", "GO", "-")[1] == "+   | REST  | FIGHT | -  |"


@pytest.mark.parametrize(
    ("place", "new", "message"),
    [
        (("base", "WALK", "LEFTT"), "STAT", r"line \d+: no column is called 'LEFTT'; did you mean LEFT"),
        (("base", "WALKK", "LEFT"), "STAT", "did you mean WALK"),
        (("arm", "WALK", "LEFT"), "STAT", "no layer is called 'arm'"),
        (("base", "FIGHT.GUARD", "LEFT"), "STAT", "no sub-machine is called 'FIGHT'"),
        (("base", "WALK", "LEFT"), "A | B", "no cell"),
        (("base", "WALK", "LEFT"), "two words", "no cell"),
        (("base", "WALK", "LEFT"), "A" * 300, "no cell"),
    ],
)
def test_refused(place, new, message):
    layer, state, event = place
    with pytest.raises(MachineError, match=message):
        edited(WALKER, [SetCell(state, event, new, layer=layer)])


def test_a_next_state_under_cells_is_changed_there():
    assert changed(NESTED, "base", "REST", "FIGHT", "REST at end")[1] == (
        "+   REST/FIGHT: {to: REST at end, blend: 0.1}"
    )


def test_fields_come_change_and_go():
    quintic = {"blend": {"seconds": 0.3, "curve": "quintic"}, "enter": "match", "when": "marker half"}
    assert came(SetCell("OPEN", "PULL", fields=quintic)) == [
        "  OPEN/PULL:  {blend: {seconds: 0.3, curve: quintic}, enter: match, when: marker half}"
    ]
    assert came(SetCell("SHUT", "PUSH", fields={"blend": None, "action": "creak(2, loud)"})) == [
        '  SHUT/PUSH:  {action: "creak(2, loud)"}'
    ]


def test_the_last_field_takes_the_line_along():
    fields = {"blend": None, "action": None}
    assert [line[0] for line in lines(SetCell("SHUT", "PUSH", fields=fields))] == ["-"]


def test_alternatives_come_beside_fields_and_go():
    choices = [{"if": "wind > 0", "to": "OPEN"}, {"to": "GUARD"}]
    assert came(SetCell("SHUT", "PUSH", fields={"alternatives": choices})) == [
        '  SHUT/PUSH:  {blend: 0.5, action: "raise(PULL, all)", to: [{if: wind > 0, to: OPEN}, {to: GUARD}]}'
    ]
    assert came(SetCell("OPEN", "PUSH", fields={"alternatives": {"SHUT": 2, "OPEN": 1}})) == [
        "  OPEN/PUSH:  {SHUT: 2, OPEN: 1}"
    ]
    assert came(SetCell("OPEN", "PUSH", "SHUT", {"alternatives": None})) == [
        "  OPEN    | SHUT    | SHUT |       |      |"
    ]


def test_a_field_beside_alternatives():
    assert came(SetCell("OPEN", "HAIL", fields={"when": "end"})) == [
        "  OPEN/HAIL:  {to: {SHUT: 4, OPENING: 1}, when: end}"
    ]


def test_a_text_does_not_hide_alternatives():
    with pytest.raises(MachineError, match="OPEN/PUSH has alternatives under `cells`"):
        edited(DOOR, [SetCell("OPEN", "PUSH", "SHUT")])


def test_a_cell_made_blank_has_no_fields():
    assert lines(SetCell("SHUT", "PUSH", "")) == [
        "-   SHUT    | OPENING | -    | GUARD |      |",
        "+   SHUT    |         | -    | GUARD |      |",
        '-   SHUT/PUSH:  {blend: 0.5, action: "raise(PULL, all)"}',
    ]


def test_defaults_of_rows_and_columns():
    assert came(SetCell("SHUT", "*", "OPEN")) == ["  SHUT/*:     {to: OPEN}"]
    assert came(SetCell("*", "PUSH", "OPEN")) == ["  *       | OPEN    |      |       |      |"]
    assert came(SetCell("GUARD.*", "HAIL", "BOW")) == ["        *     | BOW"]


def test_an_event_of_another_table():
    assert came(SetCell("GUARD.STAND", "PULL", "OPEN")) == ["      cells: {STAND/PULL: {to: OPEN}}"]


CSV = (
    """character: c.glb
initial: A
states: {A: {motion: a}, B: {motion: b}}
table: t.csv

--- t.csv
"""
    + 'state,GO,"END"\r\nA,B,\r\nB,,A\r\n'
)


def test_a_table_in_a_file_of_its_own():
    assert edited(CSV, [SetCell("A", "GO", "B at end")]) == CSV.replace("A,B,", "A,B at end,")
    assert edited(CSV, [SetCell("B", "GO", "A")]) == CSV.replace("B,,A", "B,A,A")
