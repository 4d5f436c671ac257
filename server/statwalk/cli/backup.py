"""`statwalk backup`: a data folder as one file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.services.hosting.store.backup import back_up
from statwalk.web.settings import data_folder

EXAMPLES = """Examples:

  statwalk backup monday.zip

  statwalk backup monday.zip --data /srv/statwalk
"""
console = Console(highlight=False)


def backup(
    target: Annotated[Path, typer.Argument(help="The .zip file to write.")],
    data: Annotated[
        Path | None, typer.Option(help="The data folder; by default yours.", show_default=False)
    ] = None,
) -> None:
    """Writes stages, machines and characters to one file, also while a server uses them."""
    paths = back_up(data or data_folder(), target)
    console.print(escape(f"{target}: {len(paths)} files, {target.stat().st_size:,} bytes"), soft_wrap=True)
