"""The transforms that joints give (SK5): from the values of their degrees of freedom, and back.

A transform is relative to the rest pose: local = rest · transform. Radians; the character's unit of length.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.clamp import Turn, clamp_angles, from_swing_twist, nearest_of_ellipse, swing_twist
from statwalk.maths.clamp_kinds import CONE
from statwalk.maths.clamp_table import JointLimit, Range
from statwalk.rig.joint_types import TYPES, freedoms

FLATTEST = 1e-3
"""cosine of the turn of a PRP joint below which its slides count as parallel"""


def transform(limit: JointLimit, values: Floats) -> tuple[Floats, Floats]:
    """Returns the translation (…, 3) and rotation (…, 4) relative to the rest pose, of values (…, F) of the
    joint's F degrees of freedom, which are not clamped.
    """
    values = np.asarray(values, np.float64)
    of = {freedom.name: values[..., place] for place, freedom in enumerate(freedoms(limit))}
    zero = np.zeros(values.shape[:-1])
    if limit.type not in TYPES:
        rotation, way = quat.from_euler_xyz(values[..., :3]), values[..., 3:]
    else:
        angle = of.get("twist", of.get("angle", zero))
        swing = np.stack([of.get("swing_x", zero), of.get("swing_z", zero)], -1)
        rotation = from_swing_twist(Turn(angle, swing))
        along = limit.pitch * angle if limit.pitch else of.get("slide", zero)
        way = np.stack([zero, along, zero], -1)
        if limit.type == "planar":
            way = sum((axis * of[name][..., None] for name, axis in _slides(limit, rotation)), np.zeros(3))
    frame = np.asarray(limit.frame)
    return quat.rotate(frame, way), quat.mul(quat.mul(frame, rotation), quat.conjugate(frame))


def values(limit: JointLimit, translation: Floats, rotation: Floats) -> Floats:
    """Returns the degrees of freedom (…, F) whose transform is nearest to a translation (…, 3) and rotation
    (…, 4) relative to the rest pose: the way back from `transform`.

    A helical joint takes its angle from the rotation, and whole turns from the translation.
    """
    frame = np.asarray(limit.frame)
    turn = quat.mul(quat.mul(quat.conjugate(frame), np.asarray(rotation, np.float64)), frame)
    way = quat.rotate(quat.conjugate(frame), np.asarray(translation, np.float64))
    if limit.type not in TYPES:
        middles = [(low + high) / 2 for low, high in limit.angles]
        halves = [min((high - low) / 2, np.pi) for low, high in limit.angles]
        angles = clamp_angles(turn, np.array(middles + halves)).angles
        return np.concatenate([angles, np.broadcast_to(way, (*angles.shape[:-1], 3))], -1)
    parts = swing_twist(turn)
    if limit.type == "spherical":
        return np.concatenate([parts.swing, _near(parts.twist, limit.twist)[..., None]], -1)
    if limit.type == "helical":
        whole = np.rint((way[..., 1] / limit.pitch - parts.twist) / (2 * np.pi))
        return (parts.twist + 2 * np.pi * whole)[..., None]
    angle = _near(parts.twist, limit.twist)
    if limit.type == "planar":
        return np.stack([*_along_slides(limit, angle, way), angle], -1)
    of = {"angle": angle, "slide": way[..., 1]}
    return np.stack([of[freedom.name] for freedom in freedoms(limit)], -1)


def clamp(limit: JointLimit, values: Floats) -> Floats:
    """Returns the values (…, F) of the degrees of freedom clamped to the joint's limits; the swing of
    a cone to the nearest swing inside it.
    """
    values = np.asarray(values, np.float64)
    free = freedoms(limit)
    clamped = np.clip(values, [freedom.low for freedom in free], [freedom.high for freedom in free])
    if limit.kind != CONE:
        return clamped
    swing = values[..., :2]
    half = np.abs(np.where(swing < 0, *np.moveaxis(np.array(limit.swing), -1, 0)))
    x, z = np.abs(np.moveaxis(swing, -1, 0))
    on = np.stack(nearest_of_ellipse(x, z, half[..., 0], half[..., 1]), -1)
    is_inside = ((swing / half) ** 2).sum(-1) <= 1
    in_cone = np.where(is_inside[..., None], swing, np.copysign(on, swing))
    return np.concatenate([in_cone, clamped[..., 2:]], -1)


def clamped_transform(limit: JointLimit, translation: Floats, rotation: Floats) -> tuple[Floats, Floats]:
    """Returns a translation (…, 3) and rotation (…, 4) relative to the rest pose, clamped to the joint's
    limits; a translation without limits stays.
    """
    nearest = clamp(limit, values(limit, translation, rotation))
    if limit.type == "planar":  # its slides depend on its turn
        back = quat.rotate(quat.conjugate(np.asarray(limit.frame)), np.asarray(translation, np.float64))
        slid = np.stack(_along_slides(limit, nearest[..., 2], back, is_clamped=True), -1)
        nearest = clamp(limit, np.concatenate([slid, nearest[..., 2:]], -1))
    way, turn = transform(limit, nearest)
    return np.asarray(translation, np.float64) if limit.slide is None else way, turn


def _near(angle: Floats, ends: Range) -> Floats:
    """The angle plus the whole turns that bring it nearest to the middle of a range."""
    middle = (ends[0] + ends[1]) / 2
    turns: Floats = np.rint((angle - middle) / (2 * np.pi))
    return angle - 2 * np.pi * turns


def _slides(limit: JointLimit, rotation: Floats) -> list[tuple[str, Floats]]:
    """The direction of each slide of a planar joint, (…, 3) or (3,)."""
    slides = []
    names = iter((("slide_x", np.array([1.0, 0, 0])), ("slide_z", np.array([0.0, 0, 1]))))
    has_turned = False
    for letter in limit.order:
        if letter == "R":
            has_turned = True
        else:
            name, axis = next(names)
            slides.append((name, quat.rotate(rotation, axis) if has_turned else axis))
    return slides


def _along_slides(
    limit: JointLimit, angle: Floats, way: Floats, is_clamped: bool = False
) -> tuple[Floats, Floats]:
    """How far a planar joint has slid along X and Z; slides that are parallel (PRP at a quarter turn) share
    the way as they can.
    """
    sine, cosine = np.sin(angle), np.cos(angle)
    x, z = way[..., 0], way[..., 2]
    if limit.order == "PPR":
        return x, z
    if limit.order == "RPP":
        return x * cosine - z * sine, x * sine + z * cosine
    low, high = (limit.slide or ((-np.inf, np.inf),) * 3)[2]
    slid = z / np.copysign(np.maximum(np.abs(cosine), FLATTEST), cosine)
    slid = np.where((np.abs(cosine) < FLATTEST) | is_clamped, np.clip(slid, low, high), slid)
    return x - slid * sine, slid
