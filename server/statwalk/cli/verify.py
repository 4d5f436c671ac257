"""`statwalk verify`: what is wrong with a machine's table, and what is proved about it."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import orjson
import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from statwalk.character.made_clips import with_clips
from statwalk.character.role import Role, facts_of
from statwalk.cli.counted import counted
from statwalk.errors import MachineError, UnknownNameError
from statwalk.files.character_file import load_character_file
from statwalk.files.machine_yaml.machine_file import load_machine
from statwalk.machine.lint.findings import Finding
from statwalk.machine.verify import verify as find
from statwalk.services.library.load import character_path, machine_folders
from statwalk.stage.verified import verified

EXAMPLES = """Examples:

  statwalk verify faq-printed

  statwalk verify my-robot --json

The exit status is 0 without errors, 1 with errors in the table, 2 if a file cannot be read or does not fit
its character.
"""
COLOURS = {"error": "bold red", "warning": "yellow", "info": "green"}
console = Console(highlight=False)


def _folder_of(machine: str) -> Path:
    if Path(machine).is_dir():
        return Path(machine)
    shipped_folders = machine_folders()
    if machine not in shipped_folders:
        raise UnknownNameError("machine folder or shipped machine", machine, sorted(shipped_folders))
    return shipped_folders[machine]


def _findings_of(folder: Path) -> list[Finding]:
    """Returns all findings about the machine in a folder, checked against the motions of its character.

    :raises ContentError: when a file cannot be read, or names what the character does not have.
    """
    file = load_machine(folder)
    character = load_character_file(character_path(file))
    file.check_root(character.skeleton.names)
    try:
        role = Role.build(folder.name, character, file.definition, file.root_joint)
    except MachineError:
        whole = with_clips(character, file.definition.clips, file.definition.refuse)
        found = find(file.definition, facts_of(whole))
        if not any(finding.severity == "error" for finding in found):
            raise  # the table is right; another part of the file names what the character does not have
        return found
    return list(verified(role))


def shown(findings: list[Finding]) -> Table:
    """Returns the findings as a table to print."""
    table = Table("", "line", "kind", "finding", box=None, pad_edge=False)
    for finding in findings:
        severity = f"[{COLOURS[finding.severity]}]{finding.severity}[/]"
        table.add_row(severity, str(finding.line or ""), finding.kind, escape(finding.message))
    return table


def verify(
    machine: Annotated[str, typer.Argument(help="A machine folder, or the name of a shipped machine.")],
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON, for programs.")] = False,
) -> None:
    """Finds what is wrong with a machine's table, without running it, and proves its properties."""
    findings = _findings_of(_folder_of(machine))
    errors = sum(finding.severity == "error" for finding in findings)
    warnings = sum(finding.severity == "warning" for finding in findings)
    if as_json:
        typer.echo(
            orjson.dumps(
                {"machine": machine, "findings": [asdict(finding) for finding in findings]},
                option=orjson.OPT_INDENT_2,
            )
        )
    else:
        if findings:
            console.print(shown(findings))
        console.print(f"{escape(machine)}: {counted(errors, 'error')}, {counted(warnings, 'warning')}")
    if errors:
        raise typer.Exit(1)
