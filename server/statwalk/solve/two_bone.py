"""Analytic two-bone inverse kinematics: hip, knee, ankle; shoulder, elbow, wrist (IK15)."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, least, most, root, size
from statwalk.maths.simd.lane_quat import minus, mul, plus, rotated, rotated_back, scaled, vector_square
from statwalk.maths.simd.lane_turns import between, between_frames, half_turn
from statwalk.maths.simd.lane_vector import (
    added,
    cross,
    dot,
    length,
    per_root,
    perpendicular,
    unit,
    where3_below,
)
from statwalk.maths.simd.lanes import broadcast
from statwalk.maths.simd.pose_lanes import load3, load4, store4
from statwalk.solve.chain_lanes import JOINT, LOCAL, OFFSET, softened
from statwalk.solve.iterate import limited, note_cuts

ZERO, ONE, HALF = np.float32(0), np.float32(1), np.float32(0.5)
STRAIGHT = 1.2e-7
"""the squared sine of the largest angle that counts as zero"""
NEAREST = 1e-5
"""the least distance from start to end, as a part of the length of both bones"""
SHORTEST = 1e-12
"""metres: a shorter bone counts as so long"""
NO_POLE = 1e-30
"""the squared length below which a pole counts as none"""


@inlined
def solve_two_bone(
    scratch: Any, count: int, middle: int, target: Any, pole: Any, hinge_of_start: Any, softening: Any
) -> Any:
    """Turns the first and the middle joint so that the last of `count` joints comes to the target; returns
    the softened target, how far the end is from the target, and the circle of the middle joint (see
    `swivel_limb`).

    `pole` is the direction in which the middle joint bends; zero: as it bends now. For a target out of
    reach the limb is straight and points at it; for a target that is too near it is folded. A knee keeps the
    axis about which it is bent now, or bends about `hinge_of_start` in the frame of the first joint if that
    is not zero; then a knee that is bent backwards is bent forwards again.

    Bones and hinges are in the frame of the first joint, all else is in that of its parent.
    """
    start, first = load3(scratch, OFFSET), load4(scratch, LOCAL)
    upper, lower, above = _bones(scratch, count, middle)
    smallest, one = of(SHORTEST * SHORTEST), broadcast(ONE)
    upper_square, lower_square = most(vector_square(upper), smallest), most(vector_square(lower), smallest)
    upper_length, lower_length = root(upper_square), root(lower_square)
    per_lengths, whole = one / (upper_length * lower_length), upper_length + lower_length
    per_upper = per_lengths * lower_length
    raw = cross(upper, lower)
    soft = softened(target, start, whole, softening)
    aim = minus(soft, start)

    onward, aim_length, per_reach = _onward(aim, first, upper, lower, whole)
    sideways = _sideways(pole, first, upper, onward, upper_square)
    apart = size(upper_length - lower_length)
    reach = least(most(most(aim_length, apart), whole * of(NEAREST)), whole)
    if any_above(size(reach - aim_length), broadcast(ZERO)):  # too far or too near
        per_reach = one / reach
    along, aside = _corner(upper_length - lower_length, apart, whole, reach, per_reach)
    new_x = scaled(added(scaled(onward, along), sideways, aside), per_upper)
    new_hinge = cross(sideways, onward)
    hinge = _old_hinge(raw, per_lengths, upper, first, new_x, new_hinge, hinge_of_start)
    circle = scaled(upper, per_upper), hinge, onward, sideways, along * per_upper, aside * per_upper
    turned = between_frames(circle[0], hinge, new_x, new_hinge)
    store4(scratch, LOCAL, turned)
    old = dot(upper, lower) * per_lengths, dot(raw, hinge) * per_lengths
    new_cosine = (reach * reach - upper_square - lower_square) * (broadcast(HALF) * per_lengths)
    if middle > 1:
        hinge = rotated_back(above, hinge)
    turn, at = _bend(hinge, old, (new_cosine, aside * reach * per_lengths)), middle * JOINT + LOCAL
    store4(scratch, at, mul(turn, load4(scratch, at)))
    if any_above(softening, broadcast(ZERO)):
        return soft, length(added(minus(target, start), onward, -reach)), circle
    return soft, size(aim_length - reach), circle


@inlined
def _bones(scratch: Any, count: int, middle: int) -> Any:
    """The vectors from the first joint to the middle one, and from there to the last, and the rotation of the
    middle joint's parent, in the frame of the first joint.
    """
    zero = broadcast(ZERO)
    above = zero, zero, zero, broadcast(ONE)
    upper, lower = load3(scratch, middle * JOINT + OFFSET), load3(scratch, (count - 1) * JOINT + OFFSET)
    for step in range(count - 1 - middle):
        place = count - 2 - step
        lower = rotated(load4(scratch, place * JOINT + LOCAL), lower)
        if place > middle:
            lower = plus(load3(scratch, place * JOINT + OFFSET), lower)
    for step in range(middle - 1):  # joints that stay, such as twist bones
        q, offset = (
            load4(scratch, (middle - 1 - step) * JOINT + LOCAL),
            load3(scratch, (middle - 1 - step) * JOINT + OFFSET),
        )
        upper, lower, above = plus(offset, rotated(q, upper)), rotated(q, lower), mul(q, above)
    return upper, lower, above


@inlined
def _corner(difference: Any, apart: Any, whole: Any, reach: Any, per_reach: Any) -> Any:
    """How far the middle joint is from the first one along the line to the target, and from that line; of
    the sides' difference (with and without sign), their sum, and the third side of the triangle.
    """
    # four times the area (Heron): exact where the triangle is flat
    area = root(most((whole + reach) * (whole - reach) * (reach + apart) * (reach - apart), broadcast(ZERO)))
    half = broadcast(HALF)
    return (difference * whole * per_reach + reach) * half, area * (half * per_reach)


@inlined
def _bend(hinge: Any, old: Any, new: Any) -> Any:
    """The turn about the hinge from an angle to another; of their cosines and sines."""
    sine, cosine = half_turn(new[0] * old[0] + new[1] * old[1], new[1] * old[0] - new[0] * old[1])
    return hinge[0] * sine, hinge[1] * sine, hinge[2] * sine, cosine


@inlined
def clamp_limb(chains: Any, clamps: Any, number: int, middle: int, scratch: Any) -> Any:
    """Brings the first and the middle joint within their limits; returns the first one's rotation before."""
    first, one, wanted = chains.first[number], broadcast(ONE), load4(scratch, LOCAL)
    store4(scratch, LOCAL, limited(chains, clamps, first, wanted, one, scratch, 0))
    at = middle * JOINT
    bent = limited(chains, clamps, first + middle, load4(scratch, at + LOCAL), one, scratch, at)
    store4(scratch, at + LOCAL, bent)
    note_cuts(chains, number, one, scratch)
    return wanted


