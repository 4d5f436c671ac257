"""Clamps rotations and translations to the limits of joints, SK6 (FAQ Q13): swing and twist apart, hinges,
angles about X, Y and Z, and translations.

Arrays of one actor's or many actors' joints; ticks use `simd.clamp_lanes`. Values inside the limits come back
as they were.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.clamp_kinds import CONE, EULER, FREE, HINGE, TOLERANCE
from statwalk.maths.clamp_table import ClampTable
from statwalk.maths.elementary import atan2, sincos

_STEPS = 12
_LOCKED, _ROUNDING = 1e-5, {"f": 5e-7, "d": 1e-15}
_OTHER = np.array([np.pi, np.pi, np.pi])


class ClampedAngles(NamedTuple):
    """Angles about X, then Y, then Z, in radians."""

    excess: Floats
    """(…) by how much the farthest angle leaves its range"""
    clamped: Floats
    """(…, 3)"""
    angles: Floats
    """(…, 3) not clamped"""


class Turn(NamedTuple):
    """Rotations taken apart in the frames of their joints: swing after twist."""

    twist: Floats
    """(…) radians about Y, −π…π"""
    swing: Floats
    """(…, 2) the rotation vector of the swing along X and Z, at most π long"""


def relative_rotation(table: ClampTable, rows: Ints, rotation: Floats) -> Floats:
    """Returns local rotations (…, n, 4) of the joints of n rows relative to the rest pose, in the joints'
    frames.
    """
    dtype = rotation.dtype
    return quat.mul(quat.mul(table.into[rows].astype(dtype), rotation), table.frame[rows].astype(dtype))


def relative_translation(table: ClampTable, rows: Ints, translation: Floats) -> Floats:
    """Returns local translations (…, n, 3) relative to the rest pose, in the joints' frames."""
    dtype = translation.dtype
    return quat.rotate(table.into[rows].astype(dtype), translation - table.rest[rows].astype(dtype))


def clamp_rotation(table: ClampTable, rows: Ints, rotation: Floats) -> Floats:
    """Returns the local rotations (…, n, 4), rest pose included, of the joints of n rows (n,), clamped."""
    rows = np.asarray(rows)
    kind, dtype = table.kind[rows], rotation.dtype
    relative = relative_rotation(table, rows, rotation)
    excess, clamped = _clamp_swing_twist(table, rows, relative)
    is_euler = kind == EULER
    if is_euler.any():
        nearest = clamp_angles(relative, table.angles[rows].astype(dtype))
        excess = np.where(is_euler, nearest.excess, excess)
        clamped = np.where(is_euler[:, None], quat.from_euler_xyz(nearest.clamped), clamped)
    back = quat.mul(quat.mul(quat.conjugate(table.into[rows].astype(dtype)), clamped),
                    quat.conjugate(table.frame[rows].astype(dtype)))  # fmt: skip
    is_outside = (excess > TOLERANCE) & (kind != FREE)
    return np.where(is_outside[..., None], quat.align(rotation, quat.normalize(back)), rotation)


def clamp_translation(table: ClampTable, rows: Ints, translation: Floats) -> Floats:
    """Returns the local translations (…, n, 3), rest pose included, of the joints of n rows, clamped."""
    rows = np.asarray(rows)
    dtype = translation.dtype
    way, slide = relative_translation(table, rows, translation), table.slide[rows].astype(dtype)
    within = np.minimum(np.maximum(way, slide[:, :3]), slide[:, 3:])
    is_outside = (np.abs(way - within).max(-1) > TOLERANCE) & table.has_slide[rows]
    out_of = quat.conjugate(table.into[rows].astype(dtype))
    back = table.rest[rows].astype(dtype) + quat.rotate(out_of, within)
    return np.where(is_outside[..., None], back, translation)


def swing_twist(q: Floats) -> Turn:
    """Takes rotations (…, 4), relative and in their joints' frames, apart: the twist about Y comes first,
    then the swing. A swing by half a turn has no twist.
    """
    sine, cosine, (x, z, w) = _split(q)
    turn = np.sqrt(x * x + z * z)
    angle = 2 * atan2(turn, w)
    factor = np.where(turn > 1e-9, angle / np.where(turn > 1e-9, turn, 1), 2)
    sign = np.where(cosine < 0, -1, 1)
    return Turn(2 * atan2(sign * sine, sign * cosine), np.stack([x * factor, z * factor], -1))


def from_swing_twist(turn: Turn) -> Floats:
    """Returns the rotations (…, 4) of a twist and a swing: the way back from `swing_twist`."""
    sine, cosine = sincos(np.asarray(turn.twist) * 0.5)
    zero = np.zeros_like(sine)
    swing = np.stack([turn.swing[..., 0], zero, turn.swing[..., 1]], -1)
    return quat.mul(quat.from_rotation_vector(swing), np.stack([zero, sine, zero, cosine], -1))


def nearest_of_ellipse(x: Floats, y: Floats, a: Floats, b: Floats) -> tuple[Floats, Floats]:
    """Returns the points of ellipses with half axes `a`, `b` nearest to points (x, y) outside, x and y at
    least 0.

    Newton's method from below the root of Eberly's equation ("Distance from a point to an ellipse").
    """
    smaller = np.minimum(a, b)
    beyond_a, beyond_b = a * a - smaller * smaller, b * b - smaller * smaller
    t = np.maximum(smaller * smaller, np.maximum(a * x - beyond_a, b * y - beyond_b))
    for _ in range(_STEPS):
        to_a, to_b = 1 / (t + beyond_a), 1 / (t + beyond_b)
        p, q = a * x * to_a, b * y * to_b
        t = t + (p * p + q * q - 1) / (2 * np.maximum(p * p * to_a + q * q * to_b, 1e-30))
    return a * (a * x / (t + beyond_a)), b * (b * y / (t + beyond_b))


