"""`statwalk doctor`: what a data folder holds, and what is damaged."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.services.hosting.store.examine import examine
from statwalk.web.settings import data_folder

EXAMPLES = """Examples:

  statwalk doctor

  statwalk doctor --data /srv/statwalk
"""
console = Console(highlight=False)


def doctor(
    data: Annotated[
        Path | None, typer.Option(help="The data folder; by default yours.", show_default=False)
    ] = None,
) -> None:
    """Examines a data folder, also while a server uses it; ends with status 1 if something is damaged."""
    folder, damaged = data or data_folder(), 0
    for part, facts, damage in examine(folder):
        damaged += bool(damage)
        mark = f"[bold red]damaged[/]: {escape(damage)}" if damage else "[green]whole[/]"
        console.print(f"{escape(part)}: {escape(facts)} {mark}".replace(":  ", ": "), soft_wrap=True)
    console.print(
        escape(f"{folder}: " + (f"{damaged} damaged" if damaged else "nothing is damaged")), soft_wrap=True
    )
    if damaged:
        raise typer.Exit(1)