@inlined
def _onward(aim: Any, first: Any, upper: Any, lower: Any, whole: Any) -> Any:
    """The unit vector to the target, its distance, and 1 over the distance; for a target at the start,
    the unit vector to the end as it is, for an end at the start, along the first bone, and 0.
    """
    nothing, square = whole * whole * of(NEAREST * NEAREST), vector_square(aim)
    distance = root(square)
    if any_above(nothing, square):
        reached = plus(upper, lower)
        reached = where3_below(vector_square(reached), nothing, upper, reached)
        aim = where3_below(square, nothing, rotated(first, reached), aim)
        return unit(aim), distance, broadcast(ZERO)
    per_distance = broadcast(ONE) / distance
    return scaled(aim, per_distance), distance, per_distance


@inlined
def _sideways(pole: Any, first: Any, upper: Any, onward: Any, upper_square: Any) -> Any:
    """The unit vector at right angles to `onward` on the side of the pole; of the present bend if the pole is
    parallel to `onward`; any if that is parallel too.
    """
    aside = added(pole, onward, -dot(pole, onward))
    square, nothing = vector_square(aside), most(of(STRAIGHT) * vector_square(pole), of(NO_POLE))
    if any_above(nothing, square):
        upper = rotated(first, upper)
        present = added(upper, onward, -dot(upper, onward))
        is_bent = of(STRAIGHT) * upper_square
        present = where3_below(is_bent, vector_square(present), present, perpendicular(onward))
        aside = where3_below(square, nothing, present, aside)
    return unit(aside)


@inlined
def _old_hinge(
    raw: Any, per_lengths: Any, upper: Any, first: Any, new_x: Any, new_hinge: Any, hinge_of_start: Any
) -> Any:
    """The unit axis about which the limb is bent: `hinge_of_start`, if there is one; else along `raw`; for a
    straight limb the axis with which it turns least.
    """
    raw_square = most(vector_square(raw), of(1e-30))
    hinge, square, straight = (
        scaled(raw, per_root(raw_square)),
        raw_square * per_lengths * per_lengths,
        of(STRAIGHT),
    )
    if any_above(straight, square):
        least_turn = between(rotated_back(first, new_x), upper)
        hinge = where3_below(square, straight, rotated(least_turn, rotated_back(first, new_hinge)), hinge)
    given = vector_square(hinge_of_start)
    if any_above(given, broadcast(ZERO)):
        along = unit(upper)
        across = unit(added(hinge_of_start, along, -dot(hinge_of_start, along)))
        hinge = where3_below(broadcast(ZERO), given, across, hinge)
    return hinge
