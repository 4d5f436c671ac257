"""`statwalk verify`: what is wrong with a machine's table, and what was proved of it."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import orjson
import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from statwalk.errors import UnknownNameError
from statwalk.files.machinefile import load_machine
from statwalk.loading import character_path, load_character_file, machine_folders
from statwalk.machine.built.build import MotionFacts
from statwalk.machine.checking.findings import Finding
from statwalk.machine.checking.verify import verify as find

EXAMPLES = """Examples:

  statwalk verify faq-printed

  statwalk verify my-robot --json

The exit status is 0 where there is no error, 1 where there is one, 2 where the files cannot be read.
"""
COLOURS = {"error": "bold red", "warning": "yellow", "info": "green"}
console = Console(highlight=False)


def folder_of(machine: str) -> Path:
    """The folder of a machine; raises UnknownNameError where there is none."""
    if Path(machine).is_dir():
        return Path(machine)
    known = machine_folders()
    if machine not in known:
        raise UnknownNameError("machine folder or shipped machine", machine, sorted(known))
    return known[machine]


def findings_of(folder: Path) -> list[Finding]:
    """All findings about the machine of a folder, with the motions of its character; raises ContentError where a file cannot be read."""
    file = load_machine(folder)
    character = load_character_file(character_path(file))
    file.check_root(character.skeleton.names)
    return find(file.definition, {name: MotionFacts(clip.duration, clip.loop, clip.markers) for name, clip in character.clips.items()})


def shown(findings: list[Finding]) -> Table:
    """The findings as a table."""
    table = Table("", "line", "kind", "finding", box=None, pad_edge=False)
    for one in findings:
        table.add_row(f"[{COLOURS[one.severity]}]{one.severity}[/]", str(one.line or ""), one.kind, escape(one.message))
    return table


def verify(
    machine: Annotated[str, typer.Argument(help="A machine folder, or the name of a shipped machine.")],
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON, for programs.")] = False,
) -> None:
    """Finds what is wrong with a machine's table, without running it, and proves its properties."""
    findings = findings_of(folder_of(machine))
    errors = sum(one.severity == "error" for one in findings)
    warnings = sum(one.severity == "warning" for one in findings)
    if as_json:
        typer.echo(orjson.dumps({"machine": machine, "findings": [asdict(one) for one in findings]}, option=orjson.OPT_INDENT_2))
    else:
        if findings:
            console.print(shown(findings))
        console.print(f"{escape(machine)}: {errors} errors, {warnings} warnings")
    if errors:
        raise typer.Exit(1)
