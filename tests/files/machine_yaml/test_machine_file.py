"""Reads every key of a machine file; a table may be in its own file."""

import pytest
from machine_texts import ROBOT
from paths import MACHINES
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import load_machine, read_machine


def test_all_that_a_machine_says():
    machine = read_machine(ROBOT)
    assert (machine.title, machine.initial, list(machine.events)) == ("A robot", "STAT", ["FORWARD", "STOP"])
    cell = machine.cells["WALK", "STOP"]
    assert (cell.to, str(cell.when), cell.blend, str(cell.action), cell.line) == (
        "STAT",
        "end",
        0.1,
        "halt",
        13,
    )  # the line that says where it leads
    assert (machine.states["WALK"].speed, machine.states["STAT"].loop, machine.states["WALK"].loop) == (
        "pace",
        True,
        None,
    )
    assert (machine.keys["ArrowUp"].press, machine.keys["ArrowUp"].hold, machine.keys["ArrowUp"].release) == (
        "FORWARD",
        True,
        "STOP",
    )
    assert (machine.parameters["pace"].maximum, machine.defaults.buffer) == (2, 0.5)
    assert machine.rows[1] == ("STAT", "WALK", "", "")


def test_a_next_state_that_does_not_exist_is_kept_for_the_verifier():
    assert read_machine(ROBOT.replace("| WALK    |", "| WLAK    |")).cells["STAT", "FORWARD"].to == "WLAK"


def test_no_and_on_are_names_like_others():
    text = ROBOT.replace("FORWARD", "on").replace("STAT", "no")
    assert list(read_machine(text).states) == ["no", "WALK"]


def test_a_folder(tmp_path):
    (tmp_path / "machine.yaml").write_text(ROBOT)
    file = load_machine(tmp_path)
    assert (file.character_path, file.root_joint, file.text) == (
        tmp_path / "robot.glb",
        "Hips",
        ROBOT,
    )
    assert file.table_text.splitlines()[0] == "state | FORWARD | STOP | END"


def test_a_table_of_its_own(tmp_path):
    head, rest = ROBOT.split("table: |\n")
    rows, tail = rest.split("cells:\n")
    (tmp_path / "machine.yaml").write_text(f"{head}table: steps.csv\ncells:\n{tail}")
    (tmp_path / "steps.csv").write_text("\n".join(row.strip().replace("|", ",") for row in rows.splitlines()))
    assert load_machine(tmp_path).definition.cells["WALK", "END"].to == "WALK"
    (tmp_path / "steps.csv").write_text("state,FORWARD\nSTAT,WALK\nWLAK,STAT\n")
    with pytest.raises(MachineError, match=r"steps\.csv, line 3: no state is called 'WLAK'"):
        load_machine(tmp_path)


@pytest.mark.parametrize("name", ["faq-walker", "faq-printed"])
def test_shipped_machines_can_be_read(name):
    assert load_machine(MACHINES / name).definition.initial == "STAT"
