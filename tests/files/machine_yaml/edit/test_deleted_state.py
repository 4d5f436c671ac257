"""A state that goes: with its row, and on demand with all that speaks of it."""

import pytest
from edit_texts import DOOR, after, lines
from statwalk.errors import MachineError, RefusedEditError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import DeleteState, SetInitial


def test_it_is_refused_with_the_cells_that_lead_there():
    with pytest.raises(RefusedEditError, match="OPEN is still used: OPENING/END") as error:
        edited(DOOR, [DeleteState("OPEN")])
    places = [(finding.state, finding.event) for finding in error.value.findings]
    assert places == [("OPENING", "END"), ("GUARD.BOW", "HAIL"), *[(None, None)] * 3]


def test_cells_are_made_blank_and_lines_about_it_go():
    assert lines(DeleteState("OPEN", also_cells=True)) == [
        "-   OPEN:",
        "-     motion:                                         # it swings",
        "-       over: wind",
        "-       clips: {still: 0, swing: 1}",
        "-     loop: true",
        "-         BOW   | OPEN at end",
        "+         BOW   |",
        "-   OPENING | SHUT at half |      |       | SHUT | OPEN",
        "+   OPENING | SHUT at half |      |       | SHUT |",
        "-   OPEN    |         | SHUT |       |      |",
        "-   OPEN/PUSH:  [{if: wind > 0.5, to: SHUT}, {to: OPEN}]",
        "-   OPEN/HAIL:  {SHUT: 4, OPENING: 1}",
        "-   w:       {change: {OPEN: {wind: 1}}}",
        "- properties:",
        "-   - OPEN only after OPENING",
        "-   - from SHUT, PUSH reaches OPEN within 2 s",
        "- view:",
        "-   base:",
        "-     OPEN: [10, 20]",
    ]


def test_an_alternative_goes_and_the_others_stay():
    text = after([SetInitial("OPEN"), DeleteState("SHUT", also_cells=True)])
    assert "  OPEN/PUSH:  [{to: OPEN}]" in text
    assert "  OPEN/HAIL:  {OPENING: 1}" in text
    assert "SHUT/PUSH" not in text


def test_a_composite_state_goes_with_what_is_in_it():
    text = after([DeleteState("GUARD", also_cells=True)])
    assert "GUARD" not in text
    assert "BOW" not in text


def test_nothing_speaks_of_it_and_it_goes_at_once():
    assert lines(DeleteState("LIT", also_cells=True, layer="lamp")) == [
        "-     states: {OFF: {motion: none}, LIT: {motion: glow}}",
        "+     states: {OFF: {motion: none}}",
        "-       OFF   | LIT",
        "+       OFF   |",
    ]


def test_the_initial_state_stays():
    with pytest.raises(MachineError, match="SHUT is the initial state; choose another one first"):
        edited(DOOR, [DeleteState("SHUT", also_cells=True)])
