"""`statwalk restore`: a data folder from a backup."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.services.hosting.store.backup import bring_back
from statwalk.web.settings import data_folder

EXAMPLES = """Examples:

  statwalk restore monday.zip --data /srv/statwalk
"""
console = Console(highlight=False)


def restore(
    source: Annotated[Path, typer.Argument(help="A file that `statwalk backup` wrote.")],
    data: Annotated[
        Path | None,
        typer.Option(
            help="A folder that holds no data yet; by default your data folder.", show_default=False
        ),
    ] = None,
) -> None:
    """Unpacks a backup into an empty data folder; `statwalk doctor` says whether it is whole."""
    folder = data or data_folder()
    paths = bring_back(source, folder)
    console.print(escape(f"{folder}: {len(paths)} files"), soft_wrap=True)
