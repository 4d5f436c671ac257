"""A human skeleton placed in an upright body that looks along +Z: legs between the feet and the crotch, arms
from hand to hand, the spine between them.
"""

from __future__ import annotations

import numpy as np

from statwalk.character.autorig.template import SIDES, JointRow, both_sides, down_to, foot, leg_lines
from statwalk.maths.arrays import Floats
from statwalk.skin.binding.body_graph import BodyGraph

HUMAN = (
    JointRow("Hips", "", "spine", 0.0),
    JointRow("Spine", "Hips", "spine", 0.3),
    JointRow("Chest", "Spine", "spine", 0.62),
    JointRow("Neck", "Chest", "spine", 1.0),
    JointRow("Head", "Neck", "head", 0.0, True),
    *both_sides(
        (
            JointRow("{side}Shoulder", "Chest", "{side} shoulder", 0.3),
            JointRow("{side}UpperArm", "{side}Shoulder", "{side} arm", 0.0),
            JointRow("{side}LowerArm", "{side}UpperArm", "{side} arm", 0.42),
            JointRow("{side}Hand", "{side}LowerArm", "{side} arm", 0.78, True),
            JointRow("{side}UpperLeg", "Hips", "{side} leg", 0.0),
            JointRow("{side}LowerLeg", "{side}UpperLeg", "{side} leg", 0.5),
            JointRow("{side}Foot", "{side}LowerLeg", "{side} foot", 0.0),
            JointRow("{side}Toes", "{side}Foot", "{side} foot", 0.65, True),
        )
    ),
)
ANKLE = 0.055
"""height of the ankle, a share of the body's"""
HEAD = 0.05
"""share of the height to both sides of the crotch in which the top of the head is: ears are no head"""
HANDS_ABOVE = 0.4
"""share of the height above which hands are"""
ASIDE = 2.0
"""times that the distance from the middle counts for hands"""
SHOULDER, NARROWEST, WIDEST = 0.21, 0.12, 0.5
"""share of the way from the breastbone to the hand where the arm begins, and its bounds"""
THICKER = 1.6
"""times the depth of the arm: there the trunk begins"""
CROTCH, LOWEST_CROTCH, HIGHEST_CROTCH = 0.47, 0.2, 0.62
"""share of the height, and its bounds: a skirt has no crotch"""
HIGHEST_NECK = 0.6
"""share of the way from the shoulders to the top in which the neck is"""


def human_lines(graph: BodyGraph) -> dict[str, Floats]:
    """Returns the lines of an upright body.

    :raises ContentError: when it has no feet.
    """
    points = graph.points
    low, height = float(points[:, 1].min()), float(np.ptp(points[:, 1]))
    middle = float((points[:, 0].min() + points[:, 0].max()) / 2)
    feet = {side: foot(graph, sign * (points[:, 0] - middle) > 0, "two feet") for side, sign in SIDES.items()}
    crotch, depth, legs = leg_lines(graph, feet)
    is_central = np.abs(points[:, 0] - crotch[0]) < HEAD * height
    top = int(np.where(is_central, points[:, 1], -np.inf).argmax())
    lines: dict[str, Floats] = {}
    share = (crotch[1] - low) / height
    if not LOWEST_CROTCH < share < HIGHEST_CROTCH:
        crotch = np.array([crotch[0], low + CROTCH * height, crotch[2]])
        depth = height / 20
        legs = {side: _straight_leg(points[feet[side]], crotch) for side in SIDES}
    for side in SIDES:
        leg, _ = down_to(legs[side], low + ANKLE * height)
        lines[f"{side} leg"] = leg
        lines[f"{side} foot"] = _foot_line(graph, leg[-1], low, height)
    away = graph.lengths_from(top) + graph.lengths_from(graph.nearest(crotch))
    is_high = points[:, 1] > low + HANDS_ABOVE * height
    breast = _arms(graph, lines, _hands(graph, np.where(is_high, away, -1), middle))
    neck = _neck(graph, breast, top)
    hips = (legs["Left"][0] + legs["Right"][0]) / 2 + [0, depth / 2, 0]
    way = graph.line(graph.middle_way(graph.nearest(hips), graph.nearest(neck)))
    lines["spine"] = np.concatenate([hips[None], way[1:-1], neck[None]])
    tip = np.array([neck[0], points[top, 1], neck[2]])
    lines["head"] = np.stack([neck + (tip - neck) * 0.1, tip])
    return lines


def _straight_leg(ground: Floats, crotch: Floats) -> Floats:
    """A leg where the way from foot to foot does not go through a crotch."""
    return np.stack([np.array([ground[0], crotch[1], ground[2]]), ground])


def _foot_line(graph: BodyGraph, ankle: Floats, low: float, height: float) -> Floats:
    """The line from an ankle to the tip of its foot."""
    is_foot = (graph.points[:, 1] < low + ANKLE * height) & (
        np.abs(graph.points[:, 0] - ankle[0]) < 2 * ANKLE * height
    )
    ahead = float(graph.points[is_foot, 2].max()) if is_foot.any() else ankle[2] + ANKLE * height
    return np.stack([ankle, [ankle[0], low + ANKLE * height / 3, max(ahead, ankle[2] + graph.size)]])


def _hands(graph: BodyGraph, far: Floats, middle: float) -> dict[str, int]:
    """The voxels of both sides that are furthest from head and crotch (N,), as the way to a hand goes through
    the shoulder, and furthest out, as ears are not.
    """
    out = graph.points[:, 0] - middle
    score = np.where(far >= 0, far + ASIDE * np.abs(out), -1)
    return {side: int(np.where(sign * out > 0, score, -1).argmax()) for side, sign in SIDES.items()}


def _arms(graph: BodyGraph, lines: dict[str, Floats], hands: dict[str, int]) -> Floats:
    """Adds the lines of the arms; returns the point (3,) between the shoulders."""
    way = graph.middle_way(hands["Left"], hands["Right"])
    line, depth = graph.line(way), graph.depth[way]
    half = int(np.abs(line[:, 0] - (line[0, 0] + line[-1, 0]) / 2).argmin())
    half = min(max(half, 2), len(line) - 3)
    breast: Floats = line[half]
    for side, arm, thick in (
        ("Left", line[: half + 1][::-1], depth[: half + 1][::-1]),
        ("Right", line[half:], depth[half:]),
    ):
        start = _arm_start(thick)
        lines[f"{side} arm"], lines[f"{side} shoulder"] = arm[start:], arm[: start + 1]
    return breast


def _arm_start(depth: Floats) -> int:
    """The first step of an arm's line from the breastbone outwards that is no thicker than an arm."""
    count = len(depth)
    arm = float(np.median(depth[count // 2 :]))
    thick = np.flatnonzero(depth > THICKER * arm)
    thick = thick[thick < WIDEST * count]
    start = int(thick[-1]) + 1 if len(thick) else int(SHOULDER * count)
    return min(max(start, int(NARROWEST * count), 1), int(WIDEST * count), count - 2)


def _neck(graph: BodyGraph, breast: Floats, top: int) -> Floats:
    """The narrowest point between the shoulders and the head."""
    way = graph.middle_way(graph.nearest(breast), top)
    line, depth = graph.line(way), graph.depth[way]
    height = graph.points[top, 1]
    highest = breast[1] + HIGHEST_NECK * (height - breast[1])
    between = np.flatnonzero((line[:, 1] >= breast[1]) & (line[:, 1] <= highest))
    if not len(between):
        return breast
    neck: Floats = line[between[depth[between].argmin()]]
    return neck
