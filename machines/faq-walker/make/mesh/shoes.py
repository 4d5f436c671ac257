"""Shoes: a sole on which the feet roll, an upper that rises from its edge to the collar, laces or a boot's
leg.
"""

import numpy as np
from curves import Array
from mesh.figure import ANKLE_AT, SOLE_Y, Figure
from mesh.patches import Patch, fan, hemmed, net
from mesh.sole_net import sole_net
from moves.feet import HEEL_RADIUS, HEEL_Z, TOE_RADIUS, TOE_Z
from scipy.interpolate import CubicSpline

AROUND, RISE = 32, 7
# the sole from above, beside the ankle: along z, inner and outer half width (a left foot)
OUTLINE = [
    (-0.0620, 0.0),
    (-0.0580, 0.0195),
    (-0.0450, 0.0310),
    (-0.0200, 0.0370),
    (0.0200, 0.0385),
    (0.0600, 0.0410),
    (0.1000, 0.0455),
    (0.1350, 0.0468),
    (0.1650, 0.0410),
    (0.1850, 0.0240),
    (0.1915, 0.0),
]


def sole(z: Array) -> Array:
    """Height of the sole over the ground under a flat foot, z from the ankle."""
    toe = np.clip(z - TOE_Z, 0, 0.98 * TOE_RADIUS)
    heel = np.clip(HEEL_Z - z, 0, 0.98 * HEEL_RADIUS)
    return np.asarray(
        TOE_RADIUS - np.sqrt(TOE_RADIUS**2 - toe**2) + HEEL_RADIUS - np.sqrt(HEEL_RADIUS**2 - heel**2)
    )


def _outline() -> Array:
    """Points (K, 2) of the sole's edge, x and z beside the ankle, from the heel over the outside."""
    z, half = np.array(OUTLINE).T
    around = np.concatenate([np.stack([half, z], -1), np.stack([-half, z], -1)[-2:0:-1]])
    length = np.concatenate(
        [[0], np.cumsum(np.linalg.norm(np.diff(around, axis=0, append=around[:1]), axis=1))]
    )
    curve = CubicSpline(length, np.concatenate([around, around[:1]]), bc_type="periodic")
    points = curve(np.linspace(0, length[-1], AROUND, endpoint=False))
    return np.asarray(points)


def _ring(flat: Array, high: Array | float, size: float = 1.0) -> Array:
    """Points (K, 3) over an outline drawn in towards its middle."""
    middle = np.stack([np.zeros(len(flat)), np.clip(flat[:, 1], -0.03, 0.14)], -1)
    xz = middle + size * (flat - middle)
    y = np.broadcast_to(high, len(flat))
    return np.stack([ANKLE_AT[0] + xz[:, 0], SOLE_Y + y, xz[:, 1]], -1)


def make_shoe(figure: Figure) -> list[Patch]:
    """The left shoe."""
    upper = _upper(figure)
    return [_sole(), upper, _sock(upper), *([] if figure.build.boots else _laces(upper))]


def _sole() -> Patch:
    points, faces = sole_net()
    return Patch(points + np.array([ANKLE_AT[0], SOLE_Y, 0.0]), {"soles": faces})


def _edge(flat: Array) -> Array:
    """Height of the line where sole and upper meet."""
    line = (
        0.022 + 0.007 * np.clip((flat[:, 1] - 0.12) / 0.07, 0, 1) + 0.004 * np.clip(-flat[:, 1] / 0.06, 0, 1)
    )
    return np.asarray(np.maximum(line, sole(1.01 * flat[:, 1]) + 0.006))


