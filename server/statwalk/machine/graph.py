"""A layer's table as a picture needs it: the edges of its graph, and the full table with the place that each
cell comes from.
"""

from __future__ import annotations

from typing import Any

from statwalk.machine.compile.resolve_defaults import Cell, Choice, landings
from statwalk.machine.compile.resolved_table import ResolvedTable


def edges(table: ResolvedTable) -> list[dict[str, Any]]:
    """Returns `{from, to, events}` for each pair of states that a cell joins, by the table's order, without
    stays; restarts are loops.
    """
    found: dict[tuple[str, str], dict[str, None]] = {}
    for (state, event), cell in table.cells.items():
        for choice in cell.choices:
            for there in landings(table.definition, choice):
                if there != state or choice.restart:
                    found.setdefault((state, there), {})[event] = None
    return [{"from": here, "to": there, "events": list(events)} for (here, there), events in found.items()]


def full_table(table: ResolvedTable) -> dict[str, dict[str, dict[str, Any]]]:
    """Returns `{state: {event: cell}}` without blanks.

    A cell has to (None for `-`), when, blend (seconds), curve, enter, restart, action, source, line, written
    (row and column in the file) and alternatives, if it has several: `to` and `restart` are then those of
    the first; blend, curve, enter and action are the cell's own.
    """
    found: dict[str, dict[str, dict[str, Any]]] = {state: {} for state in table.definition.states}
    for (state, event), cell in table.cells.items():
        found[state][event] = _cell_view(cell)
    return found


def _cell_view(cell: Cell) -> dict[str, Any]:
    first = cell.choices[0] if cell.choices else None
    return {
        "to": first.to if first else None,
        "when": str(cell.when),
        "blend": cell.blend,
        "curve": cell.curve,
        "enter": cell.enter,
        "restart": first.restart if first else False,
        "action": str(cell.action) if first and cell.action else None,
        "source": cell.source,
        "line": cell.line,
        "written": list(cell.written),
        "alternatives": [_alternative_view(choice) for choice in cell.choices] if cell.alternatives else [],
    }


def _alternative_view(choice: Choice) -> dict[str, Any]:
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
