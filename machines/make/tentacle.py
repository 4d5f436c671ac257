"""A tentacle with suckers on a stone (RTCA 4): fifteen bones in a soft skin of two influences.

The bones b1 … b15 stand on each other, each shorter than the one below; `tip` is the end of the last.
"""

from collections.abc import Callable

import numpy as np
from model import Model, Motion, linear, material
from scipy.spatial.transform import Rotation
from shapes import Array, Mesh, grid_faces, joined, lathe, smooth

SKIN, CUPS = material("skin", "#ffffff", 0.36), material("suckers", "#ffffff", 0.5)
BACK, BELLY, CUP, BOWL = (np.array(linear(colour)) for colour in ("#9150a3", "#f7c9b2", "#fbe8da", "#dd9797"))
STONE = material("stone", "#5d6670", 0.9)
BONES, LENGTH, SHORTER = 15, 1.7, 0.94
"""bones; metres; the length of a bone as a part of the one below"""
FOOT = 0.07
"""metres: the height of the stone, where b1 begins"""
AROUND, RINGS = 28, 6
"""points around; rings for each bone: of an even number none is at a middle, where one bone alone holds it"""
ROUND, CUP_AROUND = 7, 12
"""rings of the round tip; points around a sucker"""
BELLY_DEG = (34.0, 82.0)
"""from the middle of the belly: where it begins to take the colour of the back, and where it has it"""
SWAY_S, KEYS_PER_SECOND = 8.0, 15
NAMES = ["stone", *(f"b{number}" for number in range(1, BONES + 1)), "tip"]


def _lengths() -> Array:
    shares = SHORTER ** np.arange(BONES)
    return np.asarray(LENGTH * shares / shares.sum())


LENGTHS = _lengths()
JOINTS = FOOT + np.concatenate([[0.0], np.cumsum(LENGTHS)])
"""heights of b1 … b15 and the tip"""
MIDDLES = np.concatenate(
    [[JOINTS[0] - LENGTHS[0] / 2], (JOINTS[1:] + JOINTS[:-1]) / 2, [JOINTS[-1] + LENGTHS[-1] / 2]]
)
"""heights of the middles of all bones, from the stone to the tip"""


def make() -> Model:
    """The tentacle, upright; its belly looks along +Z."""
    model = Model("tentacle")
    model.joint("stone")
    for number in range(BONES):
        at = (0.0, FOOT if number == 0 else float(LENGTHS[number - 1]), 0.0)
        model.joint(NAMES[number + 1], NAMES[number], at)
    model.joint("tip", NAMES[-2], (0.0, float(LENGTHS[-1]), 0.0))
    tube, (suckers, colours) = _tube(), _suckers()
    model.skinned(tube, SKIN, weights(tube.points[:, 1]), _painted(tube))
    model.skinned(suckers, CUPS, weights(suckers.points[:, 1]), colours)
    model.part("stone", lathe(_stone(), 48), STONE)
    model.motion("sway", SWAY_S, _sway(), KEYS_PER_SECOND)
    return model


def weights(height: Array) -> dict[str, Array]:
    """Shares (V,) of the bones at heights (V,): between the middles of two bones both hold it, and their
    shares change smoothly from one to the other.
    """
    row = np.clip(MIDDLES.searchsorted(height) - 1, 0, len(NAMES) - 2)
    part = (height - MIDDLES[row]) / (MIDDLES[row + 1] - MIDDLES[row])
    share = _step(part)
    shares = np.zeros((len(NAMES), len(height)))
    shares[row, np.arange(len(height))] = 1 - share
    shares[row + 1, np.arange(len(height))] = share
    return dict(zip(NAMES, shares, strict=True))


def radius(part: Array) -> Array:
    """Metres, from the foot at 0 to the tip at 1."""
    return 0.022 + 0.118 * (1 - part) ** 0.9 + 0.05 * np.exp(-part / 0.045)