def _upper(figure: Figure) -> Patch:
    """Rings from the sole's edge to the collar; over the toes they lie flat, at the heel they stand."""
    flat, top = _outline(), _edge(_outline())
    boots = figure.build.boots
    turn = np.linspace(0, 2 * np.pi, AROUND, endpoint=False)
    collar_y, wide = 0.088, (0.041, 0.052) if boots else (0.039, 0.050)
    lift = 0.018 * np.clip(-np.cos(turn), -0.2, 1)
    collar = np.stack(
        [ANKLE_AT[0] + wide[0] * np.sin(turn), SOLE_Y + collar_y + lift, -0.004 - wide[1] * np.cos(turn)], -1
    )
    share = np.linspace(0, 1, RISE + 1)
    rings = []
    toe = np.clip((flat[:, 1] - 0.01) / 0.17, 0, 1)
    for f in share:
        ahead = f ** (1.0 + 0.35 * toe)
        up = f ** (1.0 - 0.10 * toe)
        base = _ring(flat, top + 0.001, 0.955)
        ring = base * (1 - ahead[:, None]) + collar * ahead[:, None]
        ring[:, 1] = base[:, 1] * (1 - up) + collar[:, 1] * up
        swell = 4 * f * (1 - f) * (0.005 + 0.002 * toe)
        out = np.stack([flat[:, 0], np.zeros(AROUND), flat[:, 1] - np.clip(flat[:, 1], -0.02, 0.13)], -1)
        out /= np.maximum(np.linalg.norm(out, axis=1, keepdims=True), 1e-9)
        ring += swell[:, None] * out * (1 - 0.4 * toe[:, None])
        ring[:, 1] += 4 * f * (1 - f) * 0.014 * toe
        rings.append(ring)
    for high, size in ((0.125, 1.04), (0.165, 1.14), (0.200, 1.24)) if boots else ():
        shaft = collar[:, ::2].mean(0) + size * (collar[:, ::2] - collar[:, ::2].mean(0))
        shaft[:, 0] -= 0.09 * (high - 0.100)
        level = SOLE_Y + high + (lift if high < 0.13 else 0.0)
        rings.append(np.stack([shaft[:, 0], np.broadcast_to(level, AROUND), shaft[:, 1]], -1))
    points = np.concatenate(rings)
    index = np.arange(len(points)).reshape(-1, AROUND)
    heel = np.minimum(np.arange(AROUND), AROUND - 1 - np.arange(AROUND)) < 4
    dark = np.zeros((len(rings) - 1, AROUND), bool)
    dark[-1], dark[1:, heel], dark[0] = True, not boots, boots
    faces = net(index, closed=True)[:, ::-1].reshape(*dark.shape, 2, 3)
    patch = Patch(points, {"shoes": faces[~dark].reshape(-1, 3), "trim": faces[dark].reshape(-1, 3)})
    return hemmed(patch, index[-1], 0.005, 0.02, "trim")


def _sock(upper: Patch) -> Patch:
    """What is seen between the shoe and the trousers."""
    low = upper.points[RISE * AROUND : (RISE + 1) * AROUND].copy()
    middle = np.array([ANKLE_AT[0], 0.0, -0.006])
    rings = []
    for size, high in ((0.86, -0.012), (0.84, 0.02), (0.80, 0.055)):
        ring = middle + size * (low - middle)
        ring[:, 1] = low[:, 1] * 0.5 + low[:, 1].mean() * 0.5 + high
        rings.append(ring)
    index = np.arange(3 * AROUND).reshape(3, AROUND)
    return Patch(np.concatenate(rings), {"sock": net(index, closed=True)[:, ::-1]})


def _laces(upper: Patch) -> list[Patch]:
    """Four bars over the instep."""
    rings = upper.points[: (RISE + 1) * AROUND].reshape(-1, AROUND, 3)
    normals = upper.normals()[: (RISE + 1) * AROUND].reshape(-1, AROUND, 3)
    toe, out = AROUND // 2, []
    for row in np.linspace(RISE - 2.6, RISE - 0.35, 4):
        low, part = int(row), row - int(row)
        line, up = (
            (1 - part) * table[low, toe - 3 : toe + 4] + part * table[low + 1, toe - 3 : toe + 4]
            for table in (rings, normals)
        )
        middle = line + 0.0015 * up
        along = np.gradient(middle, axis=0)
        ahead = np.cross(along, up)
        ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
        around = 2 * np.pi * np.arange(5) / 5
        bars = middle[:, None] + 0.0032 * np.cos(around)[:, None] * up[:, None]
        bars = bars + 0.0042 * np.sin(around)[:, None] * ahead[:, None]
        index = np.arange(35).reshape(7, 5)
        points = np.concatenate([bars.reshape(-1, 3), middle[[0, -1]]])
        faces = np.concatenate([net(index, closed=True), fan(index[0], 35)[:, ::-1], fan(index[-1], 36)])
        patch = Patch(points, {"laces": faces})
        right = (patch.normals()[:35].reshape(7, 5, 3)[:, 0] * up).sum() > 0
        out.append(patch if right else Patch(points, {"laces": faces[:, ::-1]}))
    return out
