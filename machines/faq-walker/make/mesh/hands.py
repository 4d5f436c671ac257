"""Arms: a sleeve's inside to the wrist, a palm, four fingers and a thumb, all one net."""

import numpy as np
from curves import Array
from mesh.figure import ARM_WAY, FRONT, HAND_SIDE, SHOULDER_AT, Figure
from mesh.patches import Patch, cast, fan, net
from mesh.surface import Indices, averaged, edges_of
from skeleton import WRIST

ROUND = 20
"""points of a ring round arm and palm: nine on the back of the hand, nine on the palm, one at each side"""
FINGERS = ("index", "middle", "ring", "little")
KNUCKLES = {  # along from the wrist, across to the front, length, radius, bend of its three parts in degrees
    "index": (0.092, 0.0300, 0.072, 0.0097, (14, 20, 14)),
    "middle": (0.096, 0.0100, 0.079, 0.0100, (17, 24, 16)),
    "ring": (0.092, -0.0098, 0.073, 0.0096, (21, 27, 18)),
    "little": (0.083, -0.0285, 0.058, 0.0085, (25, 30, 20)),
}
THUMB_LENGTH = 0.068


def place(along: Array | float, out: Array | float, ahead: Array | float) -> Array:
    """A point of the hand: from the wrist towards the fingers, away from the palm, towards the thumb."""
    along, out, ahead = np.broadcast_arrays(along, out, ahead)
    return np.asarray(
        SHOULDER_AT
        + (WRIST + along)[..., None] * ARM_WAY
        + out[..., None] * HAND_SIDE
        + ahead[..., None] * FRONT
    )


def knuckle(name: str, size: float) -> Array:
    """Where a finger bends."""
    if name == "thumb":
        return place(size * 0.030, size * -0.004, size * 0.034)
    along, ahead, _, _, _ = KNUCKLES[name]
    return place(size * (along - 0.008), 0.0, size * ahead)


# the ring: from the thumb's side over the back of the hand to the other side, and back over the palm
_BACK = np.linspace(1, -1, 9)
_ACROSS = np.concatenate([[1.12], _BACK, [-1.12], _BACK[::-1]])
_OUT = np.concatenate([[0.0], np.ones(9), [0.0], -np.ones(9)])


def _palm_ring(along: float, wide: float, thick: float, shift: float, size: float) -> Array:
    """A ring of the palm: flat, its edges round."""
    edge = np.sqrt(np.clip(1 - np.abs(_ACROSS / 1.12) ** 3.2, 0, 1))
    along = along + 0.20 * along * np.minimum(_ACROSS, 0.0)
    return place(size * along, size * thick * _OUT * edge, size * (shift + wide * _ACROSS / 1.12))


def _arm_rings(figure: Figure) -> Array:
    turn = np.arctan2(_OUT, _ACROSS * 1.05)
    way = np.cos(turn)[:, None] * FRONT + np.sin(turn)[:, None] * HAND_SIDE
    begin = min(figure.build.sleeve - 0.045, 0.50)
    along = [at for at in (begin, 0.18, 0.225, 0.265, 0.295, 0.325, 0.37, 0.43, 0.49, 0.535) if at >= begin]
    origin = SHOULDER_AT + np.array(along)[:, None, None] * ARM_WAY
    return cast(figure.arm, origin, way, 0.12)


