"""Limits of joints as one table of arrays: what `clamp` and kernels (`simd.clamp_lanes`) read.

The transform of a joint is taken relative to its rest pose, and in the joint's frame: T·R = rest · frame ·
(translation, rotation) · frame⁻¹. The frame turns Y into the twist axis (or a hinge's axis), X into the first
swing axis. Units: radians; the unit of length of the character.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats, Ints, floats
from statwalk.maths.clamp_kinds import CONE, FREE
from statwalk.maths.columns import columns, locked
from statwalk.maths.elementary import sincos
from statwalk.maths.pose import Pose

SMALLEST_SWING = 1e-5
"""radians: smallest half axis of a cone"""
Range = tuple[float, float]
FREE_TURN: Range = (-np.pi, np.pi)


@dataclass(frozen=True)
class JointLimit:
    """The limits of one joint, relative to its rest pose, in its frame."""

    kind: int = FREE
    frame: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    """the rotation x y z w that turns Y into the twist axis and X into the first swing axis"""
    twist: Range = FREE_TURN
    """smallest and largest twist; free if they are a whole turn apart"""
    swing: tuple[Range, Range] = (FREE_TURN, FREE_TURN)
    """smallest and largest component of the swing's rotation vector along X and along Z; a cone's smallest
    are at most 0, its largest at least 0"""
    angles: tuple[Range, Range, Range] = (FREE_TURN, FREE_TURN, FREE_TURN)
    """smallest and largest angles about X, Y and Z of `EULER`"""
    slide: tuple[Range, Range, Range] | None = None
    """smallest and largest translation along X, Y and Z; None: not limited"""
    pitch: float = 0.0
    """of a helical joint: translation along Y for a radian of twist; 0: not coupled"""
    order: str = "PPR"
    """of a planar joint: slide along X, slide along Z and turn about Y; what comes after R turns with it"""
    type: str = ""
    """one of `rig.joints.TYPES`; empty: limits for each axis, as in the FAQ's table"""
    form: str = ""
    """of a type with several forms"""


class ClampTable(NamedTuple):
    """The limits of L of J joints. Angles are stored as their middle and half of their range."""

    row: Annotated[NDArray[np.int32], "joint"]
    """the row of a joint, -1 without limits"""
    joint: Annotated[NDArray[np.int32], "row"]
    kind: Annotated[NDArray[np.int32], "row"]
    has_slide: Annotated[NDArray[np.bool_], "row"]
    """whether the translation is limited"""
    into: Annotated[NDArray[np.float32], "row, xyzw"]
    """(rest · frame)⁻¹"""
    frame: Annotated[NDArray[np.float32], "row, xyzw"]
    rest: Annotated[NDArray[np.float32], "row, xyz"]
    """the translation of the rest pose"""
    twist: Annotated[NDArray[np.float32], "row, number"]
    """(L, 4): sine and cosine of half the middle; sine and cosine of a quarter of the range"""
    swing: Annotated[NDArray[np.float32], "row, number"]
    """(L, 4): smallest X and Z, largest X and Z; a cone's smallest without their sign"""
    angles: Annotated[NDArray[np.float32], "row, number"]
    """(L, 6): middles about X, Y and Z, then halves of the ranges"""
    sines: Annotated[NDArray[np.float32], "row, number"]
    """(L, 16): sine and cosine of the middle, and of half the range, about X, Y and Z; the same of half
    these angles about Y
    """
    round: Annotated[NDArray[np.float32], "row, number"]
    """(L, 2): sine and cosine of half the largest swing of a cone that is the same in all directions; else 0
    """
    slide: Annotated[NDArray[np.float32], "row, number"]
    """(L, 6): smallest along X, Y and Z, then largest"""
    screw: Annotated[NDArray[np.float32], "row, number"]
    """(L, 3) of helical joints: pitch, smallest and largest twist, which may be several turns; else 0"""
    turning: Annotated[NDArray[np.bool_], "row, axis"]
    """(L, 2) of planar joints: whether the slide along X, and along Z, turns with the joint"""


CLAMP_TABLE = columns(ClampTable, readonly=True)
"""the numba type of ClampTable"""


