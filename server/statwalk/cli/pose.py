"""`statwalk pose`: one pose of a character as numbers, in a file that NumPy reads."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer
from rich.console import Console
from rich.markup import escape

from statwalk.character.character import Character
from statwalk.cli.character_source import CharacterSource
from statwalk.errors import StatwalkError
from statwalk.maths.pose import Pose
from statwalk.services.library.load import character_from

EXAMPLES = """Examples:

  statwalk pose fox.glb --clip Walk --time 0.3 --out pose.npz

  statwalk pose fox.glb --out bind.npz

  python -c "import numpy; print(numpy.load('pose.npz')['world'][0])"
"""
console = Console(highlight=False)
errors = Console(stderr=True, highlight=False)


def _numbers(character: Character, pose: Pose, skinning: str) -> dict[str, Any]:
    """Returns the arrays of the file by name.

    world (J,4,4), local (J,10) as T xyz, R xyzw, S xyz, names (J,), node_index (J,), weights (W,); vertices
    and normals (V,3) of all parts, one after the other; parts (P,5): node, mesh and primitive in the file,
    first vertex, number of vertices.
    """
    parts = character.vertices(pose, skinning)
    counts = [len(part.positions) for part in parts]
    empty = np.zeros((0, 3), np.float32)
    normals = [np.zeros_like(part.positions) if part.normals is None else part.normals for part in parts]
    rows = [(p.node, p.mesh, p.primitive, sum(counts[:k]), counts[k]) for k, p in enumerate(parts)]
    return {
        "world": character.world(pose),
        "local": np.concatenate([pose.translation, pose.rotation, pose.scale], axis=-1),
        "names": np.array(character.skeleton.names),
        "node_index": character.node_index,
        "weights": pose.weights,
        "vertices": np.concatenate([empty, *(part.positions for part in parts)]),
        "normals": np.concatenate([empty, *normals]),
        "parts": np.array(rows, np.int32).reshape(-1, 5),
    }


def pose(
    file: CharacterSource,
    out: Annotated[Path, typer.Option(help="The .npz file to write.")],
    clip: Annotated[str, typer.Option(help="The clip; without one, the pose at rest.")] = "",
    time: Annotated[
        float, typer.Option(help="Seconds from the clip's start; outside the clip its first or last pose.")
    ] = 0.0,
    loop: Annotated[bool, typer.Option("--loop", help="Wrap the time at the clip's end.")] = False,
    skinning: Annotated[
        str, typer.Option(help="linear, dual-quaternion, rigid or parts; by default the character's own.")
    ] = "",
) -> None:
    """Writes one pose of a character: world and local transforms, joint names, vertices and normals."""
    if not np.isfinite(time):
        raise typer.BadParameter(f"--time is {time}; it must be a finite number of seconds")
    if out.is_dir():
        raise typer.BadParameter(f"--out is the folder {out}; it must be a file")
    out_file = out if out.suffix == ".npz" else out.with_name(f"{out.name}.npz")
    try:
        character = character_from(file)
        sampled = character.clip(clip).sample(time, loop=loop) if clip else character.bind_pose
        arrays = _numbers(character, sampled, skinning)
        np.savez(out_file, **arrays)
    except (StatwalkError, OSError) as error:
        errors.print(f"[bold red]statwalk pose:[/] {escape(str(error))}", soft_wrap=True)
        raise typer.Exit(2) from None
    shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
    console.print(escape(f"{out_file}: {shapes}"), soft_wrap=True)
