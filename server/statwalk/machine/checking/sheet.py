"""One layer's table, written out: what the verifier reads."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from statwalk.machine.authored.definition import BASE, MachineDefinition
from statwalk.machine.authored.expand import expand
from statwalk.machine.checking.findings import Finding
from statwalk.machine.checking.firing import Marks, Motions, marks_of
from statwalk.machine.checking.reach import Cells, Graph, graph_of


@dataclass(frozen=True)
class Sheet:
    """A layer's table."""

    layer: str
    definition: MachineDefinition
    """its states and cells, and all that the layers share"""
    cells: Cells
    graph: Graph
    marks: Marks
    motions: Motions

    def placed(self, found: Iterator[Finding]) -> Iterator[Finding]:
        """The findings about this table, with its layer where it is not the base."""
        for one in found:
            yield one if self.layer == BASE else replace(one, layer=self.layer, message=f"layer {self.layer}: {one.message}")


def sheets(definition: MachineDefinition, motions: Motions) -> tuple[Sheet, ...]:
    """The tables of a machine, the base first."""
    tables = definition.tables()
    marks = {layer: marks_of(table, motions) for layer, table in tables.items()}
    names = frozenset(name for one in marks.values() for several in one.values() for name in several)
    return tuple(sheet_of(layer, table, names, marks[layer], motions) for layer, table in tables.items())


def sheet_of(layer: str, table: MachineDefinition, names: Collection[str], marks: Marks, motions: Motions) -> Sheet:
    """A layer's table; `names` are the markers of all layers."""
    cells = expand(table, {*names, *(name for state in table.states.values() for name in state.markers)})
    return Sheet(layer, table, cells, graph_of(table, cells, marks), marks, motions)
