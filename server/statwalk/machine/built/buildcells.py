"""From the full table to arrays: what each cell leads to, when, how it blends, and what comes out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.authored.celldefinition import ActionDefinition
from statwalk.machine.authored.definition import MachineDefinition, nearest
from statwalk.machine.authored.expand import Cell, Choice, expand
from statwalk.machine.built.runparts import BLANK, CURVES, MATCH, MIXED, OFF, UNDEFINED, Outcome
from statwalk.machine.conditions.program import Program

WHENS = ("now", "end", "marker", "window")
"""the kinds of moments by their numbers"""
Conditions = Callable[[str, int], Program]
"""a condition from its text and the line it stands in"""
Place = tuple[int, int]
"""state and event, as rows"""


@dataclass
class Cells:
    """The cells of all layers, by their places in the arrays."""

    full: dict[Place, Cell] = field(default_factory=dict)
    outcomes: dict[Place, tuple[Outcome, ...]] = field(default_factory=dict)
    actions: dict[ActionDefinition, int] = field(default_factory=dict)
    """by the order in which they were met"""


def cell_arrays(tables: Mapping[str, MachineDefinition], states: Mapping[str, Any], conditions: Conditions) -> dict[str, Any]:
    """The fields of Machine that stand for cells, (S, E); `states` are those of `state_arrays`. Raises MachineError."""
    events = next(iter(tables.values())).columns
    cells = Cells()
    first = 0
    for layer, table in tables.items():
        collect(cells, layer, table, states, first, conditions)
        first += len(table.states)
    return {
        **arrays_of((first, len(events)), cells),
        "layer_concerns": concerns(cells, states["layer_of"], len(tables), len(events)),
        "outcomes": cells.outcomes,
        "moments": {place: cell.when for place, cell in cells.full.items() if cell.when.kind in ("marker", "window")},
        "sources": {place: cell.written for place, cell in cells.full.items()},
        "undefined": {
            place: several[0].to for place, several in cells.outcomes.items() if len(several) == 1 and several[0].target == UNDEFINED
        },
        "actions": tuple(cells.actions),
    }


def collect(cells: Cells, layer: str, table: MachineDefinition, states: Mapping[str, Any], first: int, conditions: Conditions) -> None:
    """Adds the cells of a layer whose states begin at row `first`."""
    names = {name for markers in states["markers"] for name, _ in markers}
    rows = {name: first + row for row, name in enumerate(table.states)}
    histories = {outer: row for row, (owner, outer) in enumerate(states["histories"]) if owner == layer}
    for (state, event), cell in expand(table, names).items():
        place = rows[state], table.columns.index(event)
        check_marker(table, cell, state, states["markers"][place[0]])
        cells.full[place] = cell
        if not cell.off:
            cells.outcomes[place] = tuple(outcome_of(choice, rows, histories, cells.actions, conditions) for choice in cell.choices)


def outcome_of(
    choice: Choice, rows: Mapping[str, int], histories: Mapping[str, int], actions: dict[ActionDefinition, int], conditions: Conditions
) -> Outcome:
    """One outcome, its names as rows."""
    return Outcome(
        target=rows.get(choice.to, UNDEFINED),
        restart=choice.restart,
        blend=float(np.float32(choice.blend)),
        curve=CURVES.index(choice.curve),
        enter=MATCH if choice.enter == "match" else float(choice.enter),
        action=actions.setdefault(choice.action, len(actions)) if choice.action else -1,
        to=choice.to,
        resume=histories.get(choice.resume, -1),
        condition=conditions(choice.condition, choice.line) if choice.condition else None,
        said=choice.condition,
        weight=choice.weight,
    )


def check_marker(table: MachineDefinition, cell: Cell, state: str, markers: tuple[tuple[str, float], ...]) -> None:
    """Raises MachineError where a cell written for one state waits for a marker that its motion has not."""
    known = tuple(dict.fromkeys(name for name, _ in markers))
    if cell.when.kind == "marker" and cell.written[0] == state and cell.when.marker not in known and not cell.off:
        message = f"the motion of {state} has no marker {cell.when.marker!r}{nearest(cell.when.marker, known) or '.'}"
        raise table.refuse(f"{message} There are: {', '.join(known) or 'none'}", cell.line)


def arrays_of(shape: tuple[int, int], cells: Cells) -> dict[str, NDArray[Any]]:
    """target, when, restart, blend, curve, enter and action, each (S, E); of several outcomes the first one's."""
    target, when = np.full(shape, BLANK, np.int16), np.zeros(shape, np.uint8)
    restart, blend, action = np.zeros(shape, bool), np.zeros(shape, np.float32), np.full(shape, -1, np.int16)
    curve, enter = np.zeros(shape, np.uint8), np.zeros(shape, np.float32)
    for place, cell in cells.full.items():
        several = cells.outcomes.get(place)
        when[place] = WHENS.index(cell.when.kind)
        target[place] = target_of(several)
        if several:
            one = several[0]
            restart[place], blend[place], action[place] = one.restart, one.blend, one.action
            curve[place], enter[place] = one.curve, one.enter
    return {"target": target, "when": when, "restart": restart, "blend": blend, "curve": curve, "enter": enter, "action": action}


def target_of(several: tuple[Outcome, ...] | None) -> int:
    """What stands in the table: MIXED also where the only outcome has a condition, or may be another state than it says."""
    if not several:
        return OFF
    plain = len(several) == 1 and several[0].condition is None and several[0].resume < 0
    return several[0].target if plain else MIXED


def concerns(cells: Cells, layer_of: NDArray[np.int16], layers: int, events: int) -> NDArray[np.bool_]:
    """(L, E) whether a layer's table says anything about an event."""
    found = np.zeros((layers, events), bool)
    for state, event in cells.full:
        found[layer_of[state], event] = True
    return found
