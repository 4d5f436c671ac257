"""Faults of cells: those that never count or never fire, and outcomes that are never chosen."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.machine.authored.celldefinition import Alternative
from statwalk.machine.authored.definition import END
from statwalk.machine.checking.findings import Finding, Severity
from statwalk.machine.checking.firing import why_never
from statwalk.machine.checking.sheet import Sheet


def shadowed(sheet: Sheet) -> Iterator[Finding]:
    """Defaults, of `*` or of an outer state, that never count, since every cell that they are for says something itself."""
    counted = {cell.written for cell in sheet.cells.values()}
    for (row, column), cell in sheet.definition.cells.items():
        if (row, column) not in counted and not (column == END and row in sheet.definition.outers):
            message = f"{row}/{column} never counts: other cells come before it"
            yield Finding("cell never fires", "warning", message, cell.line, row, column)


def never_firing(sheet: Sheet) -> Iterator[Finding]:
    """Cells whose moment never comes in any state that they count for; one that is written for the state itself is an error."""
    reasons: dict[tuple[str, str], list[str]] = {}
    for (state, event), cell in sheet.cells.items():
        if not cell.off:
            reasons.setdefault(cell.written, []).append(why_never(sheet.definition, cell, state, event, sheet.marks))
    for (row, column), several in reasons.items():
        if all(several):
            written, is_own = sheet.definition.cells[row, column], row in sheet.definition.states
            severity: Severity = "error" if is_own and "marker" in several[0] else "warning"
            yield Finding("cell never fires", severity, f"{row}/{column} never fires: {several[0]}", written.line, row, column)


def unchosen(sheet: Sheet) -> Iterator[Finding]:
    """Outcomes after one without a condition, and those of weight 0."""
    for (row, column), cell in sheet.definition.cells.items():
        for number, one in enumerate(cell.alternatives):
            why = why_unchosen(cell.alternatives[:number], one)
            if why:
                yield Finding("outcome never chosen", "warning", f"{row}/{column}: {one.to} is never chosen, {why}", one.line, row, column)


def why_unchosen(before: tuple[Alternative, ...], one: Alternative) -> str:
    """Why an outcome is never chosen; empty where it may be."""
    if one.weight is not None:
        return "" if one.weight > 0 else "its weight is 0"
    always = next((other for other in before if not other.condition), None)
    return f"{always.to} before it has no condition" if always else ""
