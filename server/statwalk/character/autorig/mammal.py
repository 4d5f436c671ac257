"""The skeleton of a four-legged animal placed in a body that looks along +Z: four legs, the spine between
shoulders and hips, neck, head, and a tail if there is one.
"""

from __future__ import annotations

import numpy as np

from statwalk.character.autorig.template import (
    SIDES,
    JointRow,
    both_sides,
    down_to,
    foot,
    leg_lines,
    no_legs,
)
from statwalk.maths.arrays import Floats
from statwalk.skin.binding.body_graph import BodyGraph


def _legs(girdle: str, parent: str) -> tuple[JointRow, ...]:
    name = "{side}" + girdle
    line = "{side} " + girdle
    return both_sides(
        (
            JointRow(name + "UpperLeg", parent, line + " leg", 0.0),
            JointRow(name + "LowerLeg", name + "UpperLeg", line + " leg", 0.5),
            JointRow(name + "Foot", name + "LowerLeg", line + " foot", 0.0, True),
        )
    )


MAMMAL = (
    JointRow("Hips", "", "spine", 0.0),
    JointRow("Spine", "Hips", "spine", 0.4),
    JointRow("Chest", "Spine", "spine", 0.8),
    JointRow("Neck", "Chest", "neck", 0.2),
    JointRow("Head", "Neck", "neck", 0.6, True),
    *(
        JointRow(f"Tail{row + 1}", f"Tail{row}" if row else "Hips", "tail", row / 4, row == 3)
        for row in range(4)
    ),
    *_legs("Front", "Chest"),
    *_legs("Back", "Hips"),
)
ANKLE = 0.2
"""height of the ankle, a share of the height of the shoulders"""
SHORTEST_TAIL = 0.12
"""share of the body's length by which a tail goes beyond the feet"""
THINNER, BEHIND = 0.6, 1.5
"""times the depth of the hips: where the body is thinner, or so far behind, the tail begins"""


def mammal_lines(graph: BodyGraph) -> dict[str, Floats]:
    """Returns the lines of a four-legged body.

    :raises ContentError: when it has no four feet.
    """
    points, low = graph.points, float(graph.points[:, 1].min())
    standing = points[points[:, 1] < low + 0.15 * np.ptp(points[:, 1])]
    across, along = ((standing[:, axis].min() + standing[:, axis].max()) / 2 for axis in (0, 2))
    lines: dict[str, Floats] = {}
    tops: dict[str, Floats] = {}
    depths: dict[str, float] = {}
    for girdle, ahead in (("Front", 1), ("Back", -1)):
        feet = {
            side: foot(
                graph,
                (sign * (points[:, 0] - across) > 0) & (ahead * (points[:, 2] - along) > 0),
                "four feet",
            )
            for side, sign in SIDES.items()
        }
        if _is_filled(graph, *feet.values()):
            raise no_legs("four feet")
        tops[girdle], depths[girdle], legs = leg_lines(graph, feet)
        for side, leg in legs.items():
            ground = np.array([leg[-1, 0], low, leg[-1, 2]])
            leg = np.concatenate([leg, ground[None]])
            upper, lower = down_to(leg, low + ANKLE * (tops[girdle][1] - low))
            lines[f"{side} {girdle} leg"], lines[f"{side} {girdle} foot"] = upper, lower
    hips, chest = graph.nearest(tops["Back"]), graph.nearest(tops["Front"])
    lines["spine"] = graph.line(graph.middle_way(hips, chest))
    nose = int(np.where(points[:, 2] > tops["Front"][2], points[:, 2], -np.inf).argmax())
    lines["neck"] = graph.line(graph.middle_way(chest, nose))
    tail, heel = _tail(graph, hips, depths["Back"]), float(standing[:, 2].min())
    if heel - tail[-1, 2] > SHORTEST_TAIL * float(np.ptp(points[:, 2])):
        lines["tail"] = tail
    return lines


def _is_filled(graph: BodyGraph, left: int, right: int) -> bool:
    """Whether the body fills the space between two feet."""
    between = (graph.points[left] + graph.points[right]) / 2
    return float(np.abs(graph.points - between).max(1).min()) < graph.size


def _tail(graph: BodyGraph, hips: int, depth: float) -> Floats:
    """The line of the tail, from where the way to the hindmost point gets thin."""
    way = graph.middle_way(hips, int(graph.points[:, 2].argmin()))
    thin = np.flatnonzero(graph.depth[way] < THINNER * depth)
    away = np.linalg.norm(graph.points[way] - graph.points[hips], axis=1)
    outside = np.flatnonzero(away > BEHIND * depth)
    first = min(int(rows[0]) for rows in (thin, outside, [len(way) - 2]) if len(rows))
    return graph.line(way[max(first, 0) :])
