"""The FAQ's gearbox (Q24): gears A and B, radius 10 and 8, and the rack C, in units of the FAQ.

The teeth are involutes with a pressure angle of 28 degrees and short tips, so that gears of ten and of eight
teeth need no undercut: between them, and between B and the rack, flanks touch on the line of action at every
angle, with a backlash of 0.03 units.
"""

import numpy as np
from model import Model, material
from shapes import Array, Mesh, about_x, box, joined, lathe

MODULE, PRESSURE = 2.0, np.radians(28)
ADDENDUM, DEDENDUM = 0.8 * MODULE, 1.0 * MODULE
RADIUS_A, RADIUS_B = 10.0, 8.0
TEETH_A, TEETH_B = 10, 8
BACKLASH = 0.03
"""units by which the gap is wider than the tooth, along the pitch circle"""
PITCH = np.pi * MODULE
RACK_TEETH, RACK_BACK = 7, 4.5
DEPTH = 3.0
SCALE = 0.05
"""metres per unit"""
MIDDLE = (-0.5, 1.2, 0.0)
"""metres: the axis of gear A"""
STEEL = material("steel", "#c3cfdb", 0.45, 0.15)
BRASS = material("brass", "#e6b652", 0.45, 0.15)
IRON = material("iron", "#8795a8", 0.5, 0.15)
DARK = material("dark", "#55606f", 0.6, 0.1)
MARK = material("mark", "#e4572e", 0.6)


def _involute(angle: Array) -> Array:
    return np.tan(angle) - angle


def _flank(radius: float, teeth: int) -> Array:
    """Radii and half angles (N, 2) of a tooth from its root to its tip."""
    base = radius * np.cos(PRESSURE)
    radii = np.concatenate(
        [[radius - DEDENDUM], np.linspace(max(base, radius - DEDENDUM), radius + ADDENDUM, 12)]
    )
    half = np.pi / (2 * teeth) - BACKLASH / (4 * radius) + _involute(np.array(PRESSURE))
    return np.stack([radii, half - _involute(np.arccos(np.minimum(base / radii, 1)))], -1)


def gear(radius: float, teeth: int, first: float) -> Array:
    """The outline (N, 2) of a gear, counter-clockwise; the middle of a tooth is at `first` radians."""
    flank = _flank(radius, teeth)
    tooth = np.concatenate([flank * [1, -1], flank[::-1]])
    turns = first + np.arange(teeth)[:, None] * 2 * np.pi / teeth + tooth[:, 1]
    radii = np.broadcast_to(tooth[:, 0], turns.shape)
    return np.stack([radii * np.cos(turns), radii * np.sin(turns)], -1).reshape(-1, 2)


