"""A bust with the walker's head, subdivided once; `machines/face/face.yaml` gives it muscles."""

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from model import Model, Motion, linear, turn_about
from shapes import Array, Mesh, grid_faces, smooth
from subdivide import subdivided

sys.path.append(str(Path(__file__).resolve().parents[1] / "faq-walker" / "make"))

from mesh.build import WALKER
from mesh.eyes import make_eyes
from mesh.face import EYE_AT, JAW_AT, Face
from mesh.hair import make_hair
from mesh.head import make_head
from mesh.patches import Patch

FOOT = 1.36
"""height of the bust's foot in the walker's space: everything is moved down by it"""
NECK_AT = np.array([0.0, 1.50, -0.015])
SECONDS = 8.0
BLINKS = (1.1, 3.4, 3.75, 6.3)
PAINTS = {
    "skin": ("skin", "lips", "lids", "lash", "mouth"),
    "hair": ("hair", "brow"),
    "eyes": ("white", "iris", "rim", "pupil", "glint"),
}
ROUGH = {"skin": 0.62, "hair": 0.6, "eyes": 0.2, "cloth": 0.85, "stand": 0.45}


def make() -> Model:
    """The bust; it looks along +Z."""
    model = Model("face")
    model.joint("Bust")
    head = tuple((NECK_AT - (0, FOOT, 0)).tolist())
    model.joint("Head", "Bust", head)
    for side, sign in (("Left", 1.0), ("Right", -1.0)):
        at = tuple((EYE_AT * (sign, 1, 1) - NECK_AT).tolist())
        model.joint(f"{side}.eye", "Head", at)
        model.joint(f"{side}.lid", "Head", at)
    model.joint("Jaw", "Head", tuple((JAW_AT - NECK_AT).tolist()))
    face = Face(WALKER)
    *eyes, teeth = make_eyes(face)
    patches = [_fine(patch) for patch in (make_head(face), *eyes, *make_hair(face))]
    patches.append(_wide(teeth))
    for material, paints in PAINTS.items():
        _add(model, patches, material, paints)
    _bust(model)
    model.motion("idle", SECONDS, _idle(), 30)
    return model


def _fine(patch: Patch) -> Patch:
    """A patch of skin or hair, subdivided; eyes, teeth and nostrils stay as they are."""
    if not {"skin", "brow", "hair"} & patch.faces.keys():
        return patch
    shares = np.stack([np.zeros(len(patch.points)), *patch.share.values()], -1)
    values, faces = subdivided(np.concatenate([patch.points, shares], 1), patch.triangles)
    ends = np.cumsum([len(part) for part in patch.faces.values()])
    by_paint = dict(zip(patch.faces, np.split(faces.reshape(4, -1, 3), ends[:-1], axis=1), strict=True))
    return Patch(
        values[:, :3],
        {paint: part.reshape(-1, 3) for paint, part in by_paint.items()},
        dict(zip(patch.share, values[:, 4:].T, strict=True)),
    )


def _wide(teeth: Patch) -> Patch:
    """More teeth, for a grin: the row is wider, and its ends are farther back."""
    points = teeth.points * (1.75, 1, 1)
    points[:, 2] -= 0.012 * (points[:, 0] / points[:, 0].max()) ** 2
    return Patch(points, teeth.faces, teeth.share)


def _stuff(name: str) -> dict[str, object]:
    surface = {"baseColorFactor": [1.0] * 4, "metallicFactor": 0.0, "roughnessFactor": ROUGH[name]}
    return {"name": name, "pbrMetallicRoughness": surface}


def _add(model: Model, patches: list[Patch], material: str, paints: tuple[str, ...]) -> None:
    """All that has a material, as one skinned part."""
    pieces: list[tuple[Array, Array, Array, Array]] = []
    faces, start = [], 0
    for patch in patches:
        normals, weights = patch.normals(), _weights(patch)
        for paint in (paint for paint in paints if paint in patch.faces):
            used, index = np.unique(patch.faces[paint], return_inverse=True)
            colour = np.tile(linear(WALKER.colours[paint]), (len(used), 1))
            pieces.append((patch.points[used], normals[used], weights[used], colour))
            faces.append(start + index.reshape(-1, 3))
            start += len(used)
    points, normals, weights, colours = (np.concatenate(column) for column in zip(*pieces, strict=True))
    mesh = Mesh(points - (0, FOOT, 0), normals, np.concatenate(faces))
    by_joint = dict(zip(model.names, weights.T, strict=True))
    used_joints = {name: column for name, column in by_joint.items() if column.any()}
    model.skinned(mesh, _stuff(material), used_joints, colours)


JOINTS = ("Bust", "Head", "Left.eye", "Left.lid", "Right.eye", "Right.lid", "Jaw")


def _weights(patch: Patch) -> Array:
    """Weights (V, 7): what the features take, and of the rest the neck and the head."""
    taken = {name: patch.share.get(name, np.zeros(len(patch.points))) for name in JOINTS}
    rest = 1 - sum(taken.values())
    height = np.clip((patch.points[:, 1] - 1.455) / 0.075, 0, 1)
    head = height * height * (3 - 2 * height)
    taken["Head"], taken["Bust"] = rest * head, rest * (1 - head)
    return np.stack([taken[name] for name in JOINTS], -1)


