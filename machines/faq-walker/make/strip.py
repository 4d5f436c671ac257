"""Film strips of a motion from three sides: `python machines/faq-walker/make/strip.py walk strip.png [pictures]`."""

import sys
from pathlib import Path

import film
import numpy as np
from curves import Array
from mesh.body import MATERIALS, Body, inverse_bind, make_body
from moves.motion import Motion
from moves.motions import MOTIONS
from numpy.typing import NDArray
from skeleton import PARENT, rest_translation
from statwalk.maths import quat

SCALE = 120.0  # pixels a metre


def world_matrices(rotation: Array, root: Array) -> Array:
    """World matrices (J, 3, 4) of one pose."""
    place = rest_translation()
    place[0] = root
    turn = quat.to_matrix(rotation)
    for joint, parent in enumerate(PARENT):
        if parent >= 0:
            place[joint] = place[parent] + turn[parent] @ place[joint]
            turn[joint] = turn[parent] @ turn[joint]
    return np.concatenate([turn, place[:, :, None]], axis=2)


def skinned(body: Body, matrices: Array) -> tuple[Array, Array]:
    """Points and normals (V, 3) of a posed body."""
    joint = matrices @ inverse_bind()
    blend = (joint[body.joints] * body.weights[..., None, None]).sum(1)
    normals = np.einsum("vab,vb->va", blend[:, :, :3], body.normals)
    points = np.einsum("vab,vb->va", blend[:, :, :3], body.points) + blend[:, :, 3]
    return points, normals / np.linalg.norm(normals, axis=1, keepdims=True)


def surface_of(body: Body) -> tuple[NDArray[np.int64], Array]:
    """All triangles (T, 3) and their colours (T, 3) as for a screen."""
    colours = [np.tile(np.array(MATERIALS[name][0]) ** (1 / 2.2), (len(faces), 1)) for name, faces in body.parts.items()]
    return np.concatenate(list(body.parts.values())), np.concatenate(colours)


def strip(body: Body, motion: Motion, times: Array, view: str, follow: bool = True) -> film.Image:
    """Pictures side by side, one per time; `follow` keeps the root in the middle of each."""
    faces, colours = surface_of(body)
    rotation, root = motion.at(times)
    pictures = []
    for turn, place in zip(rotation, root, strict=True):
        points, normals = skinned(body, world_matrices(turn, place))
        if follow:
            points = points - place * (1, 0, 1)
        tall = view != "above"
        box = (-0.62, -0.06, 1.24, 2.2 if motion.name in ("jump", "fly", "land") else 1.90) if tall else (-0.62, -0.5, 1.24, 1.0)
        pictures.append(film.draw(points, normals, faces, colours, film.VIEWS[view], box, SCALE))
    return np.concatenate(pictures, axis=1)


def sheet(body: Body, motion: Motion, count: int = 11, views: tuple[str, ...] = ("side", "front", "above")) -> film.Image:
    """Strips of a whole motion, one under the other."""
    times = np.linspace(0, motion.duration, count)
    return np.concatenate([strip(body, motion, times, view) for view in views])


if __name__ == "__main__":
    chosen = next(motion for motion in MOTIONS if motion.name == sys.argv[1])
    film.save(Path(sys.argv[2]), sheet(make_body(), chosen, int(sys.argv[3]) if len(sys.argv) > 3 else 11))
