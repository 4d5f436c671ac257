"""Tells what a cell can lead to: the alternatives that can be chosen, and why a cell may never fire."""

from __future__ import annotations

from statwalk.machine.compile.resolve_defaults import Cell, Choice
from statwalk.machine.compile.resolved_table import Markers
from statwalk.machine.definition.machine_definition import END, MachineDefinition


def possible(cell: Cell) -> tuple[Choice, ...]:
    """Returns the alternatives that can be chosen: up to the first without a condition, and none of
    weight 0.
    """
    possible_choices: list[Choice] = []
    for choice in cell.choices:
        if choice.weight is None:
            possible_choices.append(choice)
            if not choice.condition:
                break
        elif choice.weight > 0:
            possible_choices.append(choice)
    return tuple(possible_choices)


def certain(cell: Cell) -> Choice | None:
    """Returns the alternative that is always chosen, if there is one."""
    choices = possible(cell)
    return choices[0] if len(choices) == 1 and not choices[0].condition and not choices[0].resume else None


def why_never(definition: MachineDefinition, cell: Cell, state: str, event: str, markers: Markers) -> str:
    """Returns why a cell can never fire in a state; empty if it can."""
    written = definition.states[state]
    if event == END or cell.when.kind == "end":
        if not written.clips:
            return f"{state} has no motion, so it has no end"
        if written.speed == 0:
            return f"the speed of {state} is 0, so its motion never ends"
    if cell.when.kind == "marker" and state in markers and cell.when.marker not in markers[state]:
        return f"the motion of {state} has no marker {cell.when.marker!r}"
    return ""
