"""The resolved table of one layer, as the checks read it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from statwalk.machine.compile.resolved_table import Markers, Motions, ResolvedTable
from statwalk.machine.definition.machine_definition import BASE, MachineDefinition
from statwalk.machine.lint.findings import Finding
from statwalk.machine.lint.reach import Cells, Graph, graph_of


@dataclass(frozen=True)
class LintContext:
    """A layer's table."""

    layer: str
    definition: MachineDefinition
    """the states and cells of the layer, and everything that the layers share"""
    cells: Cells
    graph: Graph
    markers: Markers
    motions: Motions

    def placed(self, findings: Iterator[Finding]) -> Iterator[Finding]:
        """Yields the findings about this table, each with its layer unless it is the base."""
        for finding in findings:
            yield (
                finding
                if self.layer == BASE
                else replace(finding, layer=self.layer, message=f"layer {self.layer}: {finding.message}")
            )


def contexts(tables: Sequence[ResolvedTable], motions: Motions) -> tuple[LintContext, ...]:
    """Returns the context of each table, the base first."""
    return tuple(_context(table, motions) for table in tables)


def _context(table: ResolvedTable, motions: Motions) -> LintContext:
    graph = graph_of(table.definition, table.cells, table.markers)
    return LintContext(table.layer, table.definition, table.cells, graph, table.markers, motions)
