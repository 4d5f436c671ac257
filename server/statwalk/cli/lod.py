"""`statwalk lod`: levels of detail of a model."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape
from rich.progress import Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from statwalk.character.character import Character
from statwalk.character.detail.measure_levels import MeasuredLevel, measured_levels
from statwalk.cli.character_source import CharacterSource
from statwalk.errors import ContentError
from statwalk.files.gltf.detailed_model import lod as coarser
from statwalk.files.gltf.detailed_model import with_detail
from statwalk.services.library.load import character_from

EXAMPLES = """Examples:

  statwalk lod fox.glb

  statwalk lod fox.glb --error 0.005 -o fox-far.glb

  statwalk lod fox.glb --share 0.25 -o fox-quarter.glb
"""
console = Console(highlight=False)


def lod(
    model: CharacterSource,
    error: Annotated[
        float | None, typer.Option(help="Write a coarser model, at most so many metres from the full skin.")
    ] = None,
    vertices: Annotated[
        int | None, typer.Option(help="Write a coarser model with at most so many vertices.")
    ] = None,
    share: Annotated[
        float | None, typer.Option(help="Write a coarser model with at most this share of the vertices.")
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", help="The .glb file to write; by default NAME-lod.glb.")
    ] = None,
) -> None:
    """Stores the order in which a model's vertices collapse, or writes a coarser model; prints the levels."""
    out = out or model.with_name(f"{model.stem}-lod.glb")
    if out.suffix.lower() != ".glb":
        raise typer.BadParameter(f"the file to write is a .glb, not {out.name}")
    character = character_from(model)
    is_wished = (error, vertices, share) != (None, None, None)
    try:
        whole = character if is_wished and character.levels else _with_order(character)
        made = coarser(whole, error, vertices=vertices, share=share) if is_wished else whole
    except ContentError as wrong:
        raise wrong.in_file(str(model)) from None
    out.write_bytes(made.model_glb)
    if is_wished:
        text = f"{out}: {_count(made):,} of {_count(character):,} vertices"
    else:
        console.print(_table(measured_levels(whole)))
        text = f"{out}: {len(whole.levels)} levels of detail"
    console.print(escape(text), soft_wrap=True)


def _with_order(character: Character) -> Character:
    with Progress(
        TextColumn("{task.description}"), TimeElapsedColumn(), console=console, transient=True
    ) as bar:
        task = bar.add_task("")
        return with_detail(character, lambda work, share: bar.update(task, description=f"{work} {share:.0%}"))


def _count(character: Character) -> int:
    return sum(len(part.positions) for part in character.parts)


def _table(levels: list[MeasuredLevel]) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0))
    for title in ("level", "vertices", "triangles", "stored, mm", "at rest, mm", "in clips, mm"):
        table.add_column(title, justify="right")
    for row, level in enumerate(levels):
        errors = (f"{1000 * error:.1f}" for error in (level.error, level.at_rest, level.in_clips))
        table.add_row(str(row), f"{level.vertices:,}", f"{level.triangles:,}", *errors)
    return table
