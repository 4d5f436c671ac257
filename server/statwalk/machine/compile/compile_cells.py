"""Compiles the cells of the full tables to arrays: targets, timings, blends and actions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.alternatives import BLANK, CURVES, MATCH, MIXED, OFF, UNDEFINED, Alternative
from statwalk.machine.compile.resolve_defaults import Cell, Choice
from statwalk.machine.compile.resolved_table import ResolvedTable
from statwalk.machine.definition.cell_definition import ActionDefinition
from statwalk.machine.definition.machine_definition import MachineDefinition, nearest
from statwalk.maths.formula.postfix import Formula

WHENS = ("now", "end", "marker", "window")
"""the kinds of timings, by their numbers"""
Conditions = Callable[[str, int], Formula]
"""reads a condition from its text and its line"""
Place = tuple[int, int]
"""rows of a state and an event"""


@dataclass
class Cells:
    """The cells of all layers, by their rows in the arrays."""

    full: dict[Place, Cell] = field(default_factory=dict)
    alternatives: dict[Place, tuple[Alternative, ...]] = field(default_factory=dict)
    actions: dict[ActionDefinition, int] = field(default_factory=dict)
    """numbered in the order in which the cells name them"""


def cell_arrays(
    tables: Sequence[ResolvedTable], states: Mapping[str, Any], conditions: Conditions
) -> dict[str, Any]:
    """Returns the fields of Machine that describe cells, (S, E); `states` are the fields from `state_arrays`.

    :raises MachineError: when a cell waits for a marker that its motion does not have, or a condition cannot
        be read.
    """
    events = tables[0].definition.columns
    cells = Cells()
    first = 0
    for table in tables:
        collect(cells, table, states, first, conditions)
        first += len(table.definition.states)
    return {
        **_arrays_of((first, len(events)), cells),
        "layer_concerns": concerns(cells, states["layer_of"], len(tables), len(events)),
        "alternatives": cells.alternatives,
        "timings": {
            place: cell.when for place, cell in cells.full.items() if cell.when.kind in ("marker", "window")
        },
        "sources": {place: cell.written for place, cell in cells.full.items()},
        "undefined": {
            place: alternatives[0].to
            for place, alternatives in cells.alternatives.items()
            if len(alternatives) == 1 and alternatives[0].target == UNDEFINED
        },
        "actions": tuple(cells.actions),
    }


def collect(
    cells: Cells, resolved: ResolvedTable, states: Mapping[str, Any], first: int, conditions: Conditions
) -> None:
    """Adds the cells of one layer, whose states begin at row `first`.

    :raises MachineError: when a cell waits for a marker that its motion does not have, or a condition cannot
        be read.
    """
    table = resolved.definition
    rows = {name: first + row for row, name in enumerate(table.states)}
    histories = {
        composite: row
        for row, (owner, composite) in enumerate(states["histories"])
        if owner == resolved.layer
    }
    for (state, event), cell in resolved.cells.items():
        place = rows[state], table.columns.index(event)
        _check_marker(table, cell, state, states["markers"][place[0]])
        cells.full[place] = cell
        if not cell.off:
            cells.alternatives[place] = tuple(
                _alternative_of(choice, rows, histories, cells.actions, conditions) for choice in cell.choices
            )


def _alternative_of(
    choice: Choice,
    rows: Mapping[str, int],
    histories: Mapping[str, int],
    actions: dict[ActionDefinition, int],
    conditions: Conditions,
) -> Alternative:
    return Alternative(
        target=rows.get(choice.to, UNDEFINED),
        restart=choice.restart,
        blend=float(np.float32(choice.blend)),
        curve=CURVES.index(choice.curve),
        enter=MATCH if choice.enter == "match" else float(choice.enter),
        action=actions.setdefault(choice.action, len(actions)) if choice.action else -1,
        to=choice.to,
        resume=histories.get(choice.resume, -1),
        condition=conditions(choice.condition, choice.line) if choice.condition else None,
        weight=choice.weight,
    )


def _check_marker(
    table: MachineDefinition, cell: Cell, state: str, markers: tuple[tuple[str, float], ...]
) -> None:
    marker_names = tuple(dict.fromkeys(name for name, _ in markers))
    if (
        cell.when.kind == "marker"
        and cell.written[0] == state
        and cell.when.marker not in marker_names
        and not cell.off
    ):
        message = (
            f"the motion of {state} has no marker "
            f"{cell.when.marker!r}{nearest(cell.when.marker, marker_names) or '.'}"
        )
        raise table.refuse(f"{message} There are: {', '.join(marker_names) or 'none'}", cell.line)


def _arrays_of(shape: tuple[int, int], cells: Cells) -> dict[str, NDArray[Any]]:
    """target and when, each (S, E)."""
    target, when = np.full(shape, BLANK, np.int16), np.zeros(shape, np.uint8)
    for place, cell in cells.full.items():
        target[place], when[place] = _target_of(cells.alternatives.get(place)), WHENS.index(cell.when.kind)
    return {"target": target, "when": when}


def _target_of(alternatives: tuple[Alternative, ...] | None) -> int:
    """MIXED also for a single alternative with a condition, and for one that resumes: its state is known
    only at runtime.
    """
    if not alternatives:
        return OFF
    plain = len(alternatives) == 1 and alternatives[0].condition is None and alternatives[0].resume < 0
    return alternatives[0].target if plain else MIXED


def concerns(cells: Cells, layer_of: NDArray[np.int16], layers: int, events: int) -> NDArray[np.bool_]:
    """Returns (L, E) whether the table of a layer has a cell for an event."""
    is_concerned = np.zeros((layers, events), bool)
    for state, event in cells.full:
        is_concerned[layer_of[state], event] = True
    return is_concerned