def clamp_angles(q: Floats, ends: Floats) -> ClampedAngles:
    """Clamps the FAQ's angles of rotations (…, 4); `ends` (…, 6): middles and halves of the ranges about X, Y
    and Z.

    Of the two triples of angles of a rotation the nearer counts; with Y at a quarter turn, the nearest of
    all.
    """
    middle, half = ends[..., :3], ends[..., 3:]
    x, y, z, w = np.moveaxis(q, -1, 0)
    plus, minus = np.sqrt((x + z) ** 2 + (w - y) ** 2), np.sqrt((x - z) ** 2 + (w + y) ** 2)
    total, difference = 2 * atan2(x + z, w - y), 2 * atan2(x - z, w + y)
    about_y = 2 * atan2(minus - plus, minus + plus)
    about_x, about_z = (total + difference) / 2, (total - difference) / 2
    mx, mz, hx = middle[..., 0], middle[..., 2], half[..., 0]
    up = mx + np.clip(_wrapped(mz + difference - mx), -hx, hx)  # plus is lost: only X - Z is known
    down = mx + np.clip(_wrapped(total - mz - mx), -hx, hx)
    about_x = np.where(plus < _LOCKED, up, np.where(minus < _LOCKED, down, about_x))
    about_z = np.where(plus < _LOCKED, up - difference, np.where(minus < _LOCKED, total - down, about_z))
    first = np.stack([about_x, about_y, about_z], -1)
    known = np.minimum(plus, minus)
    noise = np.where(known < _LOCKED, 0, _ROUNDING[q.dtype.char] / np.maximum(known, _LOCKED))
    second = first * np.array([1, -1, 1]) + _OTHER
    one, two = (_clamped(angles, middle, half) for angles in (first, second))
    is_second = (two.excess < one.excess)[..., None]
    nearest = [np.where(is_second, *pair) for pair in ((two.clamped, one.clamped), (two.angles, one.angles))]
    return ClampedAngles(np.minimum(one.excess, two.excess) - noise, *nearest)


def _clamped(angles: Floats, middle: Floats, half: Floats) -> ClampedAngles:
    way = _wrapped(angles - middle)
    within = np.clip(way, -half, half)
    return ClampedAngles(np.abs(way - within).max(-1), middle + within, middle + way)


def _wrapped(angle: Floats) -> Floats:
    turns: Floats = np.rint(angle / (2 * np.pi))
    return angle - 2 * np.pi * turns


def _split(q: Floats) -> tuple[Floats, Floats, tuple[Floats, Floats, Floats]]:
    """Sine and cosine of half the twist, and the swing's quaternion x z w."""
    x, y, z, w = np.moveaxis(q, -1, 0)
    length = np.sqrt(y * y + w * w)
    has_twist = length > 3e-7
    divisor = np.where(has_twist, length, 1)
    sine, cosine = np.where(has_twist, y / divisor, 0), np.where(has_twist, w / divisor, 1)
    return sine, cosine, (x * cosine + z * sine, z * cosine - x * sine, length)


def _clamp_swing_twist(table: ClampTable, rows: Ints, q: Floats) -> tuple[Floats, Floats]:
    """The excess (…, n) in radians, and the rotations with swing and twist clamped."""
    sine, cosine, _swing = _split(q)
    middle_sine, middle_cosine, end_sine, end_cosine = np.moveaxis(table.twist[rows].astype(q.dtype), -1, 0)
    from_middle = sine * middle_cosine - cosine * middle_sine
    along = cosine * middle_cosine + sine * middle_sine
    end = np.where(np.signbit(along), -1, 1) * np.copysign(end_sine, from_middle)
    excess = 2 * (np.abs(from_middle) * end_cosine - np.abs(along) * end_sine)
    is_outside = excess > TOLERANCE
    sine = np.where(is_outside, end * middle_cosine + end_cosine * middle_sine, sine)
    cosine = np.where(is_outside, end_cosine * middle_cosine - end * middle_sine, cosine)
    swing_excess, swing = _clamp_swing(table, rows, swing_twist(q).swing)
    twist = np.stack([0 * sine, sine, 0 * sine, cosine], -1)
    return np.maximum(excess, swing_excess), quat.mul(swing, twist)


def _clamp_swing(table: ClampTable, rows: Ints, swing: Floats) -> tuple[Floats, Floats]:
    """The distance of swings' rotation vectors (…, n, 2) from their limits, and the nearest swings."""
    kind, ends = table.kind[rows], table.swing[rows].astype(swing.dtype)
    low, high = ends[:, :2], ends[:, 2:]
    half = np.where(swing < 0, low, high)
    a, b = half[..., 0], half[..., 1]
    is_cone, is_hinge = kind == CONE, kind == HINGE
    a, b = np.where(is_cone, a, 1), np.where(is_cone, b, 1)
    on = np.stack(nearest_of_ellipse(np.abs(swing[..., 0]), np.abs(swing[..., 1]), a, b), -1)
    is_inside = (swing[..., 0] / a) ** 2 + (swing[..., 1] / b) ** 2 <= 1
    in_cone = np.where(is_inside[..., None], swing, np.copysign(on, swing))
    in_range = np.minimum(np.maximum(swing, low), high)
    nearest = np.where(is_cone[:, None], in_cone, np.where(is_hinge[:, None], 0, in_range))
    excess = np.sqrt(((swing - nearest) ** 2).sum(-1))
    zero = np.zeros_like(excess)
    vectors = np.stack([nearest[..., 0], zero, nearest[..., 1]], -1)
    return excess, quat.from_rotation_vector(vectors)
