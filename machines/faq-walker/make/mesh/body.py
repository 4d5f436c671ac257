"""The body: all its patches as one mesh with normals, weights, colours and materials, in its binding pose."""

from dataclasses import dataclass

import numpy as np
from curves import Array
from mesh.build import WALKER, Build
from mesh.collar import make_collar
from mesh.eyes import make_eyes
from mesh.face import EYE_AT, JAW_AT, Face
from mesh.figure import ARM_SPREAD, LEG_SPREAD, Figure
from mesh.hair import make_hair
from mesh.hands import FINGERS, knuckle, make_arm
from mesh.head import make_head
from mesh.patches import Patch, both_sides
from mesh.shirt import make_shirt
from mesh.shoes import make_shoe
from mesh.surface import Indices, edges_of
from mesh.trousers import make_trousers
from mesh.weights import soft_weights, strongest
from numpy.typing import NDArray
from skeleton import MORE, NAMES, PARENT, SIDES, rest_translation

# material: its paints, roughness
MATERIALS: dict[str, tuple[tuple[str, ...], float]] = {
    "skin": (("skin", "lips", "lids", "lash", "mouth"), 0.70),
    "cloth": (
        ("shirt", "stripe", "band", "trousers", "seam", "belt", "shoes", "trim", "laces", "sock"),
        0.85,
    ),
    "soles": (("soles",), 0.80),
    "hair": (("hair", "brow"), 0.60),
    "eyes": (("white", "iris", "rim", "pupil", "glint", "buckle"), 0.25),
}
JOINTS = [*NAMES, *MORE]


@dataclass(frozen=True)
class Body:
    """Points, normals (V, 3), joints, weights (V, 4), linear colours (V, 3) and one list of triangles (T, 3)
    per material; `places` (J, 3) of the joints in the binding pose.
    """

    points: Array
    normals: Array
    joints: NDArray[np.uint8]
    weights: NDArray[np.float32]
    colours: Array
    parts: dict[str, Indices]
    places: Array


def linear(colour: str) -> Array:
    """Red, green, blue as light, of a colour as on a screen, #rrggbb."""
    screen = np.array([int(colour[at : at + 2], 16) for at in (1, 3, 5)]) / 255
    return np.asarray(np.where(screen > 0.04045, ((screen + 0.055) / 1.055) ** 2.4, screen / 12.92))


def make_body(build: Build = WALKER) -> Body:
    """A build, dressed."""
    figure, face = Figure(build), Face(build)
    patches = [
        make_shirt(figure),
        *make_trousers(figure),
        make_collar(figure),
        make_head(face),
        *make_eyes(face),
    ]
    patches += make_hair(face)
    for patch in (make_arm(figure), *make_shoe(figure)):
        patches += both_sides(patch)
    pieces: list[tuple[Array, ...]] = []
    parts: dict[str, list[Indices]] = {name: [] for name in MATERIALS}
    start = 0
    for patch in patches:
        weights, normals = _weights(patch), patch.normals()
        for paint, faces in patch.faces.items():
            used, index = np.unique(faces, return_inverse=True)
            colour = np.tile(linear(build.colours[paint]), (len(used), 1))
            pieces.append((patch.points[used], normals[used], weights[used], colour))
            material = next(name for name, (paints, _) in MATERIALS.items() if paint in paints)
            parts[material].append(start + index.reshape(-1, 3))
            start += len(used)
    points, normals, weights, colours = (np.concatenate(column) for column in zip(*pieces, strict=True))
    joints, kept = strongest(weights)
    whole = {name: np.concatenate(some) for name, some in parts.items() if some}
    return Body(points, normals, joints, kept, colours, whole, joint_places(face))


def _weights(patch: Patch) -> Array:
    """Weights (V, J) of all joints: what a place gives, and what new joints take of it."""
    by_place = soft_weights(patch.points, edges_of(patch.triangles), 14 if "trousers" in patch.faces else 4)
    if {"trousers", "sock"} & patch.faces.keys():  # their hems hang on the legs
        for side in SIDES:
            foot, leg = NAMES.index(f"{side}.foot"), NAMES.index(f"{side}.lowerleg")
            by_place[:, leg] += 0.7 * by_place[:, foot]
            by_place[:, foot] *= 0.3
    taken = np.stack([patch.share.get(name, np.zeros(len(patch.points))) for name in MORE], axis=1)
    return np.concatenate([by_place * (1 - taken.sum(1, keepdims=True)), taken], axis=1)


def bind_rotation() -> Array:
    """World rotation matrices (J, 3, 3) of the pose the mesh is made in."""
    turns = np.zeros(len(JOINTS))
    for side, sign in SIDES.items():
        for bone in ("upperarm", "lowerarm", "hand", *FINGERS, "thumb"):
            turns[JOINTS.index(f"{side}.{bone}")] = sign * ARM_SPREAD
        for bone in ("upperleg", "lowerleg"):
            turns[JOINTS.index(f"{side}.{bone}")] = sign * LEG_SPREAD
    c, s, zero, one = np.cos(turns), np.sin(turns), np.zeros_like(turns), np.ones_like(turns)
    return np.stack(
        [np.stack([c, -s, zero], -1), np.stack([s, c, zero], -1), np.stack([zero, zero, one], -1)], axis=1
    )


def joint_places(face: Face) -> Array:
    """Places (J, 3) of all joints in the binding pose."""
    rotation, place = bind_rotation(), list(rest_translation())
    for joint, parent in enumerate(PARENT):
        if parent >= 0:
            place[joint] = place[parent] + rotation[parent] @ place[joint]
    for name in MORE:
        side, _, part = name.rpartition(".")
        at = {"eye": EYE_AT, "lid": EYE_AT, "Jaw": JAW_AT}.get(part)
        at = knuckle(part, face.build.hand) if at is None else at
        place.append(at * (SIDES.get(side, 1.0), 1, 1))
    return np.array(place)


def more_translation(places: Array) -> Array:
    """Local translations (M, 3) of the joints beyond the FAQ's."""
    rotation = bind_rotation()
    rows = []
    for row, parent in enumerate(MORE.values(), len(NAMES)):
        above = NAMES.index(parent)
        rows.append(rotation[above].T @ (places[row] - places[above]))
    return np.array(rows)


def inverse_bind(places: Array) -> Array:
    """Inverse bind matrices (J, 4, 4), row-major."""
    rotation = bind_rotation()
    inverse = np.tile(np.eye(4), (len(JOINTS), 1, 1))
    inverse[:, :3, :3] = np.swapaxes(rotation, 1, 2)
    inverse[:, :3, 3] = -np.einsum("jba,jb->ja", rotation, places)
    return inverse
