"""Defaults of rows and columns, written out: from the authored cells to one cell for every state and event."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from statwalk.machine.celldefinition import ActionDefinition, CellDefinition, Moment
from statwalk.machine.definition import ANY, END, MachineDefinition

Source = Literal["cell", "row default", "column default", "table default"]


@dataclass(frozen=True)
class Cell:
    """A cell of the full table, with what it left to the defaults filled in; `written` is where it stands in the file."""

    written: tuple[str, str]
    source: Source
    to: str
    restart: bool
    off: bool
    when: Moment
    blend: float
    """seconds"""
    action: ActionDefinition | None
    line: int


def expand(definition: MachineDefinition) -> dict[tuple[str, str], Cell]:
    """The cell under each (state, event) that has one: the first that exists of exact, `STATE/*`, `*/EVENT`, `*/*`.

    `*` as an event stands for inputs, never for END.
    """
    found = {(state, event): find(definition, state, event) for state in definition.states for event in definition.columns}
    return {place: cell for place, cell in found.items() if cell is not None}


def find(definition: MachineDefinition, state: str, event: str) -> Cell | None:
    """The cell that counts for one state and event; None: blank, without a default."""
    places: list[tuple[str, str, Source]] = [(state, event, "cell"), (ANY, event, "column default")]
    if event != END:
        places[1:1] = [(state, ANY, "row default")]
        places.append((ANY, ANY, "table default"))
    for row, column, source in places:
        written = definition.cells.get((row, column))
        if written is not None:
            return filled(definition, written, (row, column), source)
    return None


def filled(definition: MachineDefinition, written: CellDefinition, place: tuple[str, str], source: Source) -> Cell:
    """The cell with the machine's defaults where it says nothing itself."""
    defaults = definition.defaults
    return Cell(
        written=place,
        source=source,
        to=written.to,
        restart=written.restart,
        off=written.off,
        when=written.when or defaults.when,
        blend=defaults.blend if written.blend is None else written.blend,
        action=written.action,
        line=written.line,
    )
