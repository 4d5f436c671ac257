"""The FAQ's ship, chain and anchor (Q3): links of a stud chain, alternately turned by a right angle."""

import numpy as np
from model import Model, material
from numpy.typing import NDArray
from shapes import Array, Mesh, about_x, about_y, about_z, box, joined, lathe, pipe, smooth

WIRE = 0.032
"""metres: the thickness of a link; its other sizes follow as those of a real stud link"""
PITCH, WIDTH = 4 * WIRE, 3.6 * WIRE
LINKS = 15
SHANK = 0.42
"""metres from the anchor's ring to its crown"""
HAWSE = (0.0, 2.75, 0.0)
"""metres: where the first link hangs"""
ROCK = (-1.0, 1.05, 0.45)
"""metres: the top of the rock on which the anchor can lie"""
LENGTH, TOP = 2.0, HAWSE[1] + 0.02
"""metres: of the ship, and the height of its deck"""
STONE = material("stone", "#7c7468", 0.95)
Faces = NDArray[np.int64]
STEEL = material("steel", "#8b96a3", 0.42, 0.35)
BLACK = material("black iron", "#3d444d", 0.5, 0.25)
HULL, STRIPE = material("hull", "#8f3b34", 0.6), material("stripe", "#ece7da", 0.7)
DECK, BRASS = material("deck", "#b48a5a", 0.8), material("brass", "#d9ab4c", 0.4, 0.3)


def make() -> Model:
    """The ship, its chain and its anchor."""
    model = Model("anchor-chain")
    model.joint("Ship")
    above, at = "Ship", HAWSE
    for number in range(1, LINKS + 1):
        name = f"Link{number:02}"
        model.joint(name, above, at)
        turned = about_y(90 * (number % 2))
        model.part(name, _link().turned(turned), STEEL)
        above, at = name, (0.0, -PITCH, 0.0)
    model.joint("Anchor", above, at)
    model.joint("Crown", "Anchor", (0.0, -SHANK, 0.0))
    model.part("Anchor", _anchor().turned(about_y(90 * ((LINKS + 1) % 2))), BLACK)
    _ship(model)
    model.joint("Rock", "", (ROCK[0], 0.0, ROCK[2]))
    model.part("Rock", _rock(), STONE)
    model.motion("rest", 1.0, {("Ship", "translation"): lambda t: np.zeros((len(t), 3))})
    return model


def _link() -> Mesh:
    """A link with its stud; the inner ends of its bow are at its joint and at the next."""
    straight, radius = (PITCH + WIRE - WIDTH + WIRE) / 2, (WIDTH - WIRE) / 2
    turn = np.linspace(0, np.pi, 9)
    bow = np.stack([radius * np.cos(turn), straight + radius * np.sin(turn)], -1)
    ring = _closed(np.concatenate([bow, -bow]), WIRE / 2)
    stud = lathe([(0.32 * WIRE, -radius), (0.26 * WIRE, 0.0), (0.32 * WIRE, radius)], 10).turned(about_z(90))
    return joined(ring, stud).moved(0, -PITCH / 2)


