"""The FAQ's hand of 16 bones (Q2, Q11), in a skin, upright in a cuff."""

from collections.abc import Callable, Mapping

import numpy as np
from hand_poses import (
    BONES,
    CM,
    FINGERS,
    FIST,
    POINT,
    REST,
    SHAKE_S,
    SPREAD,
    alive,
    direction,
    length,
    one_after_another,
)
from model import Model, Motion, material
from shapes import Array, Mesh, ball, joined, lathe, pipe

SKIN = material("skin", "#d79f80", 0.65)
CLOTH, EDGE = material("cloth", "#34557a", 0.9), material("edge", "#e9e4d8", 0.8)
NAIL = material("nail", "#f0cdbd", 0.4)
WIDE = {"little": 0.6, "ring": 0.7, "mid": 0.74, "index": 0.72}
"""centimetres: half the width of a finger at its root"""
KNUCKLE = length("lowerarm") + length("palm")
SOFT = 0.55
"""centimetres around a joint in which the skin bends"""


def make() -> Model:
    """The hand; the palm looks along +Z."""
    model = Model("hand")
    names = BONES.skeleton.names
    for row, name in enumerate(names):
        above = int(BONES.skeleton.parent[row])
        parent = names[above] if above >= 0 else ""
        at = tuple((CM * length(parent) * direction(parent)).tolist()) if parent else (0.0, 0.0, 0.0)
        model.joint(name, parent, at)
    skin, weights = _skin()
    model.skinned(skin, SKIN, weights)
    _cuff(model)
    _nails(model)
    for name, pose, most in (
        ("rest", REST, 1.2),
        ("fist", FIST, 0.4),
        ("point", POINT, 0.6),
        ("spread", SPREAD, 0.9),
    ):
        model.motion(name, SHAKE_S, _turned(alive(pose, most)), 15)
    closing, opening = (*FINGERS, "thumb"), ("thumb", *reversed(FINGERS))
    for name, start, end, order in (("close", REST, FIST, closing), ("open", FIST, REST, opening)):
        seconds, motion = one_after_another(start, end, order)
        model.motion(name, seconds, _turned(motion))
    return model


def _turned(motion: Mapping[str, Callable[[Array], Array]]) -> Motion:
    return {(bone, "rotation"): turns for bone, turns in motion.items()}


def _skin() -> tuple[Mesh, dict[str, Array]]:
    pieces = [_forearm(), _web(), *(_finger(name) for name in FINGERS), _thumb()]
    skin = joined(*(mesh for mesh, _ in pieces))
    weights = {}
    start = 0
    for mesh, shares in pieces:
        for bone, values in shares.items():
            weights.setdefault(bone, np.zeros(len(skin.points)))[start : start + len(values)] = values
        start += len(mesh.points)
    scaled = skin._replace(points=skin.points * CM)
    return scaled, weights


def _forearm() -> tuple[Mesh, dict[str, Array]]:
    """The arm from the cuff, the palm, and the roots of the fingers."""
    table = [
        # height, middle, half width, half depth
        (9.0, 0.0, 3.1, 2.7),
        (14.0, 0.0, 3.0, 2.5),
        (20.0, 0.0, 2.5, 2.0),
        (24.0, 0.0, 2.1, 1.6),
        (26.0, -0.05, 2.15, 1.5),
        (27.5, -0.2, 2.5, 1.55),
        (29.5, -0.4, 2.85, 1.5),
        (31.5, -0.55, 2.95, 1.35),
        (33.5, -0.6, 2.85, 1.15),
        (34.8, -0.6, 2.7, 1.0),
        (35.6, -0.58, 2.45, 0.8),
        (36.1, -0.55, 1.9, 0.45),
        (36.25, -0.55, 0.0, 0.0),
    ]
    fine = np.array(table)
    heights = np.concatenate([np.linspace(9, 35.6, 50), [35.85, 36.0, 36.1, 36.18, 36.25]])
    middle, width, depth = (np.interp(heights, fine[:, 0], fine[:, column]) for column in (1, 2, 3))
    mesh = pipe(
        [(x, y, 0.0) for x, y in zip(middle, heights, strict=True)],
        (1, 0, 0),
        width.tolist(),
        depth.tolist(),
        28,
    )
    palm = _step(mesh.points[:, 1], length("lowerarm"), 1.2)
    return mesh, {"lowerarm": 1 - palm, "palm": palm}


