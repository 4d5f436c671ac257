"""Swings the joints with springs of sixteen actors: part of step 5 of the tick (`springs` explains it)."""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import exp, sincos
from statwalk.maths.simd.lane_functions import least, most, where_below
from statwalk.maths.simd.lane_quat import conjugate, minus, mul, normalized, plus, rotated
from statwalk.maths.simd.lane_vector import cross, dot, length, times, where3_below
from statwalk.maths.simd.lanes import LANES, broadcast, load, store
from statwalk.maths.simd.pose_lanes import ROTATION, SCALE, joint_at, load3, load4, store3, store4
from statwalk.solve.springs import AGE, FARTHEST, KEPT, PLACE, SPEED, SWING, VELOCITY

ZERO, ONE, TINY, SECOND, LIMIT = (np.float32(x) for x in (0, 1, 1e-12, 1.5, FARTHEST))
HALF = np.float32(0.5)
TRAVEL, STATE = 0, 4 * LANES
JOINTS = STATE + KEPT * LANES
"""floats in the scratch: how the actor's frame moved (x, z, sine and cosine of the turn), the numbers that a
spring keeps, then joints
"""
TURN, SIZE, JOINT = 3 * LANES, 7 * LANES, 10 * LANES
"""of a joint in the scratch: place, rotation and scale in model space, and all its floats"""


def spring_scratch(joints: int) -> int:
    """Returns how many float32 `swing_block` needs as scratch for so many joints of `Springs`."""
    return JOINTS + JOINT * joints


@called
def swing_block(
    springs: Any, kept: Any, root_delta: Any, values: Any, first: int, end: int, dt: float, scratch: Any
) -> None:
    """Swings the joints of block 0 of `values` (1, C, 16), the actors in the rows first…end, in place.

    kept (N, K) float64: the memory of solvers, written; root_delta (N, 3): x, z, yaw of this tick.
    """
    for lane in range(LANES):
        x, z, sine, cosine = 0.0, 0.0, 0.0, 1.0
        if first + lane < end:
            x, z = root_delta[first + lane, 0], root_delta[first + lane, 1]
            sine, cosine = sincos(root_delta[first + lane, 2])
        scratch[lane], scratch[LANES + lane] = np.float32(x), np.float32(z)
        scratch[2 * LANES + lane], scratch[3 * LANES + lane] = np.float32(sine), np.float32(cosine)
    for number in range(springs.joint.shape[0]):
        _place_joint(springs, number, values, scratch)
        spring = springs.row[number]
        if spring >= 0:
            _read(kept, springs.column[spring], first, end, scratch)
            _swing_joint(springs, number, spring, values, dt, scratch)
            _write(kept, springs.column[spring], first, end, scratch)


@inlined
def _place_joint(springs: Any, number: int, values: Any, scratch: Any) -> None:
    """Computes a joint's place, rotation and scale in model space; scales are taken as even."""
    at, to = joint_at(values, 0, springs.joint[number]), JOINTS + number * JOINT
    place, turn, size = load3(values, at), load4(values, at + ROTATION), load3(values, at + SCALE)
    if springs.parent[number] >= 0:
        above = JOINTS + springs.parent[number] * JOINT
        scale, rotation = load3(scratch, above + SIZE), load4(scratch, above + TURN)
        place = plus(load3(scratch, above), rotated(rotation, times(scale, place)))
        turn, size = mul(rotation, turn), times(scale, size)
    store3(scratch, to, place)
    store4(scratch, to + TURN, turn)
    store3(scratch, to + SIZE, size)


@inlined
def _read(kept: Any, column: int, first: int, end: int, scratch: Any) -> None:
    for lane in range(LANES):
        for k in range(KEPT):
            value = kept[first + lane, column + k] if first + lane < end else 0.0
            scratch[STATE + k * LANES + lane] = np.float32(value)


@inlined
def _write(kept: Any, column: int, first: int, end: int, scratch: Any) -> None:
    for lane in range(min(LANES, end - first)):
        for k in range(KEPT):
            kept[first + lane, column + k] = scratch[STATE + k * LANES + lane]