def _closed(middle: Array, radius: float, segments: int = 10) -> Mesh:
    """A round wire along a closed line (N, 2) in the XY plane."""
    ahead = np.roll(middle, -1, 0) - np.roll(middle, 1, 0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    out = np.stack([ahead[:, 1], -ahead[:, 0], np.zeros(len(ahead))], -1)
    turn = np.linspace(0, 2 * np.pi, segments, endpoint=False)
    normals = out[:, None] * np.cos(turn)[:, None] + np.array([0.0, 0, 1]) * np.sin(turn)[:, None]
    points = np.concatenate([middle, np.zeros((len(middle), 1))], 1)[:, None] + radius * normals
    row, column = np.meshgrid(np.arange(len(middle)), np.arange(segments), indexing="ij")
    a, b = row * segments + column, row * segments + (column + 1) % segments
    over = (row + 1) % len(middle) * segments
    quads = np.stack([a, b, over + b % segments, over + column], -1).reshape(-1, 4)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    return Mesh(points.reshape(-1, 3), normals.reshape(-1, 3), faces[:, ::-1])


def _anchor() -> Mesh:
    """An anchor with a stock: ring, shank, stock, arms and flukes; it hangs from its joint."""
    ring = _closed(_circle(1.15 * WIRE), 0.4 * WIRE).turned(about_y(90)).moved(0, -0.6 * WIRE)
    shank = lathe([(0.0, -SHANK), (0.7 * WIRE, -SHANK), (0.5 * WIRE, -1.2 * WIRE), (0.0, -1.0 * WIRE)], 12)
    stock = lathe([(0.0, -0.2), (0.3 * WIRE, -0.2), (0.45 * WIRE, 0.0), (0.3 * WIRE, 0.2), (0.0, 0.2)], 10)
    stock = stock.turned(about_x(90)).moved(0, -2.6 * WIRE)
    turn = np.radians(np.linspace(-68, 68, 13))
    arms = pipe(
        [(0.25 * float(np.sin(a)), -SHANK + 0.25 * (1 - float(np.cos(a))), 0.0) for a in turn],
        (0.0, 0.0, 1.0),
        [WIRE * (0.7 - 0.35 * abs(float(k)) / 6) for k in range(-6, 7)],
        [WIRE * (0.8 - 0.4 * abs(float(k)) / 6) for k in range(-6, 7)],
    )
    flukes = [_fluke(side) for side in (-1, 1)]
    return joined(ring, shank, stock, arms, *flukes)


def _rock() -> Mesh:
    """A rock with a flat top."""
    profile = np.array(
        [(0.0, 0.0), (0.5, 0.0), (0.47, 0.25), (0.4, 0.5), (0.37, 0.8), (0.3, ROCK[1]), (0, ROCK[1])]
    )
    turned = lathe([(float(r), float(h)) for r, h in profile], 18)
    x, y, z = turned.points.T
    rough = 1 + 0.12 * np.sin(3.1 * np.arctan2(x, z) + 4 * y) + 0.07 * np.sin(7 * np.arctan2(z, x) - 6 * y)
    points = np.stack([x * rough, y, z * rough], -1)
    return smooth(points, turned.faces)


def _circle(radius: float) -> Array:
    turn = np.linspace(0, 2 * np.pi, 20, endpoint=False)
    return radius * np.stack([np.cos(turn), np.sin(turn)], -1)


def _fluke(side: int) -> Mesh:
    """A plate at the end of an arm."""
    angle = 62.0
    plate = box((0.012, 0.13, 0.12), 0.005, 2).turned(about_z(-side * (90 - angle) - side * 8))
    a = np.radians(angle) * side
    return plate.moved(0.25 * float(np.sin(a)) - side * 0.012, -SHANK + 0.25 * (1 - float(np.cos(a))))


def _ship(model: Model) -> None:
    """A boat whose bow looks along +Z; the chain hangs from the roller at its bow."""
    rim, keel = _rim(), _sections()
    model.part("Ship", smooth(keel.reshape(-1, 3), _net(*keel.shape[:2])[:, ::-1]), HULL)
    outer, inner = _about_middle(rim, 1.02, 1.01), _about_middle(rim, 0.9, 0.95)
    up = np.array([0, 0.005, 0])
    band, edge = np.stack([outer + up, outer - 10 * up], 1), np.stack([outer + up, inner + up], 1)
    model.part("Ship", smooth(band.reshape(-1, 3), _net(len(rim), 2)[:, ::-1]), STRIPE)
    model.part("Ship", smooth(edge.reshape(-1, 3), _net(len(rim), 2)), STRIPE)
    inner = inner - 6 * up
    half = len(inner) // 2 + 1
    deck = np.stack([inner[1:half], inner[half - 1 : -1][::-1]], 1)
    model.part("Ship", smooth(deck.reshape(-1, 3), _net(len(deck), 2)), DECK)
    house = box((0.5, 0.36, 0.6), 0.03).moved(0, TOP + 0.16, -1.5)
    roof = box((0.58, 0.05, 0.68), 0.02).moved(0, TOP + 0.36, -1.5)
    model.part("Ship", joined(house), STRIPE)
    model.part("Ship", joined(roof), HULL)
    windows = [box((0.512, 0.12, 0.13), 0.01).moved(0, TOP + 0.22, -1.5 + x) for x in (-0.17, 0.0, 0.17)]
    model.part("Ship", joined(*windows, box((0.34, 0.12, 0.612), 0.01).moved(0, TOP + 0.22, -1.5)), BLACK)
    cheeks = [box((0.016, 0.1, 0.2), 0.006).moved(side * 0.075, HAWSE[1] + 0.05, -0.08) for side in (-1, 1)]
    roller = lathe([(0.0, -0.07), (0.05, -0.07), (0.036, 0.0), (0.05, 0.07), (0.0, 0.07)], 16)
    model.part("Ship", joined(*cheeks), BLACK)
    model.part("Ship", roller.turned(about_z(90)).moved(0, HAWSE[1] + 0.04, -0.04), BRASS)


def _about_middle(line: Array, wide: float, long: float) -> Array:
    """Points of the ship, spread from its middle."""
    middle = np.array([0, 0, -0.1 - LENGTH / 2])
    return (line - middle) * [wide, 1, long] + middle


def _rim() -> Array:
    """The edge of the deck (N, 3), from the middle of the stern along one side to the bow, and back."""
    part = np.concatenate([[0.0, 0.0], np.linspace(0, 1, 20) ** 0.8])
    beam = 0.44 * np.minimum(1, 0.72 + 0.9 * part) * np.sqrt(1 - part**3)
    beam[0] = 0.0
    sheer = TOP + 0.16 * part**3
    side = np.stack([beam, sheer, (part - 1) * LENGTH - 0.1], -1)
    return np.concatenate([side, side[-2::-1] * [-1, 1, 1]])


def _sections() -> Array:
    """The hull (N, M, 3): from each place of its edge down and in to the keel."""
    rim = _rim()
    down = np.linspace(0, np.pi / 2, 8)
    part = np.clip((rim[:, 2] + 0.1) / LENGTH + 1, 0, 1)
    keel = np.stack([0 * part, TOP - 0.42 + 0.5 * part**4, rim[:, 2] - 0.18 * part**2], -1)
    keel[:, 1] = np.minimum(keel[:, 1], rim[:, 1] - 0.02)
    out, below = np.cos(down)[:, None] ** 0.7, 1 - np.sin(down)[:, None] ** 1.3
    return np.stack(
        [keel[:, None, 0] + (rim - keel)[:, None, 0] * out[:, 0],
         keel[:, None, 1] + (rim - keel)[:, None, 1] * below[:, 0],
         keel[:, None, 2] + (rim - keel)[:, None, 2] * out[:, 0]], -1,
    )  # fmt: skip


def _net(rows: int, columns: int) -> Faces:
    """Triangles of an open net of points."""
    row, column = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = row * columns + column
    quads = np.stack([a, a + 1, a + columns + 1, a + columns], -1).reshape(-1, 4)
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
