"""The collar of the shirt: a band round the neckline."""

import numpy as np
from mesh.figure import Figure
from mesh.patches import Patch, net

AROUND, SECTION = 32, 6


def make_collar(figure: Figure) -> Patch:
    """A flat tube on the shirt's upper edge."""
    turn = 2 * np.pi * np.arange(AROUND) / AROUND
    middle = figure.neckline(turn)
    for _ in range(2):
        middle = (middle + 0.5 * (np.roll(middle, 1, 0) + np.roll(middle, -1, 0))) / 2
    way = np.stack([np.sin(turn), np.full(AROUND, 0.35), np.cos(turn)], -1)
    along = np.roll(middle, -1, 0) - np.roll(middle, 1, 0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    out = np.cross(along, np.cross(way, along))
    out /= np.linalg.norm(out, axis=1, keepdims=True)
    up = np.cross(out, along)
    around = 2 * np.pi * np.arange(SECTION) / SECTION
    rings = middle[:, None] + 0.0036 * np.cos(around)[:, None] * out[:, None]
    rings = rings + 0.0075 * np.sin(around)[:, None] * up[:, None]
    index = np.arange(AROUND * SECTION).reshape(AROUND, SECTION)
    faces = net(np.concatenate([index, index[:1]]), closed=True)
    patch = Patch(rings.reshape(-1, 3), {"band": faces})
    looks = (patch.normals().reshape(rings.shape)[:, 0] * out).sum()
    return patch if looks > 0 else Patch(patch.points, {"band": faces[:, ::-1]})
