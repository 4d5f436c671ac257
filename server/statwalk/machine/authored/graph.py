"""The machine as a picture needs it: the edges of its graph, and the full table with where each cell comes from; for one layer each."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from statwalk.machine.authored.definition import MachineDefinition
from statwalk.machine.authored.expand import Cell, Choice, expand, landings


def edges(definition: MachineDefinition, markers: Collection[str] = ()) -> list[dict[str, Any]]:
    """`{from, to, events}` for each pair of states that a cell joins, in the order of the table; stays are left out, restarts are loops."""
    found: dict[tuple[str, str], dict[str, None]] = {}
    for (state, event), cell in expand(definition, markers).items():
        for choice in cell.choices:
            for there in landings(definition, choice):
                if there != state or choice.restart:
                    found.setdefault((state, there), {})[event] = None
    return [{"from": here, "to": there, "events": list(events)} for (here, there), events in found.items()]


def full_table(definition: MachineDefinition, markers: Collection[str] = ()) -> dict[str, dict[str, dict[str, Any]]]:
    """`{state: {event: cell}}`; blanks are left out. A cell has to (None for `-`), when, blend (seconds), curve, enter, restart, action,

    source, line, written (row and column where it stands) and alternatives, where there are several outcomes.
    """
    table: dict[str, dict[str, dict[str, Any]]] = {state: {} for state in definition.states}
    for (state, event), cell in expand(definition, markers).items():
        table[state][event] = said(cell)
    return table


def said(cell: Cell) -> dict[str, Any]:
    """All that a cell says."""
    first = cell.choices[0] if cell.choices else None
    return {
        "to": first.to if first else None,
        "when": str(cell.when),
        "blend": first.blend if first else cell.blend,
        "curve": first.curve if first else cell.curve,
        "enter": first.enter if first else cell.enter,
        "restart": first.restart if first else False,
        "action": str(first.action) if first and first.action else None,
        "source": cell.source,
        "line": cell.line,
        "written": list(cell.written),
        "alternatives": [outcome(choice) for choice in cell.choices] if cell.alternatives else [],
    }


def outcome(choice: Choice) -> dict[str, Any]:
    """One of several outcomes."""
    return {
        "to": choice.to,
        "condition": choice.condition,
        "weight": choice.weight,
        "blend": choice.blend,
        "curve": choice.curve,
        "enter": choice.enter,
        "restart": choice.restart,
        "action": str(choice.action) if choice.action else None,
    }