def _finger(name: str) -> tuple[Mesh, dict[str, Array]]:
    """A finger above its knuckle: its bones' lengths along +Y, at the height of its own lane."""
    base = length(f"{name}base") * direction(f"{name}base")
    ends = np.cumsum([base[1], length(f"{name}mid"), length(f"{name}end")])
    full, wide = float(ends[2]), WIDE[name]
    y = np.concatenate(
        [np.linspace(-1.6, full - wide, 34), full - wide + wide * np.sin(np.linspace(0.2, np.pi / 2, 8))]
    )
    thick = np.interp(y, [-1.6, 0.4, ends[0], ends[1], full], wide * np.array([1.0, 1.05, 0.97, 0.9, 0.84]))
    thick *= np.sqrt(np.clip(1 - np.clip((y - full + wide) / wide, 0, 1) ** 2, 0, 1))
    thick[-1] = 0
    joints = sum(0.05 * np.exp(-(((y - end) / 0.4) ** 2)) for end in ends[:2])
    thick = thick * (1 + joints)
    x = np.interp(y, [-1.6, 0.0, ends[0]], [0.75 * base[0], 0.95 * base[0], base[0]])
    mesh = pipe(
        [(a, KNUCKLE + b, 0.0) for a, b in zip(x, y, strict=True)],
        (1, 0, 0),
        thick.tolist(),
        (0.95 * thick).tolist(),
        14,
    )
    along = np.repeat(y, 14)
    steps = [_step(along, at, SOFT) for at in (0.0, float(ends[0]), float(ends[1]))]
    return mesh, {
        "palm": 1 - steps[0],
        f"{name}base": steps[0] - steps[1],
        f"{name}mid": steps[1] - steps[2],
        f"{name}end": steps[2],
    }


def _thumb() -> tuple[Mesh, dict[str, Array]]:
    """The thumb with its ball, from the wrist."""
    wrist = np.array([0.0, length("lowerarm"), 0.0])
    first, second = length("thumbbase"), length("thumbend")
    y = np.concatenate(
        [
            np.linspace(0.3, first + second - 0.7, 32),
            first + second - 0.7 + 0.7 * np.sin(np.linspace(0.2, np.pi / 2, 8)),
        ]
    )
    thick = np.interp(
        y, [0.3, 1.6, 3.2, 5.0, 6.6, 8.0, 9.4, 11.0], [1.15, 1.5, 1.5, 1.1, 0.84, 0.86, 0.8, 0.66]
    )
    thick *= np.sqrt(np.clip(1 - np.clip((y - first - second + 0.7) / 0.7, 0, 1) ** 2, 0, 1))
    thick[-1] = 0
    spine = [
        tuple(
            (
                wrist + min(a, first) * direction("thumbbase") + max(a - first, 0) * direction("thumbend")
            ).tolist()
        )
        for a in y
    ]
    mesh = pipe(spine, (0, 0, 1), (0.95 * thick).tolist(), thick.tolist(), 16)
    along = np.repeat(y, 16)
    root, tip = _step(along, 1.2, 1.2), _step(along, first, SOFT)
    return mesh, {"palm": 1 - root, "thumbbase": root - tip, "thumbend": tip}


def _web() -> tuple[Mesh, dict[str, Array]]:
    """The skin between the thumb and the palm: half of each."""
    wrist = np.array([0.3, length("lowerarm") + 0.4, 0.0])
    way = direction("thumbbase") + np.array([0.0, 0.8, 0.0])
    way = way / np.linalg.norm(way)
    part = np.linspace(0, 1, 12)
    width = 1.6 * (1 - part**2) ** 0.8
    width[-1] = 0
    spine = [tuple((wrist + 4.9 * x * way).tolist()) for x in part]
    mesh = pipe(spine, (1, -0.4, 0), width.tolist(), (0.62 * width).tolist(), 16)
    half = np.full(len(mesh.points), 0.5)
    return mesh, {"palm": half, "thumbbase": half}


def _step(values: Array, at: float, soft: float) -> Array:
    """0 before and 1 after `at`, smooth within `soft`."""
    x = np.clip((values - at) / (2 * soft) + 0.5, 0, 1)
    return np.asarray(x * x * (3 - 2 * x))


def _cuff(model: Model) -> None:
    sleeve = [
        (0.0, 0.0),
        (4.4, 0.0),
        (4.4, 0.0),
        (4.1, 8.0),
        (3.7, 15.0),
        (3.7, 15.0),
        (3.2, 15.1),
        (2.8, 14.5),
    ]
    shirt = [(3.3, 14.6), (3.3, 16.6), (3.3, 16.6), (3.05, 16.7), (2.9, 15.5)]
    for profile, stuff in ((sleeve, CLOTH), (shirt, EDGE)):
        mesh = lathe([(CM * r, CM * y) for r, y in profile], 32)
        model.part("lowerarm", mesh, stuff)


def _nails(model: Model) -> None:
    """On the back of the tips."""
    for name in FINGERS:
        nail = ball(1.0, 12)
        size = CM * np.array([0.42 * WIDE[name] / 0.66, 0.6, 0.16])
        at = CM * (length(f"{name}end") - 0.75)
        nail = nail._replace(points=nail.points * size, normals=nail.normals / size)
        nail = nail._replace(normals=nail.normals / np.linalg.norm(nail.normals, axis=1, keepdims=True))
        model.part(f"{name}end", nail.moved(0.0, at, -CM * 0.8 * WIDE[name]), NAIL)
