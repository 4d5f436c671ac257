"""The machine as a picture needs it: the edges of its graph, and the full table with where each cell comes from."""

from __future__ import annotations

from typing import Any

from statwalk.machine.definition import MachineDefinition
from statwalk.machine.expand import expand


def edges(definition: MachineDefinition) -> list[dict[str, Any]]:
    """`{from, to, events}` for each pair of states that a cell joins, in the order of the table; stays are left out, restarts are loops."""
    found: dict[tuple[str, str], list[str]] = {}
    for (state, event), cell in expand(definition).items():
        if not cell.off and cell.to in definition.states and (cell.to != state or cell.restart):
            found.setdefault((state, cell.to), []).append(event)
    return [{"from": here, "to": there, "events": events} for (here, there), events in found.items()]


def full_table(definition: MachineDefinition) -> dict[str, dict[str, dict[str, Any]]]:
    """`{state: {event: cell}}`; a cell has to (None for `-`), when, blend (seconds), restart, action, source, line. Blanks are left out."""
    table: dict[str, dict[str, dict[str, Any]]] = {state: {} for state in definition.states}
    for (state, event), cell in expand(definition).items():
        table[state][event] = {
            "to": None if cell.off else cell.to,
            "when": str(cell.when),
            "blend": cell.blend,
            "restart": cell.restart,
            "action": str(cell.action) if cell.action else None,
            "source": cell.source,
            "line": cell.line,
        }
    return table