def _bust(model: Model) -> None:
    """A jersey with a roll neck, on a round foot."""
    rows = np.array(
        [  # height, half width, half depth, how far its middle is in front
            (1.402, 0.000, 0.000, -0.014),
            (1.402, 0.050, 0.046, -0.014),
            (1.405, 0.078, 0.068, -0.014),
            (1.413, 0.094, 0.078, -0.014),
            (1.425, 0.096, 0.078, -0.015),
            (1.438, 0.086, 0.072, -0.016),
            (1.449, 0.073, 0.064, -0.017),
            (1.458, 0.0640, 0.0590, -0.018),
            (1.468, 0.0610, 0.0590, -0.018),
            (1.474, 0.0630, 0.0620, -0.017),
            (1.484, 0.0650, 0.0640, -0.016),
            (1.496, 0.0645, 0.0640, -0.015),
            (1.503, 0.0620, 0.0615, -0.015),
            (1.5045, 0.058, 0.0570, -0.015),
            (1.500, 0.0530, 0.0520, -0.015),
            (1.480, 0.0490, 0.0480, -0.016),
        ]
    )
    fine = np.linspace(0, len(rows) - 1, 6 * (len(rows) - 1) + 1)
    y, wide, deep, front = (np.interp(fine, np.arange(len(rows)), column) for column in rows.T)
    y, wide, deep = (_smooth(column) for column in (y, wide, deep))
    wide[0] = deep[0] = 0.0
    jersey = _rings(y - FOOT, wide, deep, front)
    model.part("Bust", jersey, _plain("jersey", WALKER.colours["shirt"], ROUGH["cloth"]))
    stand = [(0.0, 0.0), (0.070, 0.0), (0.074, 0.003), (0.074, 0.010), (0.070, 0.014), (0.03, 0.020)]
    stand += [(0.026, 0.028), (0.028, 0.050)]
    radius, height = np.array(stand).T
    foot = _rings(height, radius, radius, np.full(len(height), -0.010))
    model.part("Bust", foot, _plain("stand", "#41464f", ROUGH["stand"]))


def _rings(y: Array, wide: Array, deep: Array, front: Array, around: int = 48) -> Mesh:
    """Ellipses above each other."""
    turn = 2 * np.pi * np.arange(around) / around
    rings = np.stack(
        [
            np.outer(wide, np.sin(turn)),
            np.outer(y, np.ones(around)),
            np.outer(deep, np.cos(turn)) + front[:, None],
        ],
        -1,
    )
    return smooth(rings.reshape(-1, 3), grid_faces(len(y), around))


def _smooth(column: Array) -> Array:
    """A running mean over seven values."""
    padded = np.pad(column, 3, mode="edge")
    return np.asarray(np.convolve(padded, np.ones(7) / 7, "valid"))


def _plain(name: str, colour: str, rough: float) -> dict[str, object]:
    surface = {"baseColorFactor": [*linear(colour), 1.0], "metallicFactor": 0.0, "roughnessFactor": rough}
    return {"name": name, "pbrMetallicRoughness": surface}


def _idle() -> Motion:
    """Small turns of the head, glances, and blinks; it ends as it begins."""

    def wave(*terms: tuple[float, int, float]) -> Callable[[Array], Array]:
        return lambda t: sum(a * np.sin(2 * np.pi * (n * t / SECONDS + p)) for a, n, p in terms)

    yaw, pitch = wave((2.4, 1, 0.0), (0.9, 3, 0.2)), wave((1.0, 2, 0.3), (0.5, 3, 0.0))
    motion: dict[tuple[str, str], Callable[[Array], Array]] = {
        ("Head", "rotation"): lambda t: _both(yaw(t), pitch(t)),
    }
    glance = (
        (0.0, 0.0),
        (1.0, 0.0),
        (1.08, 7.0),
        (2.6, 7.0),
        (2.68, -3.0),
        (4.6, -3.0),
        (4.68, 0.0),
        (8.0, 0.0),
    )
    times, degrees = np.array(glance).T
    for side in ("Left", "Right"):
        motion[f"{side}.eye", "rotation"] = lambda t: turn_about((0, 1, 0), np.interp(t, times, degrees))
        motion[f"{side}.lid", "rotation"] = lambda t: turn_about((1, 0, 0), 50.0 * _shut(t))
    return motion


def _shut(t: Array) -> Array:
    """How far the lids are closed: 0.12 s down and up."""
    closed = [np.interp(t - at, (-0.08, -0.02, 0.02, 0.14), (0.0, 1.0, 1.0, 0.0)) for at in BLINKS]
    return np.max(closed, axis=0)


def _both(yaw: Array, pitch: Array) -> Array:
    """Rotations (K, 4): about Y after X."""
    x, y = np.radians(pitch) / 2, np.radians(yaw) / 2
    return np.stack(
        [np.sin(x) * np.cos(y), np.cos(x) * np.sin(y), -np.sin(x) * np.sin(y), np.cos(x) * np.cos(y)], -1
    )
