"""Events: columns that are added, renamed and moved, and what else speaks of them."""

import pytest
from edit_texts import DOOR, after, came
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import AddEvent, MoveEvent, RenameEvent, SetEvent

SMALL = """initial: A
states: {A: {motion: a}, B: {motion: b}}
table: |
  | state | GO | END |
  |-------|----|-----|
  | A     | B  |     |
  | B     |    | A   |
"""


def test_a_new_column():
    assert came(AddEvent("HIT", before="END"), text=SMALL) == [
        "  | state | GO | HIT | END |",
        "  |-------|----|-----|-----|",
        "  | A     | B  |     |     |",
        "  | B     |    |     | A   |",
    ]


def test_the_last_column_of_a_table_without_bars_around_it():
    assert came(AddEvent("KNOCK", composite="GUARD")) == [
        "        state | HAIL        | KNOCK",
        "        STAND | BOW         |",
        "        BOW   | OPEN at end |",
    ]


def test_its_buffer():
    assert came(AddEvent("KNOCK", buffer=0.5, layer="lamp"))[-2:] == ["events:", "  KNOCK: {buffer: 0.5}"]
    assert came(SetEvent("PUSH", 2)) == ["", "events:", "  PUSH: {buffer: 2}"]
    assert edited(DOOR, [SetEvent("PUSH", 2), SetEvent("PUSH", None)]) == DOOR


def test_a_name_goes_with_all_that_speaks_of_it():
    assert came(RenameEvent("PULL", "DRAW")) == [
        "  state   | PUSH    | DRAW | HAIL  | half | END",
        '  SHUT/PUSH:  {blend: 0.5, action: "raise(DRAW, all)"}',
        '  "*/DRAW":   {to: GUARD.BOW, when: marker half}',
        "  ArrowUp: {hold: PUSH, release: DRAW}",
    ]


def test_a_property_and_a_sense_follow():
    assert "  - from SHUT, SHOVE reaches OPEN within 2 s" in came(RenameEvent("PUSH", "SHOVE"))
    assert "  GREET: {when: pace > 1, release: pace < 0.5}" in came(RenameEvent("HAIL", "GREET"))


def test_a_marker_and_its_column_are_one_name():
    text = after([RenameEvent("half", "middle")])
    assert "half" not in text
    assert "markers: {middle: 0.5}" in text
    assert "SHUT at middle" in text


def test_a_column_moves_with_its_cells():
    assert came(MoveEvent("END", "GO"), text=SMALL) == [
        "  | state | END | GO |",
        "  |-------|-----|----|",
        "  | A     |     | B  |",
        "  | B     | A   |    |",
    ]
    assert edited(SMALL, [MoveEvent("END", "GO"), MoveEvent("END")]) == SMALL


@pytest.mark.parametrize(
    ("operation", "words"),
    [
        (AddEvent("PUSH"), "there is an event PUSH already"),
        (AddEvent("a|b"), "no name for the event"),
        (AddEvent("X", before="Y"), "no column is called 'Y'"),
        (RenameEvent("PUSH", "PULL"), "there is an event PULL already"),
        (RenameEvent("PUSH", "half"), "there is an event half already"),
        (RenameEvent("PUSH", "END"), "there is an event END already"),
        (RenameEvent("PUHS", "X"), "did you mean PUSH"),
        (SetEvent("X", 1), "no event is called 'X'"),
        (MoveEvent("X"), "no column is called 'X'"),
    ],
)
def test_refused(operation, words):
    with pytest.raises(MachineError, match=words):
        edited(DOOR, [operation])
