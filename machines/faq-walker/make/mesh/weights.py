"""Soft weights: how much of every vertex belongs to which bone, blended over the joints and smoothed along
the skin.
"""

import numpy as np
from curves import Array
from mesh.build import WALKER
from mesh.figure import ANKLE_AT, ARM_WAY, HIP_AT, LEG_WAY, SHOULDER_AT, Figure
from mesh.surface import Indices, averaged
from numpy.typing import NDArray
from skeleton import NAMES, THIGH, UPPER_ARM, WRIST

INFLUENCES = 4
FIGURE = Figure(WALKER)


def step(x: Array, start: float, end: float) -> Array:
    """0 before `start`, 1 after `end`, smooth between."""
    f = np.clip((x - start) / (end - start), 0.0, 1.0)
    return np.asarray(f * f * (3 - 2 * f))


def _split(whole: Array, part: Array) -> tuple[Array, Array]:
    return whole * (1 - part), whole * part


def _limbs(points: Array, side: str, share: dict[str, Array], rest: Array) -> Array:
    """Give the left or right limbs their share (the points are mirrored to the left); returns what is left
    for the trunk.
    """
    along = (points - SHOULDER_AT) @ ARM_WAY
    inward = np.linalg.norm(points - SHOULDER_AT - along[:, None] * ARM_WAY, axis=1)
    arm = (
        step(along, -0.045, 0.085)
        * step(FIGURE.chest(points) - FIGURE.arm(points), -0.035, 0.045)
        * step(-inward, -0.16, -0.11)
    )
    rest, arm = _split(rest, arm)
    upper, lower = _split(arm, step(along, UPPER_ARM - 0.045, UPPER_ARM + 0.045))
    lower, hand = _split(lower, step(along, WRIST - 0.030, WRIST + 0.025))
    share[f"{side}.upperarm"], share[f"{side}.lowerarm"], share[f"{side}.hand"] = upper, lower, hand
    down = (points - HIP_AT) @ LEG_WAY
    crease = 0.868 + 0.82 * points[:, 0] - 0.045 * step(-points[:, 2], 0.0, 0.09) - points[:, 1]
    rest, leg = _split(rest, step(crease, -0.075, 0.075) * (1 - arm))
    upper, lower = _split(leg, step(down, THIGH - 0.065, THIGH + 0.065))
    lower, foot = _split(lower, step(ANKLE_AT[1] + 0.030 - points[:, 1], -0.025, 0.045))
    share[f"{side}.upperleg"], share[f"{side}.lowerleg"], share[f"{side}.foot"] = upper, lower, foot
    girdle = (
        0.85
        * step(points[:, 0], 0.035, 0.150)
        * step(points[:, 1], 1.335, 1.425)
        * (1 - step(points[:, 1], 1.47, 1.50))
    )
    rest, share[f"{side}.shoulder"] = _split(rest, girdle)
    return rest


def _trunk(points: Array, rest: Array, share: dict[str, Array]) -> None:
    height = points[:, 1]
    pelvis, back = _split(rest, step(height, 0.965, 1.105))
    lower, upper = _split(back, step(height, 1.095, 1.275))
    upper, head = _split(upper, step(height + 0.45 * points[:, 2], 1.455, 1.560))
    share["Lowerback"], share["Upperback"], share["Head"] = lower, upper, head
    share["Right.butt"], share["Left.butt"] = _split(pelvis, step(points[:, 0], -0.05, 0.05))


def soft_weights(points: Array, edges: Indices, rounds: int = 4) -> Array:
    """Weights (V, J) of every bone, summing to 1, not yet cut to four."""
    share: dict[str, Array] = {name: np.zeros(len(points)) for name in NAMES}
    folded = points * np.array([1.0, 1.0, 1.0])
    folded[:, 0] = np.abs(folded[:, 0])
    rest = np.ones(len(points))
    for side, sign in (("Left", 1.0), ("Right", -1.0)):
        here = points[:, 0] * sign >= 0
        part: dict[str, Array] = {}
        rest[here] = _limbs(folded, side, part, np.ones(len(points)))[here]
        for name, value in part.items():
            share[name][here] = value[here]
    _trunk(points, rest, share)
    weights = np.stack([share[name] for name in NAMES], axis=1)
    for _ in range(rounds):
        weights = 0.5 * weights + 0.5 * averaged(weights, edges)
    return np.asarray(weights / weights.sum(1, keepdims=True))


def strongest(weights: Array) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
    """Joints (V, 4) and weights (V, 4) of the four strongest bones; the weights sum to 1."""
    joints = np.argsort(-weights, axis=1, kind="stable")[:, :INFLUENCES]
    kept = np.take_along_axis(weights, joints, axis=1)
    kept = np.where(kept < 0.004, 0.0, kept)
    kept = (kept / kept.sum(1, keepdims=True)).astype(np.float32)
    kept[:, 0] += np.float32(1) - kept.sum(1)
    return np.where(kept > 0, joints, 0).astype(np.uint8), kept
