"""`statwalk convert`: a character or a capture in another format; a capture also carried over to another
character.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.markup import escape

from statwalk.character.capture import CaptureWish, with_capture
from statwalk.character.character import Character
from statwalk.character.retarget import Retargeted, Wish
from statwalk.errors import ContentError
from statwalk.files.bvh.bvh_file import Position
from statwalk.files.captures import SUFFIXES, Reading, load_capture
from statwalk.files.gltf.add_clip import model_with_clip
from statwalk.files.model_formats import WRITTEN
from statwalk.files.without_meshes import without_meshes
from statwalk.motion.filter_clip import Filter
from statwalk.services.library.convert import convert as write_as
from statwalk.services.library.load import character_from

EXAMPLES = """Examples:

  statwalk convert fox.glb fox.bvh --clip Walk

  statwalk convert walk.bvh walk.glb --scale 0.0564

  statwalk convert walk.bvh robot-walks.glb --onto robot.glb --low-pass 6 --spikes

  statwalk convert knight.glb knight.x --without 1H_Sword --without 2H_Sword

  statwalk convert walk.trc hero-walks.glb --onto hero.glb --bone Hips=pelvis --start 1 --end 2.2
"""
console = Console(highlight=False)


def _read(source: Path, how: Reading) -> Character:
    return load_capture(source, how) if source.suffix.lower() in SUFFIXES else character_from(source)


def _write(character: Character, out: Path, clip: str) -> None:
    console.print(escape(str(write_as(character, out, clip=clip))), soft_wrap=True)


def _bones(pairs: list[str]) -> dict[str, str]:
    """Returns bone -> joint of options like Hips=pelvis."""
    for pair in pairs:
        if "=" not in pair:
            raise typer.BadParameter(f"{pair!r} should read BONE=JOINT, as in Hips=pelvis")
    return dict(pair.split("=", 1) for pair in pairs)


def _tell(report: Retargeted) -> None:
    for title, names in (
        ("joints without a counterpart", report.unmapped_source),
        ("joints that rest", report.unmapped_target),
        ("bones that are missing", report.missing),
        ("note", report.notes),
    ):
        if names:
            console.print(escape(f"{title}: {', '.join(names)}"), soft_wrap=True)


def convert(
    source: Annotated[
        Path, typer.Argument(help="A model, a capture (.bvh, .trc), or any character that statwalk reads.")
    ],
    out: Annotated[Path, typer.Argument(help=f"The file to write: {', '.join(WRITTEN)}.")],
    onto: Annotated[
        Path | None,
        typer.Option(help="The character that gets the clip; without one, the source itself is written."),
    ] = None,
    clip: Annotated[str, typer.Option(help="The source's clip; by default its first.")] = "",
    name: Annotated[str, typer.Option(help="The new clip's name; by default the clip's own.")] = "",
    position: Annotated[
        Position, typer.Option(help="BVH position channels replace the offset, or add to it.")
    ] = "replace",
    scale: Annotated[float, typer.Option(help="Multiplies the capture's lengths.")] = 1.0,
    low_pass: Annotated[
        float, typer.Option(help="Hz: what moves faster is taken out, without a delay.")
    ] = 0.0,
    spikes: Annotated[bool, typer.Option("--spikes", help="Replace single wild samples.")] = False,
    start: Annotated[float, typer.Option(help="Seconds: the piece to carry over begins here.")] = 0.0,
    end: Annotated[float | None, typer.Option(help="Seconds: the piece ends here.")] = None,
    bone: Annotated[
        list[str] | None, typer.Option(help="BONE=JOINT of the source, where names do not tell.")
    ] = None,
    target_bone: Annotated[list[str] | None, typer.Option(help="BONE=JOINT of --onto.")] = None,
    without: Annotated[
        list[str] | None,
        typer.Option(help="A mesh to leave out of what is written, by its name; several times for several."),
    ] = None,
) -> None:
    """Writes a character in another format, and says what that cannot hold; a capture also carried over to
    another character.
    """
    if out.suffix.lower() not in WRITTEN:
        raise typer.BadParameter(f"the file to write is one of {', '.join(WRITTEN)}, not {out.name}")
    wanted = Filter(low_pass, spikes)
    how = Reading(position, scale, wanted if onto is None else Filter())
    if how != Reading() and source.suffix.lower() not in SUFFIXES:
        raise typer.BadParameter("position, scale, and filters without --onto are for captures (.bvh, .trc)")
    if onto is None:
        _write(without_meshes(_read(source, how), without or ()), out, clip)
        return
    target = without_meshes(_read(onto, Reading()), without or ())
    if not target.model_glb:
        raise ContentError("this character has no model to write", file=str(onto))
    carried = Wish(_bones(bone or []), _bones(target_bone or []), start, end)
    wish = CaptureWish(clip, name, carried, wanted)
    character, added, report = with_capture(target, _read(source, how), wish)
    _write(replace(character, model_glb=model_with_clip(character, character.clips[added])), out, added)
    console.print(escape(f"the clip {added}: {len(report.bones)} bones carried over"), soft_wrap=True)
    _tell(report)
