"""Laws of operations, over all shipped machines: comments and other lines stay, a rename is an isomorphism
of the program, and an operation followed by its inverse gives the same program.
"""

import random
import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
import pytest
from statwalk.character.role import Role
from statwalk.files.machine_yaml.edit.cell_edits import events_of
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import (
    AddEvent,
    AddState,
    DeleteEvent,
    DeleteState,
    EditOperation,
    MoveState,
    NestState,
    RenameEvent,
    RenameParameter,
    RenameState,
    SetCell,
    SetView,
    UnnestState,
)
from statwalk.files.machine_yaml.edit.table_levels import entries_at, levels, raw_table, read
from statwalk.files.machine_yaml.machine_file import load_machine, read_machine
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.machine.conditions.variables import NAMES
from statwalk.machine.definition.machine_definition import ANY, MachineDefinition
from statwalk.services.library.load import load_shipped, machine_folders

SHIPPED = sorted(machine_folders())
TRIES = 12


@cache
def text_of(machine: str) -> str:
    return (machine_folders()[machine] / "machine.yaml").read_text(encoding="utf-8")


@cache
def role_of(machine: str) -> Role:
    return load_shipped(machine)


@cache
def root_of(machine: str) -> str | None:
    return load_machine(machine_folders()[machine]).root_joint


def program(machine: str, text: str) -> Iterator[Any]:
    """The arrays of the program that a text compiles to, with the character of a machine."""
    role = role_of(machine)
    definition: MachineDefinition = read_machine(text, machine)
    built = Role.build(machine, role.character, definition, root_of(machine), before=role)
    yield from flat(built.machine.program)


def flat(value: Any) -> Iterator[Any]:
    if isinstance(value, np.ndarray):
        yield value
    else:
        for part in value:
            yield from flat(part)


def assert_same_program(machine: str, text: str) -> None:
    before, after = list(program(machine, text_of(machine))), list(program(machine, text))
    assert len(before) == len(after)
    for one, other in zip(before, after, strict=True):
        assert (one.dtype, one.tobytes()) == (other.dtype, other.tobytes())


def states_of(text: str) -> list[tuple[str, str]]:
    """(layer, full name) of all states."""
    return [(at.layer, at.full(name)) for at in levels(read(MachineText.of(text))) for name in at.states()]


def parameters_of(text: str) -> list[str]:
    """Those that hide no measured value of the same name, which a rename would show again."""
    return [name for name in entries_at(read(MachineText.of(text)), "parameters") if name not in NAMES]


def renames(text: str) -> Iterator[EditOperation]:
    """Some renames of a machine, of all kinds."""
    chosen = random.Random(len(text))
    states = chosen.sample(states_of(text), min(4, len(states_of(text))))
    yield from (RenameState(state, "A_longer_name_than_before", layer) for layer, state in states)
    events = list(events_of(MachineText.of(text)))
    yield from (RenameEvent(event, "E2") for event in chosen.sample(events, min(4, len(events))))
    parameters = parameters_of(text)
    yield from (RenameParameter(name, "zz") for name in chosen.sample(parameters, min(3, len(parameters))))


def old_name(operation: Any) -> str:
    name = getattr(operation, "state", None) or getattr(operation, "event", None) or operation.name
    return str(name).rpartition(".")[2] if hasattr(operation, "state") else str(name)


@pytest.mark.parametrize("machine", SHIPPED)
def test_a_rename_is_an_isomorphism_of_the_program(machine: str) -> None:
    for operation in renames(text_of(machine)):
        assert_same_program(machine, edited(text_of(machine), [operation]))


@pytest.mark.parametrize("machine", SHIPPED)
def test_a_rename_touches_only_lines_with_the_name(machine: str) -> None:
    """A table's other lines change at most in spaces, because a column becomes wider."""
    text = text_of(machine)
    for operation in renames(text):
        word = re.compile(rf"(?<![\w-]){re.escape(old_name(operation))}(?![\w-])")
        before, after = text.splitlines(), edited(text, [operation]).splitlines()
        assert len(before) == len(after)
        for old, new in zip(before, after, strict=True):
            if old != new and not word.search(old):
                assert "|" in old
                assert (old.replace(" ", ""), "#" in old) == (new.replace(" ", ""), False)


