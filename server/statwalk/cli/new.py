"""`statwalk new`: a machine folder from a model, ready to serve."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.files.character_file import load_character_file
from statwalk.files.machine_yaml.new_machine import motions_of, write_machine
from statwalk.files.without_meshes import without_meshes

EXAMPLES = """Examples:

  statwalk new robot.glb

  statwalk new robot.glb machines/robot --no-copy

  statwalk new knight.glb --without 1H_Sword --without 2H_Sword

  statwalk serve robot
"""
console = Console(highlight=False)


def new(
    model: Annotated[Path, typer.Argument(help="A model with animations: .glb, .gltf, .md2 or .x.")],
    folder: Annotated[
        Path | None,
        typer.Argument(help="The folder to write; by default, ./ and the model's name without its suffix."),
    ] = None,
    copy: Annotated[
        bool, typer.Option(help="Copy the model into the folder; otherwise machine.yaml names its path.")
    ] = True,
    without: Annotated[
        list[str] | None, typer.Option(help="A mesh to leave out, by its name; several times for several.")
    ] = None,
) -> None:
    """Writes a machine folder for a model: a state for each clip, a complete table, an event on a key for
    each state.
    """
    if without and not copy:
        raise typer.BadParameter("--without changes the copy of the model; with --no-copy there is none")
    character = without_meshes(load_character_file(model), without or ())
    written_folder = escape(str(write_machine(character, model, folder or Path(model.stem), copy)))
    motions = motions_of(character)
    console.print(
        f"[bold]{written_folder}[/]: {len(motions)} states; it begins in {escape(motions[0].state)}"
    )
    console.print(f"Now run: statwalk serve {written_folder}")
