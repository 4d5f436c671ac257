"""`statwalk measure`: what a table's transitions look like in numbers: slides, sinks, jumps, response."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from math import isfinite
from typing import Annotated, Any

import orjson
import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from statwalk.character.role import Role
from statwalk.cli.counted import counted
from statwalk.errors import UnknownNameError
from statwalk.services.library.load import load, shipped_machines
from statwalk.services.library.measuring import measured
from statwalk.stage.measure.figures import UNITS, Figure, number, unit
from statwalk.stage.measure.measure import Measured
from statwalk.stage.measure.over_budget import over_budget

EXAMPLES = """Examples:

  statwalk measure faq-walker

  statwalk measure faq-walker --cell WALK/STOP

  statwalk measure machines/my-robot --json

Each cell of the table is played from ten phases of the old motion, and again with another event 1, 5 and 11
ticks later. A figure is the mean over the phases and, in brackets, the worst of all; a narrow terminal shows
the worst alone. The exit status is 0 within the budgets of the machine file, 1 over them, 2 if a file cannot
be read.
"""
WIDEST = 500
"""characters"""


def _role_of(machine: str) -> Role:
    loaded = load(machine)
    if isinstance(loaded, Role):
        return loaded
    raise UnknownNameError("machine", machine, shipped_machines())


def _fitting(console: Console, rows: Sequence[Measured], budgets: Mapping[str, Any]) -> Table:
    """The figures as a table that fits the terminal."""
    table = _shown(rows, budgets, with_means=True)
    fits = console.measure(table, options=console.options.update(width=WIDEST)).maximum <= console.width
    return table if fits else _shown(rows, budgets, with_means=False)


def _shown(rows: Sequence[Measured], budgets: Mapping[str, Any], *, with_means: bool) -> Table:
    """The figures as a table; over budget in red."""
    headings = (f"{name}\n{unit(name)}" for name in UNITS)
    table = Table("", *headings, box=None, pad_edge=False, padding=(0, 1, 0, 0))
    table.columns[0].no_wrap = True
    for part in rows:
        figures = (part.figures.get(name) for name in UNITS)
        table.add_row(
            escape(part.name),
            *(_cell(*pair, budgets, with_mean=with_means) for pair in zip(UNITS, figures, strict=True)),
        )
    return table


def _cell(name: str, figure: Figure | None, budgets: Mapping[str, Any], *, with_mean: bool) -> str:
    if figure is None:
        return ""
    text = number(name, figure.worst)
    text = f"{number(name, figure.mean)} ({text})" if with_mean else text
    return f"[red]{text}[/]" if name in budgets and figure.worst > budgets[name].most else text


def _plain(part: Measured) -> dict[str, Any]:
    """A row as JSON values; a figure that never comes is null."""
    row = asdict(part)
    row["figures"] = {
        name: {key: _finite(value) for key, value in figure._asdict().items()}
        | {"place": figure.place.plain()}
        for name, figure in part.figures.items()
    }
    return row


def _finite(value: Any) -> Any:
    return None if isinstance(value, float) and not isfinite(value) else value


def measure(
    machine: Annotated[str, typer.Argument(help="A machine folder, or the name of a shipped machine.")],
    cell: Annotated[
        str, typer.Option(help="One cell, STATE/EVENT; default: all cells, and all motions.")
    ] = "",
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON, for programs.")] = False,
) -> None:
    """Plays every transition of a machine, and measures what feet, knees, hands and joints do."""
    role = _role_of(machine)
    rows, budgets = measured(role, cell), role.definition.budgets
    findings = list(over_budget(role.definition, rows))
    if as_json:
        answer = {
            "machine": machine,
            "units": dict(UNITS),
            "budgets": {name: budget.most for name, budget in budgets.items()},
            "measured": [_plain(row) for row in rows],
            "findings": [asdict(finding) for finding in findings],
        }
        typer.echo(orjson.dumps(answer, option=orjson.OPT_INDENT_2))
    else:
        console = Console(highlight=False)
        console.print(_fitting(console, rows, budgets), soft_wrap=True)
        for finding in findings:
            console.print(f"[yellow]{finding.severity}[/] line {finding.line}: {escape(finding.message)}")
        over = counted(len(findings), "figure")
        console.print(f"{escape(machine)}: {counted(len(rows), 'row')}, {over} over budget")
    if findings:
        raise typer.Exit(1)