def clamp_table(limits: Mapping[int, JointLimit], rest: Pose) -> ClampTable:
    """Returns the table of the limits by joint, read-only; `rest` is the unbatched rest pose (J, …)."""
    joints = np.array(sorted(limits), np.int32)
    chosen = [limits[joint] for joint in joints.tolist()]
    frame = np.array([limit.frame for limit in chosen], np.float32).reshape(-1, 4)
    row = np.full(rest.rotation.shape[-2], -1, np.int32)
    row[joints] = np.arange(len(joints))
    turning = np.array([_turning(limit.order) for limit in chosen], np.bool_).reshape(-1, 2)
    numbers = [_numbers(limit) for limit in chosen]
    twist, swing, angles, slide, screw = (
        np.array([row[part] for row in numbers], np.float32).reshape(len(chosen), width)
        for part, width in enumerate((4, 4, 6, 6, 3))
    )
    return locked(
        ClampTable(
            row,
            joints,
            np.array([limit.kind for limit in chosen], np.int32),
            np.array([limit.slide is not None for limit in chosen], np.bool_),
            quat.conjugate(quat.mul(rest.rotation[joints], frame)).astype(np.float32),
            frame,
            rest.translation[joints].astype(np.float32),
            twist,
            swing,
            angles,
            _sines(angles),
            _round(swing, np.array([limit.kind for limit in chosen], np.int32)),
            slide,
            screw,
            turning,
        )
    )


def frame_of(axis: ArrayLike, side: ArrayLike | None = None) -> Floats:
    """Returns the rotation (4,) that turns Y into the direction `axis` (3,), and X into the part of `side`
    (3,) at right angles to it; without `side`, the shortest rotation from Y.

    :raises ValueError: when the axis is zero, or `side` is parallel to it.
    """
    y = vector.unit(floats(axis).astype(np.float64))
    if not y.any():
        raise ValueError("the axis has no length")
    if side is None:
        return quat.between(np.array([0.0, 1.0, 0.0]), y)
    across = floats(side).astype(np.float64)
    across = across - y * vector.dot(across, y)[..., None]
    if vector.length(across) < 1e-6:
        raise ValueError("the side axis is parallel to the axis")
    x = vector.unit(across)
    return quat.from_matrix(np.stack([x, y, vector.cross(x, y)], -1))


def _turning(order: str) -> list[bool]:
    first, second = (place for place, letter in enumerate(order) if letter == "P")
    return [first > order.index("R"), second > order.index("R")]


def _numbers(limit: JointLimit) -> tuple[list[float], ...]:
    """The rows of `twist`, `swing`, `angles`, `slide` and `screw`."""
    middle, half = _middle_and_half(limit.twist)
    twist = [np.sin(middle / 2), np.cos(middle / 2), np.sin(half / 2), np.cos(half / 2)]
    (x_least, x_most), (z_least, z_most) = limit.swing
    swing = [x_least, z_least, x_most, z_most]
    if limit.kind == CONE:
        swing = [max(abs(number), SMALLEST_SWING) for number in swing]
    around = [_middle_and_half(angle) for angle in limit.angles]
    angles = [middle for middle, _half in around] + [half for _middle, half in around]
    slide = limit.slide or ((-np.inf, np.inf),) * 3
    ends = [least for least, _most in slide] + [most for _least, most in slide]
    screw = [limit.pitch, *limit.twist] if limit.pitch else [0.0, 0.0, 0.0]
    return twist, swing, angles, ends, screw


def _sines(angles: Floats) -> Floats:
    """The rows of `ClampTable.sines` for the rows of `ClampTable.angles`."""
    middle, half = angles[:, :3].astype(np.float64), angles[:, 3:].astype(np.float64)
    pairs = [part for axis in range(3) for part in (middle[:, axis], half[:, axis])]
    around = np.stack([*pairs, middle[:, 1] / 2, half[:, 1] / 2], -1)
    return np.stack(sincos(around), -1).reshape(-1, 16).astype(np.float32)


def _round(swing: Floats, kind: Ints) -> Floats:
    """The rows of `round` of those of `swing`."""
    is_round = (kind == CONE) & (swing == swing[:, :1]).all(-1) & (swing[:, 0] < np.pi)
    both = np.stack(sincos(swing[:, 0].astype(np.float64) / 2), -1)
    return np.where(is_round[:, None], both, 0).astype(np.float32)


def _middle_and_half(ends: Range) -> Range:
    return (ends[0] + ends[1]) / 2, min((ends[1] - ends[0]) / 2, np.pi)
