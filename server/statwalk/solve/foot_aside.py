"""A foot in the air that comes against the side of a step is moved aside, out of the step, part of its fit
(`foot_fit`).

The way out is as long as the foot is deep in the step: it begins with nothing, and ends as the foot rises
above the step. `f`, `legs`, `root`, `row` as in `foot_points`.
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.solve.foot_points import stage_point

STUMBLE, CLEARED = 0.015, 0.035
"""metres by which a point of the sole is below the top of a step: from STUMBLE on the step is in its way,
from CLEARED on wholly
"""
DEEPEST = 0.09
"""metres by which a foot is moved aside at most"""


@called
def way_out(f: Any, legs: Any, row: int, foot: int, root: Any, x: float, y: float, z: float) -> Any:
    """Returns x and z (metres) that bring the sole of an animated foot, shown `x`, `y`, `z` from where it is
    in `legs`, out of all level pieces of the ground that it is in.
    """
    left, right, back, front = 0.0, 0.0, 0.0, 0.0
    for point in range(f.first_point[foot], f.first_point[foot + 1]):
        px, py, pz = stage_point(f, legs, row, point, root)
        px, py, pz = px + x, py + y, pz + z
        for piece in range(f.ground.shape[0]):
            if f.ground[piece, 5] == 0.0 and f.ground[piece, 6] == 0.0:
                u, v = _out_of(f.ground, piece, px, py, pz)
                left, right, back, front = min(left, u), max(right, u), min(back, v), max(front, v)
    return left + right, back + front


@inlined
def _out_of(ground: Any, piece: int, x: float, y: float, z: float) -> Any:
    """The nearest way out of a level piece for a point below its top, through one of its sides."""
    low_x, low_z = ground[piece, 0] - x, ground[piece, 1] - z
    high_x, high_z = ground[piece, 2] - x, ground[piece, 3] - z
    below = ground[piece, 4] - y
    if low_x > 0.0 or low_z > 0.0 or high_x < 0.0 or high_z < 0.0 or below <= STUMBLE:
        return 0.0, 0.0
    share = min((below - STUMBLE) / (CLEARED - STUMBLE), 1.0)
    u = low_x if -low_x < high_x else high_x
    v = low_z if -low_z < high_z else high_z
    if abs(u) < abs(v):
        return min(max(u, -DEEPEST), DEEPEST) * share, 0.0
    return 0.0, min(max(v, -DEEPEST), DEEPEST) * share
