"""What a cell can come to: the outcomes that can be chosen, and why one may never fire."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from statwalk.machine.authored.definition import END, MachineDefinition
from statwalk.machine.authored.expand import Cell, Choice
from statwalk.machine.built.buildstates import MotionFacts, markers_of


def possible(cell: Cell) -> tuple[Choice, ...]:
    """The outcomes that can come about, conditions and weights being free: up to the first without a condition, and none of weight 0."""
    found: list[Choice] = []
    for choice in cell.choices:
        if choice.weight is None:
            found.append(choice)
            if not choice.condition:
                break
        elif choice.weight > 0:
            found.append(choice)
    return tuple(found)


def certain(cell: Cell) -> Choice | None:
    """The outcome that always comes about, if there is one."""
    found = possible(cell)
    return found[0] if len(found) == 1 and not found[0].condition and not found[0].resume else None


Motions = Mapping[str, MotionFacts] | None
"""by name; None: the character is not known"""
Marks = Mapping[str, Collection[str]]
"""the markers of each state's motion; of no other than the states whose motions are known"""


def marks_of(definition: MachineDefinition, motions: Motions) -> Marks:
    """The markers of all states of a table."""
    known = {name: state for name, state in definition.states.items() if motions is not None and motions.keys() >= set(state.clips)}
    return {name: frozenset(marker for marker, _ in markers_of(state, motions or {})) for name, state in known.items()}


def why_never(definition: MachineDefinition, cell: Cell, state: str, event: str, marks: Marks) -> str:
    """Why a cell can never fire in a state; empty where it can."""
    one = definition.states[state]
    if event == END or cell.when.kind == "end":
        if not one.clips:
            return f"{state} has no motion, so it has no end"
        if one.speed == 0:
            return f"the speed of {state} is 0, so its motion never ends"
    if cell.when.kind == "marker" and state in marks and cell.when.marker not in marks[state]:
        return f"the motion of {state} has no marker {cell.when.marker!r}"
    return ""
