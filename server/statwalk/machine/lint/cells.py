"""Finds faults of cells: cells that never count or never fire, and alternatives that are never chosen."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.machine.definition.cell_definition import AlternativeDefinition
from statwalk.machine.definition.machine_definition import END
from statwalk.machine.lint.findings import Finding, Severity
from statwalk.machine.lint.firing import why_never
from statwalk.machine.lint.lint_context import LintContext


def shadowed(context: LintContext) -> Iterator[Finding]:
    """Finds defaults, of `*` or of a composite state, that never count, as more specific cells cover every
    state and event they stand for.
    """
    counted = {cell.written for cell in context.cells.values()}
    for (row, column), cell in context.definition.cells.items():
        if (row, column) not in counted and not (column == END and row in context.definition.composites):
            message = f"{row}/{column} never counts: other cells come before it"
            yield Finding("cell never fires", "warning", message, cell.line, row, column)


def never_firing(context: LintContext) -> Iterator[Finding]:
    """Finds cells whose moment never comes in any state that they count for; a cell written for the state
    itself is an error.
    """
    reasons: dict[tuple[str, str], list[str]] = {}
    for (state, event), cell in context.cells.items():
        if not cell.off:
            reasons.setdefault(cell.written, []).append(
                why_never(context.definition, cell, state, event, context.markers)
            )
    for (row, column), whys in reasons.items():
        if all(whys):
            written, is_own = context.definition.cells[row, column], row in context.definition.states
            severity: Severity = "error" if is_own and "marker" in whys[0] else "warning"
            yield Finding(
                "cell never fires",
                severity,
                f"{row}/{column} never fires: {whys[0]}",
                written.line,
                row,
                column,
            )


def unchosen(context: LintContext) -> Iterator[Finding]:
    """Finds alternatives after one without a condition, and alternatives of weight 0."""
    for (row, column), cell in context.definition.cells.items():
        for number, alternative in enumerate(cell.alternatives):
            why = _why_unchosen(cell.alternatives[:number], alternative)
            if why:
                yield Finding(
                    "alternative never chosen",
                    "warning",
                    f"{row}/{column}: {alternative.to} is never chosen, {why}",
                    alternative.line,
                    row,
                    column,
                )


def _why_unchosen(before: tuple[AlternativeDefinition, ...], alternative: AlternativeDefinition) -> str:
    """Why an alternative is never chosen; empty if it may be."""
    if alternative.weight is not None:
        return "" if alternative.weight > 0 else "its weight is 0"
    always = next((earlier for earlier in before if not earlier.condition), None)
    return f"{always.to} before it has no condition" if always else ""