def rack() -> Array:
    """The toothed edge (N, 2) of the rack from below to above; x = 0 is its pitch line, teeth point to -x,
    and the middle tooth is at y = 0.
    """
    slope, half = np.tan(PRESSURE), PITCH / 4 - BACKLASH / 4
    tooth = np.array(
        [
            (DEDENDUM, -half - DEDENDUM * slope),
            (-ADDENDUM, -half + ADDENDUM * slope),
            (-ADDENDUM, half - ADDENDUM * slope),
            (DEDENDUM, half + DEDENDUM * slope),
        ]
    )
    middles = (np.arange(RACK_TEETH) - RACK_TEETH // 2) * PITCH
    return np.concatenate([tooth + np.array([0, middle]) for middle in middles])


def outline_a() -> Array:
    """The outline of gear A: a tooth points to B."""
    return gear(RADIUS_A, TEETH_A, 0.0)


def outline_b() -> Array:
    """The outline of gear B: gaps face A and the rack."""
    return gear(RADIUS_B, TEETH_B, np.pi / TEETH_B)


def _wall(edge: Array, closed: bool) -> Mesh:
    """The wall over an edge, seen from its right side, from -DEPTH/2 to DEPTH/2; flat from point to point."""
    ends = np.roll(edge, -1, 0) if closed else edge[1:]
    starts = edge if closed else edge[:-1]
    way = ends - starts
    normals = np.stack([way[:, 1], -way[:, 0], 0 * way[:, 0]], -1)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    low, high = -DEPTH / 2, DEPTH / 2
    around = [(starts, low), (ends, low), (ends, high), (starts, high)]
    points = np.stack([np.column_stack([xy, np.full(len(xy), z)]) for xy, z in around], 1)
    first = 4 * np.arange(len(starts))[:, None]
    faces = np.concatenate([first + np.array(corners) for corners in ((0, 1, 2), (0, 2, 3))])
    return Mesh(points.reshape(-1, 3), np.repeat(normals, 4, 0), faces)


def _plates(points: Array, faces: Array) -> Mesh:
    """The same flat surface at both ends of the depth."""
    front = np.column_stack([points, np.full(len(points), DEPTH / 2)])
    back = front * [1, 1, -1]
    up = np.tile([0.0, 0, 1], (len(points), 1))
    return joined(Mesh(front, up, faces), Mesh(back, -up, faces[:, ::-1]))


def _wheel(outline: Array) -> Mesh:
    """A gear: its teeth, and its plates around the middle."""
    count = len(outline)
    here = np.arange(count)
    faces = np.stack([here, (here + 1) % count, np.full(count, count)], -1)
    return joined(_wall(outline, closed=True), _plates(np.concatenate([outline, [[0, 0]]]), faces))


def _bar(edge: Array) -> Mesh:
    """The rack: its teeth, its plates, its back and its ends."""
    behind = np.column_stack([np.full(len(edge), RACK_BACK), edge[:, 1]])
    count = len(edge)
    here = np.arange(count - 1)
    faces = np.concatenate(
        [
            np.stack([here, here + 1 + count, here + 1], -1),
            np.stack([here, here + count, here + 1 + count], -1),
        ]
    )
    around = np.concatenate([edge[::-1], behind])
    return joined(_wall(around, closed=True), _plates(np.concatenate([edge, behind]), faces))


def _disc(radius: float, depth: float) -> Mesh:
    profile = [(0.0, -depth / 2), (radius, -depth / 2), (radius, -depth / 2), (radius, depth / 2)]
    return lathe([*profile, (radius, depth / 2), (0.0, depth / 2)], 32).turned(about_x(90))


def _gear_parts(model: Model, joint: str, outline: Array, radius: float, stuff: dict[str, object]) -> None:
    model.part(joint, _wheel(outline), stuff)
    model.part(joint, _disc(radius * 0.3, DEPTH + 1.2), DARK)
    model.part(joint, _disc(radius * 0.09, DEPTH + 0.4).moved(radius * 0.55), MARK)


def make() -> Model:
    """The gearbox: its housing, gears A and B, and the rack C, whose strip of teeth passes without end."""
    model = Model("gearbox")
    model.joint("gearbox", at=MIDDLE, size=SCALE)
    model.joint("gear_a", "gearbox")
    model.joint("gear_b", "gearbox", (RADIUS_A + RADIUS_B, 0.0, 0.0))
    model.joint("rack_c", "gearbox", (RADIUS_A + 2 * RADIUS_B, 0.0, 0.0))
    model.joint("strip", "rack_c")
    _gear_parts(model, "gear_a", outline_a(), RADIUS_A, STEEL)
    _gear_parts(model, "gear_b", outline_b(), RADIUS_B, BRASS)
    model.part("strip", _bar(rack()), IRON)
    centre, guide = RADIUS_A + 2 * RADIUS_B + 1.2, RACK_TEETH * PITCH / 2 - PITCH / 2
    ends = [box((8.6, 9.0, DEPTH + 1.6), 0.4).moved(centre, side * guide) for side in (-1, 1)]
    back = box((36, 2.4, 1.0), 0.3).moved(8.5, 0, -DEPTH)
    model.part("gearbox", joined(*ends, back), DARK)
    model.motion("rest", 1.0, {("gearbox", "translation"): lambda t: np.tile(MIDDLE, (len(t), 1))})
    return model
