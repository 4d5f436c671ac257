"""A tree that grows: the lengths of its bones go from 0 to full (FAQ Q12), and their girth with what they
feed.

A joint NAME is the beginning of each bone, and NAME.girth widens it; a twig has NAME.end and NAME.leaves.
"""

from collections.abc import Callable

import numpy as np
from model import Model, material, turn_about
from shapes import Array, Mesh, ball, joined, lathe, pipe
from tree_bones import LEAF_S, Tree, grown

BARK = material("bark", "#7a5a41", 0.9)
GREENS = (
    material("leaf", "#6f9f3a", 0.7),
    material("young leaf", "#8fbc4b", 0.7),
)
EARTH, GRASS = material("earth", "#6b4f3a", 1.0), material("grass", "#8aa860", 1.0)
RED, WHITE, NUT = (
    material("red", "#c9463a", 0.6),
    material("white", "#f2efe8", 0.6),
    material("seed", "#a9743f"),
)
SMALLEST = 1e-3
LEAVES, LEAF = 26, 0.19
"""leaves at the end of a twig; metres"""
RATE = 10
FALL_S, FADE_S, SHRINK_S, WITHER_S = 1.4, 0.5, 3.0, 7.2
WIND_S = 4.0
ROD_AT = (-1.12, 0.0, -0.3)
TREE = Tree()
Times = Callable[[Array], Array]
Motions = dict[tuple[str, str], Callable[[Array], Array]]
Shares = dict[str, list[tuple[int, Array]]]
"""by joint: the first point of a piece of surface, and the weights of its points"""


def make() -> Model:
    """The tree on its patch of grass, beside a rod with stripes of half a metre."""
    model = Model("tree")
    model.joint("ground")
    for bone in TREE.bones.values():
        at = tuple(TREE.offset(bone.parent).tolist()) if bone.parent else (0.0, 0.04, 0.0)
        model.joint(bone.name, bone.parent or "ground", at)
        model.joint(f"{bone.name}.girth", bone.name)
    for name in TREE.tips:
        model.joint(f"{name}.end", name, tuple(TREE.offset(name).tolist()))
        model.joint(f"{name}.leaves", f"{name}.end")
    _patch(model)
    _wood(model)
    _crown(model)
    seconds = TREE.seconds
    model.motion("seed", 1.0, _growth(lambda t: 0 * t), 2)
    model.motion("grow", seconds, _growth(lambda t: t), RATE)
    at_full = {("trunk1.girth", "scale"): lambda t: np.ones((len(t), 3))}
    model.motion("grown", 1.0, at_full, 2)
    model.motion("wither", WITHER_S, {**_growth(_withered), **_falling(), **_drooping()}, RATE)
    model.motion("wind", WIND_S, _wind(), RATE)
    return model


def _growth(age: Times) -> Motions:
    """The motion whose lengths and girths are those of the tree's age, seconds, at each time."""
    motion: Motions = {}
    for bone in TREE.bones.values():
        ends = TREE.children[bone.name] or [f"{bone.name}.end"]
        for end in ends:
            motion[end, "translation"] = lambda t, bone=bone: np.outer(
                grown(age(t), bone.begin_s, bone.seconds), TREE.offset(bone.name)
            )
        full = float(TREE.radius(bone.name, np.array([TREE.seconds]))[0])
        motion[f"{bone.name}.girth", "scale"] = lambda t, bone=bone, full=full: _even(
            TREE.radius(bone.name, age(t)) / full
        )
    for name in TREE.tips:
        bone = TREE.bones[name]
        begin = bone.begin_s + 0.6 * bone.seconds
        motion[f"{name}.leaves", "scale"] = lambda t, begin=begin: _even(grown(age(t), begin, LEAF_S))
    return motion


def _even(size: Array) -> Array:
    return np.repeat(np.maximum(size, SMALLEST)[:, None], 3, 1)


def _withered(t: Array) -> Array:
    """The age at times of the withering: in the last seconds it goes back to that of the seed."""
    return TREE.seconds * (1 - grown(t, WITHER_S - SHRINK_S, SHRINK_S))


def _falling() -> Motions:
    """Leaves let go one after the other, from the highest to the lowest, fall, and fade on the ground."""
    motion: Motions = {}
    rows = sorted(TREE.tips, key=lambda name: -float(TREE.start(name)[1]))
    for place, name in enumerate(rows):
        begin = 2.1 * place / len(rows)
        high = float((TREE.start(name) + TREE.offset(name))[1])

        def path(t: Array, begin: float = begin, high: float = high, place: int = place) -> Array:
            x = np.clip((t - begin) / FALL_S, 0, 1)
            down = x * x * (3 - 2 * x) * (high - 0.07)
            sway = 0.16 * np.sin(2 * np.pi * 1.5 * x) * (1 - x) * x * 4
            return np.stack([sway * np.cos(place), -down, sway * np.sin(place)], -1)

        motion[f"{name}.leaves", "translation"] = path
        motion[f"{name}.leaves", "scale"] = lambda t, begin=begin: (
            _even(1 - grown(t, begin + FALL_S, FADE_S))
            * (1 - np.outer(grown(t, begin + 0.8 * FALL_S, 0.4), [0.0, 0.7, 0.0]))
        )
    return motion


def _drooping() -> Motions:
    """Boughs sink before the tree goes."""
    motion: Motions = {}
    for name in TREE.bones:
        if name.startswith("bough") and "." not in name:
            x, _, z = TREE.bones[name].direction
            axis = np.array([z, 0.0, -x]) / np.hypot(x, z)
            motion[name, "rotation"] = lambda t, axis=axis: turn_about(
                axis, 24 * grown(t, 0.8, 3.0) * (1 - grown(t, WITHER_S - 0.8, 0.8))
            )
    return motion


