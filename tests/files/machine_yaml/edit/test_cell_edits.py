"""A cell changed in the text of a machine file, and nothing else."""

from __future__ import annotations

import difflib

import pytest
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
