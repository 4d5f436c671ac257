"""The pictures of docs/faces.md, six expressions each: `python machines/make/face_pictures.py [folder]`.

The folder is docs/pictures, if none is named. Needs the package, no browser.
"""

import sys
from pathlib import Path

import numpy as np
import statwalk
from shapes import Array
from statwalk.character.character import Character
from statwalk.character.role import Role

sys.path.append(str(Path(__file__).resolve().parents[1] / "faq-walker" / "make"))

import film

MACHINES = Path(__file__).resolve().parents[1]

FACES = ("NEUTRAL", "SMILE", "GRIN", "SURPRISE", "FROWN", "ANGER")
TICKS = 30  # from one expression to the next
COLUMNS = 3
FINE = 2
"""each pixel is the mean of so many, squared"""
PICTURES = {
    "faces.png": ("face", film.look(0.35, 0.05), (-0.14, 0.07, 0.28, 0.385), 950.0),
    "car-faces.png": ("car-face", film.look(0.35, 0.1), (-1.3, -0.12, 2.6, 1.95), 110.0),
}
"""file -> machine, view, box (left, bottom, width, height; metres), pixels a metre"""


def colours_of(character: Character, row: int) -> Array:
    """Colours (V, 3) of the vertices of a primitive, as for a screen."""
    part = character.shown_parts[row]
    material = {} if part.material is None else character.materials[part.material]
    factor = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", [1.0] * 4)
    plain = np.tile(np.array(factor)[:3], (len(part.positions), 1))
    own = part.attributes.get("COLOR_0")
    return np.asarray((plain if own is None else plain * own[:, :3]) ** (1 / 2.2), float)


def picture(role: Role, face: str, view: Array, box: tuple[float, ...], scale: float) -> film.Image:
    """One expression (H, W, 3)."""
    character, stage = role.character, statwalk.Stage()
    actor = stage.add(role)
    stage.send(actor, face)
    stage.step(TICKS)
    posed = character.vertices(actor.pose)
    points, normals, faces, colours, start = [], [], [], [], 0
    for row, (part, drawn) in enumerate(zip(posed, character.shown_parts, strict=True)):
        corners = np.asarray(drawn.indices).reshape(-1, 3)
        points.append(part.positions)
        normals.append(part.normals)
        faces.append(corners + start)
        colours.append(colours_of(character, row)[corners].mean(1))
        start += len(part.positions)
    surface = [np.concatenate(column) for column in (points, normals, faces, colours)]
    fine = film.draw(surface[0], surface[1], surface[2], surface[3], view, box, FINE * scale)
    high, wide = fine.shape[0] // FINE, fine.shape[1] // FINE
    cut = fine[: high * FINE, : wide * FINE].reshape(high, FINE, wide, FINE, 3)
    return np.asarray(cut.mean((1, 3)))


def sheet(machine: str, view: Array, box: tuple[float, ...], scale: float) -> film.Image:
    """All expressions, side by side and in rows."""
    role = statwalk.load(MACHINES / machine)
    pictures = [picture(role, face, view, box, scale) for face in FACES]
    rows = [pictures[first : first + COLUMNS] for first in range(0, len(pictures), COLUMNS)]
    return np.concatenate([np.concatenate(row, axis=1) for row in rows])


if __name__ == "__main__":
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else MACHINES.parent / "docs" / "pictures"
    for name, (machine, view, box, scale) in PICTURES.items():
        film.save(folder / name, sheet(machine, view, box, scale))
