"""Turns a limb about the line from its start to its target until its first joint is within its limits (IK15).

The middle joint of a limb that reaches its target is on a circle about that line. What the limits of the
first joint cut of the first bone's direction tells Newton's method how far to go along the circle.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.clamp_kinds import EULER, HINGE
from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, least, most
from statwalk.maths.simd.lane_quat import minus, rotated, scaled, vector_square
from statwalk.maths.simd.lane_turns import between_frames
from statwalk.maths.simd.lane_vector import added, cross, dot, unit, where3_below
from statwalk.maths.simd.lanes import broadcast
from statwalk.maths.simd.pose_lanes import either4, load4, store4
from statwalk.solve.chain_lanes import LOCAL
from statwalk.solve.iterate import aimed, limited

ONE = np.float32(1)
STEPS = 4
"""of Newton's method"""
WITHIN = 1e-12
"""the square of the length by which limits move the end of a unit vector; less counts as nothing"""
FLATTEST = 0.15
"""the least square of the cosine of the angle between the circle and the way back within the limits; a step
counts a smaller one as so large"""
FARTHEST = 1.0
"""the tangent of the largest step"""
SMALLEST = 1e-6
"""the least radius of a circle, in lengths of the first bone"""


@inlined
def swivel_limb(chains: Any, clamps: Any, number: int, circle: Any, scratch: Any) -> None:
    """Turns the first joint of a limb, whose rotation at LOCAL is within its limits, so that the middle joint
    comes to its circle; from there the second bone can point at the target.

    `circle` is what `solve_two_bone` returns: the unit vectors of the first bone and of the hinge in the
    frame of the first joint; the unit vectors to the target and aside, where the middle joint would be
    without limits; how far it is from the start along each of the two, in lengths of the first bone. Lanes
    within the limits keep their bits.
    """
    row, within = chains.first[number], of(WITHIN)
    if clamps.row[chains.joint[row]] < 0:
        return
    upper, hinge, onward, sideways, along, radius = circle
    aim, q = added(scaled(onward, along), sideways, radius), load4(scratch, LOCAL)
    bone = rotated(q, upper)
    first_cut = vector_square(minus(bone, aim))
    for _ in range(STEPS):
        lack, around = minus(bone, aim), cross(sideways, onward)
        cut = vector_square(lack)
        if not any_above(cut, within):
            break
        moved = unit(added(sideways, around, _step(lack, cut, around, radius)))
        sideways = where3_below(within, cut, moved, sideways)
        aim = added(scaled(onward, along), sideways, radius)
        turned = aimed(chains, clamps, row, bone, aim, q, scratch, 0)
        q = either4(cut - within, turned, q)
        bone = rotated(q, upper)
    if any_above(first_cut, within) and _keeps_hinge(chains, clamps, number):
        turned = between_frames(upper, hinge, aim, cross(sideways, onward))
        turned = limited(chains, clamps, row, turned, broadcast(ONE), scratch, 0)
        turned = aimed(chains, clamps, row, rotated(turned, upper), aim, turned, scratch, 0)
        q = either4(first_cut - within, turned, q)
    store4(scratch, LOCAL, q)


@inlined
def _keeps_hinge(chains: Any, clamps: Any, number: int) -> Any:
    """Whether the first joint turns so that the middle joint bends about its hinge. A middle joint with a
    cone needs no hinge: it bends to all sides. A first joint with angles can't keep the hinge: what its
    limits cut of the hinge's direction moves the bone, too.
    """
    first = chains.first[number]
    start, bend = clamps.row[chains.joint[first]], clamps.row[chains.joint[first + chains.middle[number]]]
    bends_one_way = bend >= 0 and (clamps.kind[bend] == HINGE or clamps.kind[bend] == EULER)
    return bends_one_way and clamps.kind[start] != EULER


@inlined
def _step(lack: Any, cut: Any, around: Any, radius: Any) -> Any:
    """The tangent of the turn, with the circle's direction `around`, after which limits would cut nothing."""
    along = dot(lack, around)
    step = cut * along / (most(along * along, cut * of(FLATTEST)) * most(radius, of(SMALLEST)))
    return least(most(step, of(-FARTHEST)), of(FARTHEST))
