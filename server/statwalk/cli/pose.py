"""`statwalk pose`: one pose of a character as numbers, in a file that NumPy reads."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer
from rich.console import Console
from rich.markup import escape

from statwalk.character import Character
from statwalk.errors import StatwalkError
from statwalk.loading import load
from statwalk.maths.pose import Pose

EXAMPLES = """Examples:

  statwalk pose fox.glb --clip Walk --time 0.3 --out pose.npz

  statwalk pose fox.glb --out bind.npz

  python -c "import numpy; print(numpy.load('pose.npz')['world'][0])"
"""
console = Console(highlight=False)
errors = Console(stderr=True, highlight=False)


def numbers(character: Character, pose: Pose) -> dict[str, Any]:
    """What is written: arrays by name.

    world (J,4,4), local (J,10) as T xyz, R xyzw, S xyz, names (J,), node_index (J,), weights (W,); vertices and normals (V,3) of all
    parts, one after the other; parts (P,5): node, mesh and primitive in the file, first vertex, number of vertices.
    """
    posed = character.vertices(pose)
    counts = [len(part.positions) for part in posed]
    none = np.zeros((0, 3), np.float32)
    normals = [np.zeros_like(part.positions) if part.normals is None else part.normals for part in posed]
    rows = [(p.node, p.mesh, p.primitive, sum(counts[:k]), counts[k]) for k, p in enumerate(posed)]
    return {
        "world": character.world(pose),
        "local": np.concatenate([pose.translation, pose.rotation, pose.scale], axis=-1),
        "names": np.array(character.skeleton.names),
        "node_index": character.node_index,
        "weights": pose.weights,
        "vertices": np.concatenate([none, *(part.positions for part in posed)]),
        "normals": np.concatenate([none, *normals]),
        "parts": np.array(rows, np.int32).reshape(-1, 5),
    }


def character_of(source: Path) -> Character:
    """The character in a file, or the one that a machine plays."""
    found = load(source)
    return found if isinstance(found, Character) else found.character


def pose(
    file: Annotated[Path, typer.Argument(help="A model or character file, a folder with a model or a machine, or a shipped machine.")],
    out: Annotated[Path, typer.Option(help="The .npz file to write.")],
    clip: Annotated[str, typer.Option(help="The clip; without it, the pose at rest.")] = "",
    time: Annotated[float, typer.Option(help="Seconds from the clip's start; before and after it the ends hold.")] = 0.0,
    loop: Annotated[bool, typer.Option("--loop", help="Time wraps at the clip's end.")] = False,
) -> None:
    """Writes one pose of a character: world and local transforms, joint names, vertices and normals."""
    if not np.isfinite(time):
        raise typer.BadParameter(f"--time is {time}; it must be a finite number of seconds")
    if out.is_dir():
        raise typer.BadParameter(f"--out is the folder {out}; it must be a file")
    written = out if out.suffix == ".npz" else out.with_name(f"{out.name}.npz")
    try:
        character = character_of(file)
        sampled = character.clip(clip).sample(time, loop=loop) if clip else character.bind_pose
        found = numbers(character, sampled)
        np.savez(written, **found)
    except (StatwalkError, OSError) as error:
        errors.print(f"[bold red]statwalk pose:[/] {escape(str(error))}", soft_wrap=True)
        raise typer.Exit(2) from None
    shapes = ", ".join(f"{name} {array.shape}" for name, array in found.items())
    console.print(escape(f"{written}: {shapes}"), soft_wrap=True)