@pytest.mark.parametrize("machine", SHIPPED)
def test_renamed_there_and_back_it_is_the_same_machine(machine: str) -> None:
    text = text_of(machine)
    (layer, state), events = states_of(text)[-1], list(events_of(MachineText.of(text)))[:1]
    outer, _, own = state.rpartition(".")
    there = [RenameState(state, "There", layer), *(RenameEvent(event, "E2") for event in events)]
    back = [
        RenameState(f"{outer}.There".strip("."), own, layer),
        *(RenameEvent("E2", event) for event in events),
    ]
    again = edited(text, [*there, *back])
    assert_same_program(machine, again)
    assert [line.split() for line in again.splitlines()] == [line.split() for line in text.splitlines()]


@pytest.mark.parametrize("machine", SHIPPED)
def test_a_sub_machine_around_a_state_changes_no_program(machine: str) -> None:
    """Neither its making nor its end; the lines that speak of something else stay."""
    text = text_of(machine)
    for layer, state in random.Random(len(text)).sample(states_of(text), min(4, len(states_of(text)))):
        outer, _, own = state.rpartition(".")
        into = f"{outer}.AROUND".strip(".")
        nested = edited(text, [NestState(state, into, layer)])
        assert_same_program(machine, nested)
        again = edited(nested, [UnnestState(f"{into}.{own}", layer)])
        assert_same_program(machine, again)
        assert sorted(again.split()) == sorted(text.split())


@pytest.mark.parametrize("machine", SHIPPED)
def test_what_was_added_goes_without_a_trace(machine: str) -> None:
    text = text_of(machine)
    layer, state = states_of(text)[0]
    added = edited(text, [AddState("N9", before=state, layer=layer)])
    assert edited(added, [DeleteState("N9", layer=layer)]) == text
    event = edited(text, [AddEvent("E2", buffer=1)])
    assert edited(event, [DeleteEvent("E2", also_cells=True)]).split() == text.split()


@pytest.mark.parametrize("machine", SHIPPED)
def test_moved_there_and_back_it_is_the_same_text(machine: str) -> None:
    text = text_of(machine)
    own = [name for layer, name in states_of(text) if layer == "base" and "." not in name]
    if len(own) > 1:
        moved = edited(text, [MoveState(own[-1], own[0])])
        assert edited(moved, [MoveState(own[-1])]).splitlines() == text.splitlines()


@pytest.mark.parametrize("machine", SHIPPED)
def test_places_in_the_graph_change_nothing_else(machine: str) -> None:
    layer, state = states_of(text_of(machine))[0]
    text = edited(text_of(machine), [SetView({state: (10, -20)}, layer)])
    assert text.startswith(text_of(machine).rstrip("\n"))
    assert_same_program(machine, text)


@pytest.mark.parametrize("machine", SHIPPED)
def test_random_cells_there_and_back(machine: str) -> None:
    """Each cell is a line of its own; back again it is the same text but for spaces."""
    text, chosen = text_of(machine), random.Random(7)
    for level in levels(read(MachineText.of(text))):
        table = raw_table(MachineText.of(text), level)
        under_cells = level.entry("cells")
        for _ in range(TRIES if table else 0):
            assert table is not None
            row, column = chosen.choice(table.names()), chosen.choice(table.columns())
            named = under_cells is not None and f"{row}/{column}" in under_cells.entries()
            if ANY in (row, column) or named:
                continue
            old, new = table.cell(row, column), chosen.choice([*level.states(), "-", ""])
            there = edited(text, [SetCell(level.full(row), column, new, layer=level.layer)])
            pairs = zip(text.splitlines(), there.splitlines(), strict=True)
            different = [one for one, other in pairs if one != other]
            assert len(different) == (old != new)
            back = edited(there, [SetCell(level.full(row), column, old, layer=level.layer)])
            assert back.split() == text.split()
