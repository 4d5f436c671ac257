"""Where a knee bends to: about the hinge of its thigh, wherever the foot is.

The direction in which a knee bends in the clips is enough while the way to the ankle is not along it. A foot
that is lifted far passes that direction, and the knee would flip to the other side: there the hinge counts,
which is at right angles to that direction and to the thigh.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.solve.chains import POLE, TARGET

ACROSS, ALONG = 0.4, 0.15
"""sines of the angle between the bend of the clips and the way to the ankle, on the side of the thigh: above
the first the bend counts, below the second the hinge
"""


@called
def write_pole(f: Any, legs: Any, inputs: Any, block: int, lane: int, foot: int, drop: float) -> None:
    """Writes the direction in which a knee bends, in model space; the target of the leg's chain is written.
    `drop`: units by which the pelvis is lowered.
    """
    hip = f.hip[foot]
    pole, across = (
        _turned(legs, block, hip, lane, f.bend[foot]),
        _turned(legs, block, hip, lane, f.across[foot]),
    )
    way = (
        inputs[TARGET, lane] - legs[block, hip, 3, lane],
        inputs[TARGET + 1, lane] - legs[block, hip, 7, lane] + drop * f.unit[0],
        inputs[TARGET + 2, lane] - legs[block, hip, 11, lane],
    )
    sine = _dot(across, way)  # times the lengths of both
    if sine < 0.0 or sine * sine < ACROSS * ACROSS * _dot(across, across) * _dot(way, way):
        pole = _by_hinge(_unit(pole), _unit(across), _unit(way))
    for axis in range(3):
        inputs[POLE + axis, lane] = pole[axis]


@inlined
def _by_hinge(bend: Any, across: Any, way: Any) -> Any:
    """The direction in which the knee bends, at right angles to the way to the ankle, all unit vectors."""
    sine = _dot(across, way)
    by_hinge = _unit(_plus((sine * bend[0], sine * bend[1], sine * bend[2]), across, -_dot(bend, way)))
    by_bend = _unit(_plus(bend, way, -_dot(bend, way)))
    part = min((ACROSS - sine) / (ACROSS - ALONG), 1.0)
    return _plus(by_bend, _plus(by_hinge, by_bend, -1.0), part)


@inlined
def _turned(legs: Any, block: int, place: int, lane: int, direction: Any) -> Any:
    """A direction in the frame of a joint, in model space."""
    a, b, c = direction[0], direction[1], direction[2]
    return (
        legs[block, place, 0, lane] * a + legs[block, place, 1, lane] * b + legs[block, place, 2, lane] * c,
        legs[block, place, 4, lane] * a + legs[block, place, 5, lane] * b + legs[block, place, 6, lane] * c,
        legs[block, place, 8, lane] * a + legs[block, place, 9, lane] * b + legs[block, place, 10, lane] * c,
    )


@inlined
def _dot(a: Any, b: Any) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@inlined
def _plus(a: Any, b: Any, factor: float) -> Any:
    return a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]


@inlined
def _unit(a: Any) -> Any:
    size = 1.0 / math.sqrt(max(a[0] * a[0] + a[1] * a[1] + a[2] * a[2], 1e-30))
    return a[0] * size, a[1] * size, a[2] * size