@inlined
def _unturned(v: Any, scratch: Any) -> Any:
    """A vector of the actor's frame a tick ago, in its frame now."""
    sine, cosine = load(scratch, 2 * LANES), load(scratch, 3 * LANES)
    return v[0] * cosine - v[2] * sine, v[1], v[2] * cosine + v[0] * sine


@inlined
def _scaled3(v: Any, factor: Any) -> Any:
    return v[0] * factor, v[1] * factor, v[2] * factor


@inlined
def _blended(a: Any, x: Any, b: Any, y: Any) -> Any:
    """a · x + b · y"""
    return a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]


@inlined
def _kept_vector(scratch: Any, part: int) -> Any:
    return load3(scratch, STATE + part * LANES)


@inlined
def _velocities(end: Any, age: Any, dt: float, scratch: Any) -> Any:
    """The velocity of the bone's end in the motion, and its change since the last tick."""
    still, rate = (broadcast(ZERO), broadcast(ZERO), broadcast(ZERO)), broadcast(np.float32(1.0 / dt))
    x, y, z = _kept_vector(scratch, PLACE)
    before = _unturned((x - load(scratch, TRAVEL), y, z - load(scratch, LANES)), scratch)
    velocity = _scaled3(minus(end, before), rate)
    velocity = where3_below(age, broadcast(HALF), still, velocity)
    change = minus(velocity, _unturned(_kept_vector(scratch, VELOCITY), scratch))
    return velocity, where3_below(age, broadcast(SECOND), still, change)


@inlined
def _after(decay: float, swing: float, dt: float) -> Any:
    """The closed form of a step: (a, b, c, d) of e = a e + b e′, e′ = c e + d e′."""
    left = exp(-decay * dt)
    sine, cosine = sincos(swing * dt)
    part = sine / swing if swing > 0 else dt
    return (
        broadcast(np.float32(left * (cosine + decay * part))),
        broadcast(np.float32(left * part)),
        broadcast(np.float32(-left * (decay * decay + swing * swing) * part)),
        broadcast(np.float32(left * (cosine - decay * part))),
    )


@inlined
def _swing_joint(springs: Any, number: int, spring: int, values: Any, dt: float, scratch: Any) -> None:
    """Moves a spring on by `dt` seconds, and turns its joint towards the bone's end."""
    numbers, at = springs.numbers, JOINTS + number * JOINT
    start, turn = load3(scratch, at), load4(scratch, at + TURN)
    own = (
        broadcast(np.float32(numbers[spring, 0])),
        broadcast(np.float32(numbers[spring, 1])),
        broadcast(np.float32(numbers[spring, 2])),
    )
    bone = rotated(turn, times(load3(scratch, at + SIZE), own))
    end, age = plus(start, bone), load(scratch, STATE + AGE * LANES)
    velocity, change = _velocities(end, age, dt, scratch)
    away = _unturned(_kept_vector(scratch, SWING), scratch)
    speed = minus(_unturned(_kept_vector(scratch, SPEED), scratch), change)
    a, b, c, d = _after(numbers[spring, 3], numbers[spring, 4], dt)
    away, speed = _blended(a, away, b, speed), _blended(c, away, d, speed)
    size = length(bone)
    inside = least(broadcast(ONE), broadcast(LIMIT) * size / most(length(away), broadcast(TINY)))
    away, speed = _scaled3(away, inside), _scaled3(speed, inside)
    store3(scratch, STATE + SWING * LANES, away)
    store3(scratch, STATE + SPEED * LANES, speed)
    store3(scratch, STATE + PLACE * LANES, end)
    store3(scratch, STATE + VELOCITY * LANES, velocity)
    store(scratch, STATE + AGE * LANES, where_below(age, broadcast(SECOND), age + broadcast(ONE), age))
    shown = plus(bone, _scaled3(away, broadcast(np.float32(numbers[spring, 5]))))
    x, y, z = cross(bone, shown)
    bend = normalized((x, y, z, dot(bone, shown) + size * length(shown)))
    turned = normalized(mul(bend, turn))
    store4(scratch, at + TURN, turned)
    if springs.parent[number] >= 0:
        above = load4(scratch, JOINTS + springs.parent[number] * JOINT + TURN)
        turned = mul(conjugate(above), turned)
    store4(values, joint_at(values, 0, springs.joint[number]) + ROTATION, turned)
