"""Sub-machines are flattened: OUTER.INNER, names from inside out, rows of the outer state, tables within
tables.
"""

import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.definition.machine_definition import CompositeDefinition

TEXT = """character: c.glb
initial: FIGHT
fallback: FIGHT
states:
  WALK: {motion: walk, loop: true}
  FIGHT:
    resume: true
    machine:
      initial: GUARD
      states:
        GUARD: {motion: guard, loop: true}
        HIT: {motion: hit, final: true}
        COMBO:
          final: true
          machine:
            initial: LEFT
            states:
              LEFT: {motion: left}
              RIGHT: {motion: right, final: true}
            cells: {LEFT/END: {to: RIGHT}, RIGHT/BACK: {to: GUARD}}
      table: |
        state | PUNCH | BACK | WALK
        GUARD | HIT   |      | WALK
        *     | COMBO | -    |
      cells:
        HIT/PUNCH: {to: [{if: speed > 1, to: COMBO.RIGHT}, {to: WALK}]}
table: |
  state      | GO    | END
  WALK       | FIGHT |
  FIGHT      | WALK  | WALK
  FIGHT.HIT  | WALK! |
cells:
  FIGHT.GUARD/PUNCH: {blend: 0.5}
"""


def test_states_are_flattened_in_the_order_of_the_file():
    machine = read_machine(TEXT)
    assert list(machine.states) == [
        "WALK",
        "FIGHT.GUARD",
        "FIGHT.HIT",
        "FIGHT.COMBO.LEFT",
        "FIGHT.COMBO.RIGHT",
    ]
    assert [one.composite for one in machine.states.values()] == [
        "",
        "FIGHT",
        "FIGHT",
        "FIGHT.COMBO",
        "FIGHT.COMBO",
    ]
    assert machine.states["FIGHT.HIT"].final
    assert machine.composites == {
        "FIGHT": CompositeDefinition("FIGHT.GUARD", True, 7, "", False),
        "FIGHT.COMBO": CompositeDefinition("FIGHT.COMBO.LEFT", False, 14, "FIGHT", True),
    }


def test_a_machine_begins_and_falls_back_in_the_innermost_state():
    assert (read_machine(TEXT).initial, read_machine(TEXT).fallback) == ("FIGHT.GUARD", "FIGHT.GUARD")


def test_columns_of_all_tables_are_events():
    assert list(read_machine(TEXT).events) == ["GO", "PUNCH", "BACK", "WALK"]


def test_names_are_looked_for_from_inside_out():
    cells = read_machine(TEXT).cells
    assert cells["FIGHT.GUARD", "PUNCH"].to == "FIGHT.HIT"
    assert cells["FIGHT.GUARD", "WALK"].to == "WALK"
    assert cells["FIGHT.*", "PUNCH"].to == "FIGHT.COMBO"
    assert cells["FIGHT.COMBO.LEFT", "END"].to == "FIGHT.COMBO.RIGHT"
    assert cells["FIGHT.COMBO.RIGHT", "BACK"].to == "FIGHT.GUARD"
    assert [one.to for one in cells["FIGHT.HIT", "PUNCH"].alternatives] == ["FIGHT.COMBO.RIGHT", "WALK"]


def test_the_outer_table_may_speak_of_inner_states():
    cells = read_machine(TEXT).cells
    assert (cells["FIGHT.HIT", "GO"].to, cells["FIGHT.HIT", "GO"].restart) == ("WALK", True)
    assert (cells["FIGHT.GUARD", "PUNCH"].to, cells["FIGHT.GUARD", "PUNCH"].blend) == ("FIGHT.HIT", 0.5)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("initial: GUARD", "initial: WALK", "line 9: no state is called 'WALK'"),
        ("GUARD | HIT   |", "GARD | HIT   |", "line 23: no state is called 'GARD'; did you mean GUARD?"),
        ("HIT/PUNCH", "HIIT/PUNCH", "line 26: no state is called 'HIIT'; did you mean HIT?"),
        ("FIGHT.HIT  |", "FIGHT.HOT  |", "line 31: no state is called 'FIGHT.HOT'; did you mean FIGHT.HIT?"),
        (
            "  WALK: {motion: walk",
            "  FIGHT.HIT: {motion: walk",
            "line 12: the state FIGHT.HIT was already given in line 5",
        ),
        ("resume: true", "resum: true", "line 7: no key is called 'resum'; did you mean resume?"),
        (
            "GO    | END\n",
            "PUNCH | END\n  FIGHT.GUARD | FIGHT |\n",
            "line 29: the cell FIGHT.GUARD/PUNCH was already given in line 23",
        ),
    ],
)
def test_errors_name_the_place_within(old, new, message):
    assert old in TEXT
    with pytest.raises(MachineError) as caught:
        read_machine(TEXT.replace(old, new, 1))
    assert message in str(caught.value)
