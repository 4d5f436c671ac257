"""Film strips from three sides: `python machines/faq-walker/make/strip.py walk walk.png [pictures]`, or
`jump-left-1+fly+land` in a row.
"""

import sys
from pathlib import Path

import film
import numpy as np
from curves import Array
from mesh.body import Body, inverse_bind, make_body, more_translation
from moves.motion import Motion
from moves.motions import MOTIONS
from numpy.typing import NDArray
from skeleton import MORE, NAMES, PARENT, rest_translation
from statwalk.maths import quat

SCALE = 100.0  # pixels a metre
TALL = ("jump", "fly", "land", "absorb", "rise", "crouch", "stand")  # need room overhead


def world_matrices(body: Body, rotation: Array, root: Array) -> Array:
    """World matrices (J, 3, 4) of one pose; the joints beyond the FAQ's are at rest."""
    place = rest_translation()
    place[0] = root
    turn = quat.to_matrix(rotation)
    for joint, parent in enumerate(PARENT):
        if parent >= 0:
            place[joint] = place[parent] + turn[parent] @ place[joint]
            turn[joint] = turn[parent] @ turn[joint]
    parents = [NAMES.index(parent) for parent in MORE.values()]
    at = place[parents] + np.einsum("jab,jb->ja", turn[parents], more_translation(body.places))
    turn, place = np.concatenate([turn, turn[parents]]), np.concatenate([place, at])
    return np.concatenate([turn, place[:, :, None]], axis=2)


def skinned(body: Body, matrices: Array) -> tuple[Array, Array]:
    """Points and normals (V, 3) of a posed body."""
    joint = matrices @ inverse_bind(body.places)
    blend = (joint[body.joints] * body.weights[..., None, None]).sum(1)
    normals = np.einsum("vab,vb->va", blend[:, :, :3], body.normals)
    points = np.einsum("vab,vb->va", blend[:, :, :3], body.points) + blend[:, :, 3]
    return points, normals / np.linalg.norm(normals, axis=1, keepdims=True)


def surface_of(body: Body) -> tuple[NDArray[np.int64], Array]:
    """All triangles (T, 3) and their colours (T, 3) as for a screen."""
    faces = np.concatenate(list(body.parts.values()))
    return faces, body.colours[faces].mean(1) ** (1 / 2.2)


def strip(body: Body, motion: Motion, times: Array, view: str) -> film.Image:
    """Pictures side by side, one per time, each with the root in the middle."""
    faces, colours = surface_of(body)
    rotation, root = motion.at(times)
    pictures = []
    for turn, place in zip(rotation, root, strict=True):
        points, normals = skinned(body, world_matrices(body, turn, place))
        height = 2.3 if motion.name.split("-")[0] in TALL else 1.90
        box = (-0.62, -0.5, 1.24, 1.0) if view == "above" else (-0.62, -0.06, 1.24, height)
        pictures.append(
            film.draw(points - place * (1, 0, 1), normals, faces, colours, film.VIEWS[view], box, SCALE)
        )
    return np.concatenate(pictures, axis=1)


def sheet(
    body: Body, motions: list[Motion], count: int = 11, views: tuple[str, ...] = ("side", "front", "above")
) -> film.Image:
    """Strips of motions that follow each other, evenly in time, one view under the other."""
    whole = sum(motion.duration for motion in motions)
    times = [
        (m, np.linspace(0, m.duration, max(2, round(count * m.duration / whole)), endpoint=m is motions[-1]))
        for m in motions
    ]
    return np.concatenate(
        [np.concatenate([strip(body, m, t, view) for m, t in times], axis=1) for view in views]
    )


if __name__ == "__main__":
    chosen = [next(motion for motion in MOTIONS if motion.name == name) for name in sys.argv[1].split("+")]
    film.save(Path(sys.argv[2]), sheet(make_body(), chosen, int(sys.argv[3]) if len(sys.argv) > 3 else 11))
