"""Keeps a leg that is nearly straight as it was when a transition begins, though its solver eases towards
full stretch: the pose offset begins in the shown pose, which is eased already, and the knee would bend once
more. Over a level floor only: on uneven ground a leg is stretched to places that its motion does not know.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.solve.foot_points import hip_of

SOFTENING = 0.02
"""of the length of a leg before full stretch, from which it eases (`chain_lanes.softened`)"""
STRAIGHTEST = 0.97
"""of that zone: the softening of a leg that is straighter is not undone"""


@called
def beyond_softening(
    f: Any, legs: Any, row: int, foot: int, root: Any, ankle: Any, drop: float, left: float, target: Any
) -> Any:
    """Returns the target x, y, z of an ankle, moved away from the hip by as much as softening will draw it
    nearer, as far as the animated `ankle` is from its hip; all on the stage, in units. The pelvis is lowered
    by `drop`; `left`: how much of the pose offset is left, 0…1.
    """
    x, y, z = hip_of(f, legs, row, foot, root)
    length, animated = f.length[foot], _length(ankle[0] - x, ankle[1] - y, ankle[2] - z)
    y -= drop
    a, b, c = target[0] - x, target[1] - y, target[2] - z
    wanted = _length(a, b, c)
    eased = min((min(animated, wanted) / length - 1.0) / SOFTENING + 1.0, STRAIGHTEST)
    if eased <= 0.0:
        return target
    more = left * SOFTENING * length * (4.0 / math.sqrt(math.sqrt(1.0 - eased)) - 4.0 - eased)
    part = 1.0 + more / wanted
    return x + part * a, y + part * b, z + part * c


@inlined
def _length(x: float, y: float, z: float) -> Any:
    return math.sqrt(x * x + y * y + z * z)
