"""`statwalk replay`: plays a log again, and says whether it leads to the same state."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.character.role import Role
from statwalk.errors import ContentError
from statwalk.services.library.catalogue import Catalogue
from statwalk.stage.replay import replay as replayed

EXAMPLES = """Examples:

  curl http://127.0.0.1:8000/api/stages/main/log > walk.jsonl
  statwalk replay walk.jsonl

  statwalk replay walk.jsonl --machine machines/my-walker --until 120
"""
console = Console(highlight=False)


def replay(
    log: Annotated[Path, typer.Argument(help="The log, JSON lines as GET …/log gives them.")],
    machine: Annotated[
        list[Path] | None,
        typer.Option(
            help="The folder of a machine or scene that the log names; repeat it.", show_default=False
        ),
    ] = None,
    until: Annotated[
        int | None, typer.Option(help="The last tick; by default the log's.", min=0, show_default=False)
    ] = None,
) -> None:
    """Plays a log again; refuses one of another engine, or one that leads to another state than it did."""
    if not log.is_file():
        raise ContentError("there is no such file", file=str(log))
    catalogue = Catalogue(machine or ())

    def role(key: str, text: str = "") -> Role:
        name = key.partition("@")[0]
        return catalogue.version(name, text) if text else catalogue.role(name)

    stage = replayed(log, role, until)
    actors = f"{len(stage.actors)} actor{'s' * (len(stage.actors) != 1)}"
    console.print(escape(f"after {stage.tick} ticks, {actors}: hash {stage.hash}"), soft_wrap=True)