def _tube() -> Mesh:
    """A tube, closed at both ends."""
    inside = (np.arange(RINGS) + 0.5) / RINGS
    high = np.concatenate(
        [[FOOT - 0.03, FOOT - 0.012], (JOINTS[:-1, None] + LENGTHS[:, None] * inside).ravel()]
    )
    end = float(radius(np.ones(1))[0])
    high = high[high < JOINTS[-1] - end]
    wide = radius(np.clip((high - FOOT) / LENGTH, 0, 1))
    turn = np.linspace(0.06, np.pi / 2, ROUND)
    high = np.concatenate([high[:1], high, JOINTS[-1] - end + end * np.sin(turn)])
    wide = np.concatenate([[0.0], wide, end * np.cos(turn)])
    wide[-1] = 0.0
    angle = np.linspace(0, 2 * np.pi, AROUND, endpoint=False)
    flat = 1 - 0.12 * np.maximum(np.cos(angle), 0) ** 2
    points = np.stack(
        [
            np.outer(wide, np.sin(angle)),
            np.outer(high, np.ones(AROUND)),
            np.outer(wide, np.cos(angle) * flat),
        ],
        -1,
    )
    return smooth(points.reshape(-1, 3), grid_faces(len(high), AROUND))


def _painted(tube: Mesh) -> Array:
    """Colours (V, 3): a light belly, a back that is darker at the foot."""
    around = np.abs(np.degrees(np.arctan2(tube.points[:, 0], tube.points[:, 2])))
    back = _step((around - BELLY_DEG[0]) / (BELLY_DEG[1] - BELLY_DEG[0]))[:, None]
    deep = 0.72 + 0.28 * _step((tube.points[:, 1] - FOOT) / (0.6 * LENGTH))[:, None]
    return np.asarray((back * BACK + (1 - back) * BELLY) * deep)


def _step(x: Array) -> Array:
    x = np.clip(x, 0, 1)
    return np.asarray(x * x * (3 - 2 * x))


def _suckers() -> tuple[Mesh, Array]:
    """Cups in two rows along the belly, smaller and smaller; and their colours."""
    cups, height, side = [], FOOT + 0.14, 1.0
    while height < JOINTS[-1] - 0.05:
        wide = float(radius(np.array([(height - FOOT) / LENGTH]))[0])
        size = 0.3 * wide
        turn = side * np.radians(21.0)
        flat = 1 - 0.12 * np.cos(turn) ** 2
        at = (wide * np.sin(turn), height, wide * np.cos(turn) * flat)
        cups.append(_cup(size).turned(Rotation.from_euler("xy", [np.pi / 2, turn]).as_matrix()).moved(*at))
        height, side = height + 1.3 * size, -side
    rings = np.array([0.0, 0, 0, 0, 0.2, 0.8, 1])[:, None, None]
    colours = np.broadcast_to((1 - rings) * CUP + rings * BOWL, (len(cups), len(rings), CUP_AROUND, 3))
    return joined(*cups), colours.reshape(-1, 3)


def _cup(size: float) -> Mesh:
    profile = [(1.0, -0.5), (1.0, 0.12), (0.94, 0.3), (0.8, 0.38), (0.64, 0.32), (0.5, 0.12), (0.0, 0.02)]
    return lathe([(size * r, size * y) for r, y in profile], CUP_AROUND)


def _stone() -> list[tuple[float, float]]:
    turn = np.linspace(0, np.pi / 2, 9)
    rim = [(0.25 + 0.05 * float(np.cos(a)), 0.01 + 0.05 * float(np.sin(a))) for a in turn]
    return [(0.0, 0.0), (0.3, 0.0), (0.3, 0.0), *rim, (0.2, 0.066), (0.0, 0.07)]


def _sway() -> Motion:
    """Waves that run from the foot to the tip: slow ones all along, quick ones near the tip, which curls."""
    motion: dict[tuple[str, str], Callable[[Array], Array]] = {}
    for number in range(BONES):
        motion[NAMES[number + 1], "rotation"] = lambda t, part=(number + 1) / BONES: _bend(t, part)
    return motion


def _bend(t: Array, part: float) -> Array:
    """Quaternions (K, 4) of the bone at a part 0…1 of the length, at times (K,)."""
    once = 2 * np.pi * t / SWAY_S
    slow, quick = 3.4 + 6.0 * part, 5.0 * part**2
    forward = slow * np.sin(once - 3.4 * part) + quick * np.sin(3 * once - 5.5 * part + 0.7)
    aside = 0.9 * slow * np.sin(once - 3.0 * part + 1.8) + quick * np.sin(2 * once - 5.0 * part + 2.6)
    curl = 15.0 * part**4
    rows = np.stack([forward + curl, np.zeros(len(t)), aside], -1)
    return np.asarray(Rotation.from_rotvec(rows, degrees=True).as_quat())
