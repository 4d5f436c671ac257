"""`statwalk new`: a machine folder from a model, ready to serve."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.files.newmachine import motions_of, write_machine
from statwalk.loading import load_character_file

EXAMPLES = """Examples:

  statwalk new robot.glb

  statwalk new robot.glb machines/robot --no-copy

  statwalk serve robot
"""
console = Console(highlight=False)


def new(
    model: Annotated[Path, typer.Argument(help="A .glb or .gltf model with animations.")],
    folder: Annotated[Path | None, typer.Argument(help="The folder to write; by default, one with the model's name, here.")] = None,
    copy: Annotated[bool, typer.Option(help="Copy the model into the folder; otherwise name its path.")] = True,
) -> None:
    """Writes a machine folder for a model: a state for each clip, a complete table, an event on a key for each state."""
    character = load_character_file(model)
    made = write_machine(character, model, folder or Path(model.stem), copy)
    motions = motions_of(character)
    console.print(f"[bold]{escape(str(made))}[/]: {len(motions)} states, standing about in {escape(motions[0].state)}")
    console.print(f"Now: statwalk serve {escape(str(made))}")
