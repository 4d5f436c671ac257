"""Hair: a cap over the skull from the crown to the hairline, combed in locks, its edge as thick as hair."""

from collections.abc import Callable

import numpy as np
from curves import Array
from mesh.face import MIDDLE, Face
from mesh.patches import Patch, cast, fan, hemmed, net
from mesh.shapes import Field, ellipsoid, union
from scipy.interpolate import PchipInterpolator

COLUMNS, ROWS = 42, 8
# azimuth in degrees from the front, and the height of the hairline there
LINES = {
    "quiff": [
        (0, 1.7240),
        (22, 1.7210),
        (42, 1.7080),
        (56, 1.6820),
        (66, 1.6460),
        (74, 1.6340),
        (82, 1.6420),
        (90, 1.6680),
        (104, 1.6690),
        (112, 1.6450),
        (126, 1.6060),
        (150, 1.5930),
        (180, 1.5900),
    ],
    "bun": [
        (0, 1.7350),
        (22, 1.7270),
        (42, 1.7060),
        (58, 1.6760),
        (70, 1.6420),
        (80, 1.6440),
        (92, 1.6680),
        (104, 1.6600),
        (116, 1.6160),
        (140, 1.5900),
        (180, 1.5800),
    ],
}


def _quiff(face: Face) -> Field:
    skull = ellipsoid((0, 1.686, -0.012), (0.0890, 0.0960, 0.1130))
    front = ellipsoid((0.008, 1.7480, 0.044), (0.0680, 0.0410, 0.0600))
    return lambda points: union(union(skull(points), face.skull(points) - 0.006, 0.02), front(points), 0.05)


def _bun(face: Face) -> Field:
    skull = ellipsoid((0, 1.686, -0.012), (0.0885, 0.0935, 0.1120))
    return lambda points: union(skull(points), face.skull(points) - 0.007, 0.02)


STYLES: dict[str, Callable[[Face], Field]] = {"quiff": _quiff, "bun": _bun}


def make_hair(face: Face) -> list[Patch]:
    """The hair of a build."""
    style = face.build.hair
    patches = [_cap(face, STYLES[style](face), LINES[style])]
    if style == "bun":
        patches.append(_ball(np.array([0.0, 1.752, -0.092]), (0.046, 0.042, 0.044)))
    return patches


def _cap(face: Face, field: Field, line: list[tuple[int, float]]) -> Patch:
    turn = 2 * np.pi * (np.arange(COLUMNS) + 0.5) / COLUMNS
    height = PchipInterpolator(*np.array(line).T)(np.degrees(np.abs((turn + np.pi) % (2 * np.pi) - np.pi)))
    flat = np.stack([np.sin(turn), np.zeros(COLUMNS), np.cos(turn)], -1)
    edge = cast(face.skull, np.stack([np.zeros(COLUMNS), height, np.full(COLUMNS, -0.01)], -1), flat, 0.2)
    low = (edge - MIDDLE) / np.linalg.norm(edge - MIDDLE, axis=1, keepdims=True)
    crown = np.array([0.0, 0.94, -0.34])
    share = np.linspace(0, 1, ROWS + 1)[1:, None, None] ** 0.85
    way = crown * (1 - share) + low * share
    way /= np.linalg.norm(way, axis=-1, keepdims=True)
    rows = cast(field, np.broadcast_to(MIDDLE, way.shape), way, 0.25)
    lock = np.where(np.arange(COLUMNS) % 3 == 0, -0.0030, 0.0012)
    rows += way * (lock[None, :, None] * (share * (1.35 - share)) * 2.2)
    skin = cast(face.skull, np.broadcast_to(MIDDLE, low.shape), low, 0.25)
    rows[-1] = skin + np.minimum(0.006, np.linalg.norm(rows[-1] - skin, axis=1, keepdims=True)) * low
    top = cast(field, MIDDLE, crown, 0.25)
    points = np.concatenate([rows.reshape(-1, 3), top[None]])
    index = np.arange(ROWS * COLUMNS).reshape(ROWS, COLUMNS)
    faces = np.concatenate([net(index[::-1], closed=True), fan(index[0], ROWS * COLUMNS)])
    return hemmed(Patch(points, {"hair": faces}), index[-1], 0.010, 0.004, "hair")


def _ball(at: Array, radii: tuple[float, float, float]) -> Patch:
    """A bun of twisted hair."""
    up, turn = np.linspace(0, np.pi, 9)[1:-1], 2 * np.pi * np.arange(14) / 14
    swirl = 1 + 0.05 * np.sin(3 * turn[None] + 4 * up[:, None])
    rings = np.stack(
        [
            np.outer(np.sin(up), np.sin(turn)),
            np.outer(np.cos(up), np.ones(14)),
            np.outer(np.sin(up), np.cos(turn)),
        ],
        -1,
    )
    points = np.concatenate([(rings * swirl[..., None]).reshape(-1, 3), [[0, 1, 0], [0, -1, 0]]]) * radii + at
    index = np.arange(7 * 14).reshape(7, 14)
    faces = np.concatenate([net(index[::-1], closed=True), fan(index[0], 98), fan(index[-1], 99)[:, ::-1]])
    return Patch(points, {"hair": faces})
