"""Turns a limb about the line from its start to its target until its first joint is within its limits (IK15).

The middle joint of a limb that reaches its target is on a circle about that line. What the limits of the
first joint cut tells Newton's method how far to go along the circle: what they cut of the first bone's
direction, or, if the limits are angles and the middle joint bends one way, of the whole rotation.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.clamp_kinds import EULER, HINGE
from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, least, most, turned
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, rotated, scaled, vector_square
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
def swivel_limb(chains: Any, clamps: Any, number: int, circle: Any, wanted: Any, scratch: Any) -> None:
    """Turns the first joint of a limb, whose rotation at LOCAL is within its limits, so that the middle joint
    comes to its circle; from there the second bone can point at the target.

    `circle` is what `solve_two_bone` returns: the unit vectors of the first bone and of the hinge in the
    frame of the first joint; the unit vectors to the target and aside, where the middle joint would be
    without limits; how far it is from the start along each of the two, in lengths of the first bone.
    `wanted`: the rotation without limits. Lanes within the limits keep their bits.
    """
    row, within, q = chains.first[number], of(WITHIN), load4(scratch, LOCAL)
    limit, bends_one_way = clamps.row[chains.joint[row]], _bends_one_way(chains, clamps, number)
    if limit < 0:
        return
    if bends_one_way and clamps.kind[limit] == EULER:
        moved, missed = _by_rotation(chains, clamps, row, circle, wanted, q, scratch)
        if any_above(missed, within):
            other = _by_bone(chains, clamps, row, circle, q, False, scratch)
            moved = either4(missed - within, other, moved)
    else:
        moved = _by_bone(chains, clamps, row, circle, q, bends_one_way, scratch)
    store4(scratch, LOCAL, moved)


@inlined
def _bends_one_way(chains: Any, clamps: Any, number: int) -> Any:
    """Whether the first joint must turn so that the middle joint bends about its hinge. A middle joint with a
    cone needs no hinge: it bends to all sides.
    """
    bend = clamps.row[chains.joint[chains.first[number] + chains.middle[number]]]
    return bend >= 0 and (clamps.kind[bend] == HINGE or clamps.kind[bend] == EULER)


@inlined
def _by_bone(chains: Any, clamps: Any, row: int, circle: Any, q: Any, keeps_hinge: Any, scratch: Any) -> Any:
    """The rotation q of the first joint after steps by what limits cut of the first bone's direction; then
    turned about that bone, if the limb keeps its hinge.
    """
    within, (upper, hinge, onward, sideways, along, radius) = of(WITHIN), circle
    aim, bone = added(scaled(onward, along), sideways, radius), rotated(q, upper)
    first_cut = vector_square(minus(bone, aim))
    for _ in range(STEPS):
        lack, around = minus(bone, aim), cross(sideways, onward)
        cut = vector_square(lack)
        if not any_above(cut, within):
            break
        moved = unit(added(sideways, around, _step(lack, cut, around, radius)))
        sideways = where3_below(within, cut, moved, sideways)
        aim = added(scaled(onward, along), sideways, radius)
        q = either4(cut - within, aimed(chains, clamps, row, bone, aim, q, scratch, 0), q)
        bone = rotated(q, upper)
    if keeps_hinge and any_above(first_cut, within):
        hinged = between_frames(upper, hinge, aim, cross(sideways, onward))
        hinged = limited(chains, clamps, row, hinged, broadcast(ONE), scratch, 0)
        hinged = aimed(chains, clamps, row, rotated(hinged, upper), aim, hinged, scratch, 0)
        q = either4(first_cut - within, hinged, q)
    return q


@inlined
def _by_rotation(chains: Any, clamps: Any, row: int, circle: Any, wanted: Any, q: Any, scratch: Any) -> Any:
    """The rotation q of the first joint after steps by what limits cut of its whole rotation, which keeps the
    hinge; and the square of how far the middle joint is from its circle then.
    """
    within, (upper, hinge, onward, sideways, along, radius) = of(WITHIN), circle
    aim, lack = added(scaled(onward, along), sideways, radius), _turn_from(wanted, q)
    first_cut = vector_square(lack)
    for _ in range(STEPS):
        cut = vector_square(lack)
        if not any_above(cut, within):
            break
        moved = unit(added(sideways, cross(onward, sideways), _step(lack, cut, onward, broadcast(ONE))))
        sideways = where3_below(within, cut, moved, sideways)
        aim = added(scaled(onward, along), sideways, radius)
        wanted = between_frames(upper, hinge, aim, cross(sideways, onward))
        q = either4(cut - within, limited(chains, clamps, row, wanted, broadcast(ONE), scratch, 0), q)
        lack = _turn_from(wanted, q)
    if any_above(first_cut, within):
        pointed = aimed(chains, clamps, row, rotated(q, upper), aim, q, scratch, 0)
        q = either4(first_cut - within, pointed, q)
    return q, vector_square(minus(rotated(q, upper), aim))


@inlined
def _turn_from(old: Any, new: Any) -> Any:
    """The axis of the turn from one rotation to another, as long as twice the sine of half the angle."""
    x, y, z, w = mul(new, conjugate(old))
    return turned(x + x, w), turned(y + y, w), turned(z + z, w)


@inlined
def _step(lack: Any, cut: Any, around: Any, radius: Any) -> Any:
    """The tangent of the turn, with the circle's direction `around`, after which limits would cut nothing."""
    along = dot(lack, around)
    step = cut * along / (most(along * along, cut * of(FLATTEST)) * most(radius, of(SMALLEST)))
    return least(most(step, of(-FARTHEST)), of(FARTHEST))
