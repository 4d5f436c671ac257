"""Analytic two-bone inverse kinematics: hip, knee, ankle; shoulder, elbow, wrist (IK15)."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, least, most, root, size, where_below
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, rotated, scaled, vector_square
from statwalk.maths.simd.lane_turns import between, between_frames
from statwalk.maths.simd.lane_vector import added, cross, dot, length, perpendicular, unit, where3_below
from statwalk.maths.simd.lanes import broadcast
from statwalk.maths.simd.pose_lanes import load3, load4, store4
from statwalk.solve.chain_lanes import JOINT, LOCAL, POINT, TURN, place_joints, softened
from statwalk.solve.iterate import limited, note_cuts

ZERO, ONE, HALF = np.float32(0), np.float32(1), np.float32(0.5)
STRAIGHT = 1.2e-7
"""the squared sine of the largest angle that counts as zero"""
NEAREST = 1e-5
"""the least distance from start to end, as a part of the length of both bones"""


@inlined
def solve_two_bone(
    scratch: Any, count: int, middle: int, target: Any, pole: Any, hinge_of_start: Any, softening: Any
) -> Any:
    """Turns the first and the middle joint so that the last of `count` joints comes to the target; returns
    the softened target.

    `pole` is the direction in which the middle joint bends; zero: as it bends now. For a target out of
    reach the limb is straight and points at it; for a target that is too near it is folded. A knee keeps the
    axis about which it is bent now, or bends about `hinge_of_start` in the frame of the first joint if that
    is not zero; then a knee that is bent backwards is bent forwards again.
    """
    place_joints(scratch, count, LOCAL)
    at = middle * JOINT
    start, mid = load3(scratch, POINT), load3(scratch, at + POINT)
    end = load3(scratch, (count - 1) * JOINT + POINT)
    upper, lower = minus(mid, start), minus(end, mid)
    smallest = of(1e-12)
    upper_length, lower_length = most(length(upper), smallest), most(length(lower), smallest)
    whole = upper_length + lower_length
    target = softened(target, start, whole, softening)
    aim = minus(target, start)
    onward = _onward(aim, minus(end, start), upper, whole)
    sideways = _sideways(pole, upper, onward, upper_length)

    distance = length(aim)
    apart = size(upper_length - lower_length)
    reach = least(most(most(distance, apart), whole * of(NEAREST)), whole)
    # twice the area of the triangle (Heron): exact where it is flat
    area = root(most((whole + reach) * (whole - reach) * (reach + apart) * (reach - apart), broadcast(ZERO)))
    area = area * broadcast(HALF)
    per_reach = broadcast(ONE) / reach
    along = ((upper_length - lower_length) * whole * per_reach + reach) * broadcast(HALF)
    new_x = scaled(added(scaled(onward, along), sideways, area * per_reach), broadcast(ONE) / upper_length)

    hinge = cross(upper, lower)
    new_hinge = cross(sideways, onward)
    per_lengths = broadcast(ONE) / (upper_length * lower_length)
    old_x = scaled(upper, broadcast(ONE) / upper_length)
    raw, hinge_length = hinge, root(most(vector_square(hinge), of(1e-30)))
    bent = hinge_length * per_lengths
    hinge = _old_hinge(scaled(hinge, broadcast(ONE) / hinge_length), bent, old_x, new_x, new_hinge)
    if any_above(vector_square(hinge_of_start), broadcast(ZERO)):
        given = rotated(load4(scratch, LOCAL), hinge_of_start)
        given = unit(added(given, old_x, -dot(given, old_x)))
        hinge = where3_below(broadcast(ZERO), vector_square(hinge_of_start), given, hinge)
    old_cosine, old_sine = dot(upper, lower) * per_lengths, dot(raw, hinge) * per_lengths
    new_cosine = (reach * reach - upper_length * upper_length - lower_length * lower_length) * (
        broadcast(HALF) * per_lengths
    )
    new_sine = area * per_lengths
    bend = _half_turn(
        new_cosine * old_cosine + new_sine * old_sine, new_sine * old_cosine - new_cosine * old_sine
    )

    store4(scratch, LOCAL, mul(between_frames(old_x, hinge, new_x, new_hinge), load4(scratch, LOCAL)))
    axis = rotated(conjugate(load4(scratch, at + TURN)), hinge)
    turn = axis[0] * bend[0], axis[1] * bend[0], axis[2] * bend[0], bend[1]
    store4(scratch, at + LOCAL, mul(turn, load4(scratch, at + LOCAL)))
    return target


@inlined
def clamp_limb(chains: Any, clamps: Any, number: int, middle: int, scratch: Any) -> None:
    """Brings the first and the middle joint within their limits."""
    first = chains.first[number]
    store4(scratch, LOCAL, limited(chains, clamps, first, load4(scratch, LOCAL), scratch, 0))
    at = middle * JOINT
    bent = limited(chains, clamps, first + middle, load4(scratch, at + LOCAL), scratch, at)
    store4(scratch, at + LOCAL, bent)
    note_cuts(chains, clamps, number, broadcast(ONE), scratch)


@inlined
def _onward(aim: Any, reached: Any, upper: Any, whole: Any) -> Any:
    """The unit vector to the target; for a target at the start, to the end as it is; for an end at the start,
    along the first bone.
    """
    nothing = whole * whole * of(NEAREST * NEAREST)
    reached = where3_below(vector_square(reached), nothing, upper, reached)
    return unit(where3_below(vector_square(aim), nothing, reached, aim))


@inlined
def _sideways(pole: Any, upper: Any, onward: Any, upper_length: Any) -> Any:
    """The unit vector at right angles to `onward` on the side of the pole; of the present bend if the pole is
    parallel to `onward`; any if that is parallel too.
    """
    aside = added(pole, onward, -dot(pole, onward))
    present = added(upper, onward, -dot(upper, onward))
    is_bent = of(STRAIGHT) * upper_length * upper_length
    if any_above(is_bent, vector_square(present)):
        present = where3_below(is_bent, vector_square(present), present, perpendicular(onward))
    return unit(where3_below(of(STRAIGHT) * vector_square(pole), vector_square(aside), aside, present))


@inlined
def _old_hinge(axis: Any, sine: Any, old_x: Any, new_x: Any, new_hinge: Any) -> Any:
    """The unit axis about which the limb is bent; for a straight limb the axis with which it turns least."""
    square, straight = sine * sine, of(STRAIGHT)
    if any_above(straight, square):
        axis = where3_below(square, straight, rotated(between(new_x, old_x), new_hinge), axis)
    return axis


@inlined
def _half_turn(cosine: Any, sine: Any) -> Any:
    """Sine and cosine of half the angle."""
    zero, one = broadcast(ZERO), broadcast(ONE)
    half_sine = where_below(cosine, zero, one - cosine, sine)
    half_cosine = where_below(cosine, zero, sine, one + cosine)
    factor = one / root(half_sine * half_sine + half_cosine * half_cosine)
    return half_sine * factor, half_cosine * factor
