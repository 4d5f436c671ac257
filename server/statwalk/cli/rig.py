"""`statwalk rig`: a skeleton and a skin for a mesh."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.progress import Progress, TextColumn, TimeElapsedColumn

from statwalk.character.autorig.wish import Facing, SkeletonKind
from statwalk.errors import ContentError
from statwalk.files.character_file import load_character_file
from statwalk.files.gltf.rigged import rigged
from statwalk.skin.binding.bind_surface import Weighting

EXAMPLES = """Examples:

  statwalk rig statue.glb --skeleton human

  statwalk rig horse.glb -o horse-rigged.glb --skeleton mammal --facing +x

  statwalk rig robot.glb --skeleton own --weights nearest
"""
console = Console(highlight=False)


def rig(
    model: Annotated[Path, typer.Argument(help="A .glb or .gltf model with a mesh.")],
    out: Annotated[
        Path | None, typer.Option("--out", "-o", help="The .glb file to write; by default NAME-rigged.glb.")
    ] = None,
    skeleton: Annotated[
        SkeletonKind,
        typer.Option(help="own: the file's joints; human, mammal: a template; parts: from the mesh alone."),
    ] = "parts",
    weights: Annotated[
        Weighting, typer.Option(help="heat: smooth; nearest: each vertex follows one bone.")
    ] = "heat",
    facing: Annotated[Facing, typer.Option(help="Where the mesh looks, for templates; up is +y.")] = "+z",
) -> None:
    """Writes a model with a skeleton and a skin for its mesh."""
    out = out or model.with_name(f"{model.stem}-rigged.glb")
    if out.suffix.lower() != ".glb":
        raise typer.BadParameter(f"the file to write is a .glb, not {out.name}")
    character = load_character_file(model)
    try:
        with Progress(
            TextColumn("{task.description}"), TimeElapsedColumn(), console=console, transient=True
        ) as bar:
            task = bar.add_task("")
            made = rigged(
                character,
                skeleton,
                weights,
                facing,
                lambda work, share: bar.update(task, description=f"{work} {share:.0%}"),
            )
    except ContentError as error:
        raise error.in_file(str(model)) from None
    out.write_bytes(made.model_glb)
    joints = len(made.skins[0].joints)
    vertices = sum(len(part.positions) for part in made.parts)
    console.print(escape(f"{out}: {joints} joints move {vertices:,} vertices"), soft_wrap=True)
    if made.skeleton.muscle_bones:
        names = ", ".join(sorted(made.skeleton.muscle_bones))
        console.print(escape(f"muscle bones move no vertices now: {names}"), soft_wrap=True)
