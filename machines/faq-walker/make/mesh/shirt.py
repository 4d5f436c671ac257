"""The shirt: a front and a back panel that share their seams, sleeves that begin at the armholes, and
hems.
"""

import numpy as np
from curves import Array
from mesh.figure import ARM_WAY, FRONT, HAND_SIDE, SHOULDER_AT, Figure
from mesh.patches import Net, Patch, cast, eased_onto, hemmed, net, outward
from mesh.surface import Indices, project

COLUMNS, ARMHOLE = 12, 6
STRIPE = slice(7, 9)
"""the rings between which the shirt may have a stripe"""
ARMPIT = np.array([0.176, 1.318, -0.006])
TIP = np.array([0.164, 1.476, -0.012])


def _bow(start: Array, middle: Array, end: Array, count: int) -> Array:
    """A curve through three points: quadratic, the middle where it is half way."""
    f = np.linspace(0, 1, count + 1)[:, None]
    return np.asarray(start * (1 - f) * (1 - 2 * f) + middle * 4 * f * (1 - f) + end * f * (2 * f - 1))


def _panel(bottom: Array, side: Array, other: Array, top: Array) -> Array:
    """A net (R + 1, C + 1, 3) between four edges (Coons 1967)."""
    f = np.linspace(0, 1, len(side))[:, None, None]
    g = np.linspace(0, 1, len(bottom))[None, :, None]
    corners = (1 - f) * ((1 - g) * bottom[0] + g * bottom[-1]) + f * ((1 - g) * top[0] + g * top[-1])
    return np.asarray((1 - f) * bottom + f * top + (1 - g) * side[:, None] + g * other[:, None] - corners)


def _top(figure: Figure, sign: float) -> Array:
    """The upper edge of a panel from the right shoulder's tip over the neckline to the left one's."""
    turn = np.radians(np.linspace(-90, 90, 7))
    line = figure.neckline(turn if sign > 0 else np.pi - turn)
    f = np.linspace(0, 1, 4)[:, None]
    left = line[-1] * (1 - f) + TIP * f
    right = (left * (-1, 1, 1))[::-1]
    return np.concatenate([right[:-1], line, left[1:]])


def make_shirt(figure: Figure) -> Patch:
    """The shirt of a build."""
    out, faces = Net(), []
    ring, armhole = _panels(figure, out, faces)
    neck = np.concatenate([armhole[0][-1, 3:-3], armhole[1][-1, 4:-4]])
    cuffs = _sleeves(figure, out, faces, armhole)
    wanted = [neck, ring[0], *cuffs, ring[STRIPE]]
    points, triangles, (neck, hem, *ends, stripe) = _only_used(
        np.array(out.points), np.concatenate(faces), wanted
    )
    fixed = np.concatenate([neck, hem, *(end[-2:].reshape(-1) for end in ends)])
    points = project(figure.shirt, points, 3)
    points = eased_onto(figure.shirt, points, triangles, fixed, 6)
    triangles = outward(points, triangles, figure.shirt)
    bright = np.isin(triangles, stripe).all(1) & ("stripe" in figure.build.colours)
    painted = {"shirt": triangles[~bright], "stripe": triangles[bright]}
    patch = Patch(points, {paint: part for paint, part in painted.items() if len(part)})
    patch = hemmed(patch, hem, 0.004, 0.03, "band")
    patch = hemmed(patch, neck, 0.004, 0.012, "band")
    for end in ends:
        patch = hemmed(patch, end[-1], 0.004, 0.03, "band")
    return patch


def _panels(figure: Figure, out: Net, faces: list[Indices]) -> tuple[Indices, list[Indices]]:
    """The trunk up to the armpits, and the front and back panel; returns its rings, and the panels' nets."""
    turn = np.radians(-90 + 360 / (2 * COLUMNS) * np.arange(2 * COLUMNS))
    way = np.stack([np.sin(turn), np.zeros(len(turn)), np.cos(turn)], -1)
    heights = np.linspace(figure.build.hem, ARMPIT[1], 11)
    origin = np.stack([np.zeros(len(heights)), heights, np.zeros(len(heights))], -1)
    rings = cast(figure.trunk, origin[:, None], way[None])
    ring = out.add(rings)
    faces.append(net(ring, closed=True))
    panels: list[Indices] = []
    for sign in (1.0, -1.0):
        left = _bow(ARMPIT, np.array([0.150, 1.405, sign * 0.052 - 0.010]), TIP, ARMHOLE)
        grid = _panel(rings[-1][_columns(sign)], left * (-1, 1, 1), left, _top(figure, sign))
        index = np.concatenate([ring[-1][_columns(sign)][None], out.add(grid[1:])])
        if panels:  # the back shares the shoulder seams
            index[-1, :4], index[-1, -4:] = panels[0][-1, :4], panels[0][-1, -4:]
        panels.append(index)
        faces.append(net(index if sign > 0 else index[:, ::-1]))
    return ring, panels


def _sleeves(figure: Figure, out: Net, faces: list[Indices], panels: list[Indices]) -> list[Indices]:
    """Both sleeves; returns their rings."""
    cuffs = []
    for column in (-1, 0):
        loop = np.concatenate([panels[0][:, column], panels[1][-2:0:-1, column]])
        sleeve = _sleeve(figure, np.array(out.points)[loop], 1.0 if column else -1.0)
        cuffs.append(np.concatenate([loop[None], out.add(sleeve)]))
        tube = net(cuffs[-1], closed=True)
        faces.append(tube[:, ::-1] if column else tube)
    return cuffs


def _columns(sign: float) -> Indices:
    """The places of a panel's lowest points in the ring below, from the right to the left side."""
    return np.arange(COLUMNS + 1) if sign > 0 else np.append(np.arange(COLUMNS, 2 * COLUMNS), 0)[::-1]


def _sleeve(figure: Figure, loop: Array, sign: float) -> Array:
    """Rings (R, K, 3) from an armhole to the cuff."""
    flip = np.array([sign, 1, 1])
    turn = 2 * np.pi * np.arange(len(loop)) / len(loop)
    way = np.sin(turn)[:, None] * FRONT - np.cos(turn)[:, None] * HAND_SIDE
    start = (loop * flip - SHOULDER_AT) @ ARM_WAY
    count = round(2 + 20 * figure.build.sleeve)
    share = (np.arange(1, count + 1) / count)[:, None]
    along = start * (1 - share) + figure.build.sleeve * share
    along[-2] = np.where(along[-2] > figure.build.sleeve - 0.018, along[-2], figure.build.sleeve - 0.018)
    rings = cast(figure.sleeve, SHOULDER_AT + along[..., None] * ARM_WAY, way, 0.15)
    return np.asarray(rings * flip)


def _only_used(points: Array, faces: Indices, rows: list[Indices]) -> tuple[Array, Indices, list[Indices]]:
    """Without points that no triangle has."""
    used, index = np.unique(faces, return_inverse=True)
    number = np.full(len(points), -1)
    number[used] = np.arange(len(used))
    return points[used], index.reshape(faces.shape), [number[row] for row in rows]