def make_arm(figure: Figure) -> Patch:
    """The left arm and hand."""
    size = figure.build.hand
    rings = [
        *_arm_rings(figure),
        _palm_ring(0.012, 0.0285, 0.0195, 0.001, size),
        _palm_ring(0.030, 0.0345, 0.0185, 0.002, size),
        _palm_ring(0.052, 0.0390, 0.0165, 0.002, size),
        _palm_ring(0.074, 0.0405, 0.0140, 0.001, size),
    ]
    points = list(np.concatenate(rings))
    index = np.arange(len(points)).reshape(-1, ROUND)
    last = _roots(points, size)
    faces = [_without_thumb(index)]
    share: dict[str, list[tuple[int, float]]] = {}
    for number, name in enumerate(FINGERS):
        loop = last[number]
        made = _finger(name, np.array(points)[loop], size)
        rows = _grown(points, loop, made, faces)
        share[name] = _shares(rows, (0.5, 0.95))
    loop = np.array(
        [
            index[-4, 1],
            index[-3, 1],
            index[-2, 1],
            index[-2, 0],
            index[-2, -1],
            index[-3, -1],
            index[-4, -1],
            index[-4, 0],
        ]
    )
    rows = _grown(points, loop, _thumb(np.array(points)[loop], size), faces)
    share["thumb"] = _shares(rows, (0.25, 0.7, 0.95))
    faces.append(_webs(index[-1], last))
    triangles = np.concatenate(faces)
    corners = np.array(points)[triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    middle = place(0.05, 0.0, 0.0)
    if ((corners.mean(1) - middle) * across)[: 2 * ROUND].sum() < 0:
        triangles = triangles[:, ::-1]
    weights = {}
    for name, entries in share.items():
        weights[f"Left.{name}"] = np.zeros(len(points))
        for row, part in entries:
            weights[f"Left.{name}"][row] = part
    return Patch(_softened(np.array(points), triangles, index[-4:].min()), {"skin": triangles}, weights)


def _softened(points: Array, faces: Indices, start: int) -> Array:
    """The hand, its palm and the roots of its fingers rounder."""
    last = start + 4 * ROUND + 23 + 8
    points = points.copy()
    for _ in range(2):
        points[start:last] += 0.35 * (averaged(points, edges_of(faces)) - points)[start:last]
    return points


def _shares(rows: list[Indices], first: tuple[float, ...]) -> list[tuple[int, float]]:
    """How much of each ring of a finger its bone has, beginning at its root."""
    return [
        (int(row), first[min(at, len(first) - 1)] if at < len(first) else 1.0)
        for at, ring in enumerate(rows)
        for row in ring
    ]


def _without_thumb(index: Indices) -> Indices:
    """The net of arm and palm but for the hole in which the thumb stands."""
    kept = []
    for row in range(len(index) - 1):
        for column in range(ROUND):
            if row in (len(index) - 4, len(index) - 3) and column in (0, ROUND - 1):
                continue
            a, b = index[row, column], index[row, (column + 1) % ROUND]
            c, d = index[row + 1, (column + 1) % ROUND], index[row + 1, column]
            kept.extend([(a, b, c), (a, c, d)])
    return np.array(kept)


def _roots(points: list[Array], size: float) -> list[Indices]:
    """The loops (8,) at which the fingers begin: points on the back and on the palm, and the webs."""
    loops, back, palm = [], [], []
    for column in range(9):
        at = np.interp(column, [1, 3, 5, 7], [KNUCKLES[name][0] for name in FINGERS]) - 0.012
        ahead = np.interp(column, [0, 1, 3, 5, 7, 8], [0.0395, 0.030, 0.010, -0.0098, -0.0285, -0.0375])
        inset = 0.0 if column % 2 else 0.35
        back.append(len(points))
        points.append(
            place(size * (at - (0 if column % 2 else 0.004)), size * (0.0118 - 0.006 * inset), size * ahead)
        )
        palm.append(len(points))
        points.append(place(size * (at + 0.002), size * (-0.0112 + 0.006 * inset), size * ahead))
    sides = []
    for column in range(0, 9, 2):
        at = np.interp(column, [1, 3, 5, 7], [KNUCKLES[name][0] for name in FINGERS]) + (
            0.006 if 0 < column < 8 else -0.010
        )
        ahead = np.interp(column, [0, 1, 3, 5, 7, 8], [0.0415, 0.030, 0.010, -0.0098, -0.0285, -0.0385])
        sides.append(len(points))
        points.append(place(size * at, 0.0, size * ahead))
    for number in range(4):
        a = 2 * number
        loops.append(
            np.array(
                [
                    sides[number],
                    back[a],
                    back[a + 1],
                    back[a + 2],
                    sides[number + 1],
                    palm[a + 2],
                    palm[a + 1],
                    palm[a],
                ]
            )
        )
    return loops


def _webs(ring: Indices, loops: list[Indices]) -> Indices:
    """From the palm's last ring to the roots of the fingers."""
    back = [loops[0][1], *(row for loop in loops for row in loop[2:4])]
    palm = [loops[0][7], *(row for loop in loops for row in (loop[6], loop[5]))]
    end = np.array([loops[0][0], *back, loops[3][4], *palm[::-1]])
    return net(np.stack([ring, end]), closed=True)


def _grown(points: list[Array], loop: Indices, made: Array, faces: list[Indices]) -> list[Indices]:
    """A tube of rings (R, K, 3) and a last point, grown out of a loop; returns the numbers of its rings."""
    rings, tip = made[:-1], made[-1, 0]
    rows = [loop]
    for ring in rings:
        rows.append(np.arange(len(points), len(points) + len(ring)))
        points.extend(ring)
    faces.extend([net(np.stack(rows), closed=True), fan(rows[-1], len(points))])
    points.append(tip)
    return [*rows, np.array([len(points) - 1])]


def _tube(spine: Array, side: Array, radii: Array, loop: Array) -> Array:
    """Rings around a spine (R, 3), their first point towards `side`, and the end of the spine; the first ones
    are still a little like the loop.
    """
    ahead = np.gradient(spine, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    across = side - (ahead * side).sum(1, keepdims=True) * ahead
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    first = loop - loop.mean(0)
    sense = np.sign((np.cross(first, np.roll(first, -1, 0)).sum(0) * ahead[0]).sum())
    turn = sense * 2 * np.pi * np.arange(len(loop)) / len(loop)
    rings = spine[:, None] + radii[:, None, None] * (
        np.cos(turn)[:, None] * across[:, None] + np.sin(turn)[:, None] * np.cross(ahead, across)[:, None]
    )
    return np.asarray(rings)


def _finger(name: str, loop: Array, size: float) -> Array:
    along, ahead, length, radius, bends = KNUCKLES[name]
    parts = size * length * np.array([0.44, 0.31, 0.25])
    start = place(size * (along - 0.004), size * 0.0005, size * ahead)
    lean = 0.06 * (ahead - 0.002) / 0.03
    at, angle, spine, radii = start, 0.0, [], []
    for part, bend, thick in zip(parts, np.radians(bends), (1.0, 0.95, 0.86), strict=True):
        angle += bend * 0.5
        way = np.cos(angle) * ARM_WAY - np.sin(angle) * HAND_SIDE + lean * FRONT
        angle += bend * 0.5
        for f in (0.30, 0.86) if part > parts[2] + 1e-9 else (0.25, 0.62, 0.86):
            spine.append(at + f * part * way)
            swell = (
                {0.30: 1.0, 0.86: 1.03, 0.25: 1.0, 0.62: 0.93}[f]
                if part > parts[2] + 1e-9
                else {0.25: 1.0, 0.62: 0.96, 0.86: 0.70}[f]
            )
            radii.append(size * radius * thick * swell)
        at = at + part * way
    rings = _tube(np.array(spine), FRONT, np.array(radii), loop)
    tip = np.broadcast_to(at, (1, len(loop), 3))
    return np.concatenate([rings, tip])


def _thumb(loop: Array, size: float) -> Array:
    start = loop.mean(0)
    keys = [
        (0.008, 0.0148),
        (0.022, 0.0138),
        (0.034, 0.0112),
        (0.044, 0.0112),
        (0.056, 0.0106),
        (0.0635, 0.0078),
    ]
    way0 = 0.66 * ARM_WAY + 0.70 * FRONT - 0.28 * HAND_SIDE
    way1 = 0.88 * ARM_WAY + 0.42 * FRONT - 0.24 * HAND_SIDE
    spine, radii = [], []
    for at, radius in keys:
        f = at / THUMB_LENGTH
        spine.append(start + size * (at * (1 - 0.5 * f) * way0 + at * 0.5 * f * way1))
        radii.append(size * radius)
    end = start + size * THUMB_LENGTH * (0.5 * way0 + 0.5 * way1) * 1.03
    rings = _tube(np.array(spine), loop[0] - start, np.array(radii), loop)
    return np.concatenate([rings, np.broadcast_to(end, (1, len(loop), 3))])