def _wind() -> Motions:
    """Turns about the wind's axis: the trunk slowly, boughs and twigs faster and each at its own moment."""
    motion: Motions = {}
    for place, name in enumerate(TREE.bones):
        many, most = (1, 0.7) if name.startswith("trunk") else (2, 2.2) if "." not in name else (3, 4.0)
        motion[name, "rotation"] = lambda t, many=many, most=most, late=0.4 * place: turn_about(
            (0.8, 0.0, -0.6), most * np.sin(2 * np.pi * many * t / WIND_S - (late if many > 1 else 0))
        )
    return motion


def _wood(model: Model) -> None:
    pieces: list[Mesh] = []
    shares: Shares = {}
    for name in TREE.bones:
        mesh, along = _tube(name)
        before = sum(len(piece.points) for piece in pieces)
        pieces.append(mesh)
        shares.setdefault(f"{name}.girth", []).append((before, 1 - along))
        ends = TREE.children[name]
        shares.setdefault(f"{ends[0]}.girth" if ends else f"{name}.end", []).append((before, along))
    wood = joined(*pieces)
    model.skinned(wood, BARK, _spread(shares, len(wood.points)))


def _tube(name: str) -> tuple[Mesh, Array]:
    """The bark of a bone, and how far along the bone each of its points is."""
    now = np.array([TREE.seconds])
    ends = TREE.children[name]
    first = float(TREE.radius(name, now)[0])
    last = float(TREE.radius(ends[0], now)[0]) if ends else 0.002
    part = np.linspace(0, 1, 4)
    start = np.array([0, 0.04, 0]) + TREE.start(name)
    spine = [tuple((start + x * TREE.offset(name)).tolist()) for x in part]
    wide = [first + (last - first) * x for x in part]
    if name == "trunk1":
        wide[0] *= 1.35
    segments = 14 if name.startswith("trunk") else 8
    mesh = pipe(spine, (1.0, 0.0, 0.13), wide, wide, segments)
    return mesh, np.repeat(part, segments)


def _spread(shares: Shares, count: int) -> dict[str, Array]:
    out = {}
    for joint, pieces in shares.items():
        weights = np.zeros(count)
        for start, values in pieces:
            weights[start : start + len(values)] = values
        out[joint] = weights
    return out


def _crown(model: Model) -> None:
    for shade, stuff in enumerate(GREENS):
        pieces: list[Mesh] = []
        shares: Shares = {}
        for place, name in enumerate(TREE.tips):
            if place % 2 == shade:
                before = sum(len(piece.points) for piece in pieces)
                end = np.array([0, 0.04, 0]) + TREE.start(name) + TREE.offset(name)
                pieces.append(_bunch(place, TREE.bones[name].direction).moved(*end.tolist()))
                shares[f"{name}.leaves"] = [(before, np.ones(len(pieces[-1].points)))]
        leaves = joined(*pieces)
        model.skinned(leaves, stuff, _spread(shares, len(leaves.points)))


def _bunch(place: int, way: Array) -> Mesh:
    """Leaves in all directions around the end of a twig, by the golden angle; most of them ahead."""
    number = np.arange(LEAVES) + 0.5
    rise, turn = np.arccos(1 - 1.7 * number / LEAVES), np.pi * (1 + 5**0.5) * number + place
    around = np.stack([np.cos(turn) * np.sin(rise), np.cos(rise), np.sin(turn) * np.sin(rise)], -1)
    return joined(
        *(
            _leaf(0.55 * direction + 0.45 * way, 0.8 + 0.4 * ((7 * row + place) % 5) / 4)
            for row, direction in enumerate(around)
        )
    )


def _leaf(way: Array, size: float) -> Mesh:
    """A leaf from the origin along `way`, folded along its middle, and bent down."""
    ahead = way / np.linalg.norm(way)
    side = np.cross(ahead, [0.13, 1.0, 0.07])
    side /= np.linalg.norm(side)
    up = np.cross(side, ahead)
    long, wide = LEAF * size, 0.33 * LEAF * size
    flat = [
        (0.1, 0, 0),
        (0.45, 1, 0.25),
        (0.8, 0.6, 0.1),
        (1.05, 0, -0.2),
        (0.8, -0.6, 0.1),
        (0.45, -1, 0.25),
    ]
    points = np.array([long * a * ahead + wide * (s * side + u * up) for a, s, u in flat])
    faces = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]])
    shine = ahead + np.array([0.0, 0.8, 0.0])  # both sides are lit as the crown around them
    normals = np.tile(shine / np.linalg.norm(shine), (len(points), 1))
    return Mesh(points, normals, np.concatenate([faces, faces[:, ::-1]]))


def _patch(model: Model) -> None:
    rim = [(1.0, 0.0), (0.97, 0.018), (0.5, 0.03), (0.0, 0.035)]
    model.part("ground", lathe([(1.3 * r, y) for r, y in rim], 48), GRASS)
    hill = [(0.3, 0.02), (0.24, 0.045), (0.12, 0.065), (0.0, 0.07)]
    model.part("ground", lathe(hill, 24), EARTH)
    nut = ball(0.045)
    model.part("ground", nut._replace(points=nut.points * [1, 0.75, 1]).moved(0.0, 0.085, 0.0), NUT)
    for place in range(6):
        low, high = 0.5 * place, 0.5 * (place + 1)
        stripe = [(0.0, low), (0.022, low), (0.022, low), (0.022, high), (0.022, high), (0.0, high)]
        model.part("ground", lathe(stripe, 12).moved(*ROD_AT), RED if place % 2 else WHITE)
