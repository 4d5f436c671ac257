"""`statwalk draw`: a skeleton as SVG, one stick figure or a film strip."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.cli.character_source import CharacterSource
from statwalk.files.film_strip import film_strip
from statwalk.files.skeleton_svg import Side
from statwalk.services.library.load import character_from

EXAMPLES = """Examples:

  statwalk draw faq-walker walk.svg --clip walk --frames 8

  statwalk draw fox.glb fox.svg --side left

  statwalk draw fox.glb run.svg --clip Run --time 0.1 --time 0.4 --side front
"""
console = Console(highlight=False)


def draw(
    source: CharacterSource,
    out: Annotated[Path, typer.Argument(help="The .svg file to write.")],
    clip: Annotated[str, typer.Option(help="The clip; without one, the pose at rest.")] = "",
    time: Annotated[
        list[float] | None, typer.Option(help="Seconds from the clip's start; repeat it.")
    ] = None,
    frames: Annotated[
        int, typer.Option(min=0, help="A strip of so many pictures, from the clip's start to its end.")
    ] = 0,
    side: Annotated[Side, typer.Option(help="The side of the character that you see.")] = "right",
) -> None:
    """Draws a skeleton as SVG: lines and circles, one picture or a film strip."""
    if out.suffix.lower() != ".svg":
        raise typer.BadParameter(f"the file to write is an .svg, not {out.name}")
    character = character_from(source)
    out.write_text(film_strip(character, clip, time or (), frames, side), encoding="utf-8")
    console.print(escape(f"{out}: {character.name}, seen from the {side}"), soft_wrap=True)
