"""An event that goes: with its columns, and on demand with all that speaks of it."""

import pytest
from edit_texts import DOOR, after, came
from statwalk.errors import RefusedEditError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import AddEvent, DeleteEvent


def test_it_is_refused_with_what_speaks_of_it():
    with pytest.raises(RefusedEditError, match="PULL is still used: SHUT/PULL, OPEN/PULL") as error:
        edited(DOOR, [DeleteEvent("PULL")])
    places = [(finding.state, finding.event) for finding in error.value.findings]
    assert places == [("SHUT", "PULL"), ("OPEN", "PULL"), (None, None), (None, None)]


def test_its_column_cells_and_keys_go():
    assert came(DeleteEvent("PULL", also_cells=True)) == [
        "  state   | PUSH    | HAIL  | half | END",
        "  SHUT    | OPENING | GUARD |      |",
        "  OPENING | SHUT at half |       | SHUT | OPEN",
        "  OPEN    |         |       |      |",
        "  GUARD   | SHUT    |       |      | SHUT",
        "  ArrowUp: {hold: PUSH}",
    ]


def test_its_sense_and_its_properties_go():
    assert "senses" not in after([DeleteEvent("HAIL", also_cells=True)])
    text = after([DeleteEvent("PUSH", also_cells=True)])
    assert "reaches" not in text
    assert "ArrowUp" not in text


def test_added_and_deleted_it_leaves_no_trace():
    assert edited(DOOR, [AddEvent("KNOCK", before="END"), DeleteEvent("KNOCK")]) == DOOR
