"""Lets the chains of sixteen actors hang: the last part of step 8 of the tick (`hanging` explains it).

`h` HangingTables; `r` ReachTables; `keep` the solvers' memory; `scratch` of the solvers of chains; `work` at
least `hanging_scratch(joints)` float32.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import exp, sincos
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import any_above, least, most, where_below
from statwalk.maths.simd.lane_quat import conjugate, minus, plus, rotated, scaled
from statwalk.maths.simd.lane_vector import added, length
from statwalk.maths.simd.lanes import LANES, broadcast, load, spread, store
from statwalk.maths.simd.pose_lanes import ROTATION, either3, joint_at, load3, load4, store3, store4
from statwalk.solve.chain_lanes import (
    AIM,
    JOINT,
    LOCAL,
    OFFSET,
    POINT,
    base_frame,
    chain_length,
    place_joints,
    read_chain,
)
from statwalk.solve.fabrik import fixed, pull_back, pull_forth, turn_to_points
from statwalk.solve.hanging import FREE, LINK, NEW, OF_CHAIN, OF_JOINT, OLD, SINCE
from statwalk.solve.iterate import note_cuts
from statwalk.solve.reach_tables import WEIGHT
from statwalk.solve.rods import fit_rods
from statwalk.solve.solve_block import keep_notes

ZERO, ONE = np.float32(0), np.float32(1)
LINKS = 4 * LANES
"""floats at the head of `work`, before the joints: the frame's move (x, z, sine and cosine of the turn)"""
FASTEST = 50.0
"""lengths of the chain a second: no joint is faster"""
PULLS = 8
"""most passes that bring the end to where it is held"""


@called
def hang_block(
    h: Any, r: Any, chains: Any, clamps: Any, keep: Any, root_delta: Any, coming: Any, values: Any,
    block: int, first: int, end: int, dt: float, scratch: Any, work: Any,
) -> None:  # fmt: skip
    """Turns the joints of the hanging chains of the actors in the rows first…end.

    coming (1, C, 16): their poses before step 8; values (B, C, 16): their poses, in which anchors are where
    they stay; root_delta (N, 3): x, z, yaw of this tick.
    """
    for lane in range(LANES):
        x, z, sine, cosine = 0.0, 0.0, 0.0, 1.0
        if first + lane < end:
            x, z = root_delta[first + lane, 0], root_delta[first + lane, 1]
            sine, cosine = sincos(root_delta[first + lane, 2])
        work[lane], work[LANES + lane] = np.float32(x), np.float32(z)
        work[2 * LANES + lane], work[3 * LANES + lane] = np.float32(sine), np.float32(cosine)
    for k in range(h.chain.shape[0]):
        number = h.chain[k]
        count = chains.first[number + 1] - chains.first[number]
        position, rotation, scale = base_frame(chains, number, values, block)
        read_chain(chains, number, values, block, scale, scratch)
        last = place_joints(scratch, count, LOCAL)
        whole = chain_length(scratch, count)
        _read(h, k, keep, count, first, end, position, rotation, scratch, work)
        _free(h, k, r, keep, count, first, end, work)
        _fall(h, k, count, dt, position, rotation, scratch, work)
        fit_rods(count, LINKS, scratch, work)
        _turn(h, k, chains, clamps, number, rotation, last, coming, scratch, work)
        away = _write(h, k, chains, number, values, block, rotation, last, scratch)
        keep_notes(chains, number, block, broadcast(ONE), scratch, keep)
        _keep(h, k, keep, count, first, end, dt, plus(position, away), rotation, whole, scratch, work)


@inlined
def _unturned(v: Any, work: Any) -> Any:
    """A vector of the actor's frame a tick ago, in its frame now."""
    sine, cosine = load(work, 2 * LANES), load(work, 3 * LANES)
    return v[0] * cosine - v[2] * sine, v[1], v[2] * cosine + v[0] * sine


@inlined
def _read(
    h: Any, k: int, keep: Any, count: int, first: int, end: int, position: Any, rotation: Any, scratch: Any,
    work: Any,
) -> None:  # fmt: skip
    """Writes where the joints were to OLD, and their velocities to NEW; in lanes where the chain does not
    hang yet, where they are in the pose.
    """
    column, half = h.memory[k], broadcast(np.float32(0.5))
    for lane in range(LANES):
        since = keep[first + lane, column + SINCE] if first + lane < end else 0.0
        work[LINKS + FREE + lane] = np.float32(since)
    since = load(work, LINKS + FREE)
    for place in range(count):
        at = LINKS + place * LINK
        for lane in range(LANES):
            for axis in range(3):
                old, speed = 0.0, 0.0
                if first + lane < end:
                    from_here = column + OF_CHAIN + place * OF_JOINT + axis
                    old, speed = keep[first + lane, from_here], keep[first + lane, from_here + 3]
                work[at + OLD + axis * LANES + lane] = np.float32(old)
                work[at + NEW + axis * LANES + lane] = np.float32(speed)
        x, y, z = load3(work, at + OLD)
        old = _unturned((x - load(work, 0), y, z - load(work, LANES)), work)
        here = plus(position, rotated(rotation, load3(scratch, place * JOINT + POINT)))
        store3(work, at + OLD, _where(since, half, here, old))
        store3(work, at + NEW, _unturned(load3(work, at + NEW), work))


@inlined
def _where(a: Any, b: Any, x: Any, y: Any) -> Any:
    return where_below(a, b, x[0], y[0]), where_below(a, b, x[1], y[1]), where_below(a, b, x[2], y[2])


@inlined
def _free(h: Any, k: int, r: Any, keep: Any, count: int, first: int, end: int, work: Any) -> None:
    """Writes the inverses of the masses: 0 for anchors, and for the last joint while a solver holds it."""
    for place in range(count):
        store(work, LINKS + place * LINK + FREE, broadcast(ONE))
    if h.holds[k, 0]:
        store(work, LINKS + FREE, broadcast(ZERO))
    for lane in range(LANES):
        free = 0.0 if h.holds[k, 1] else 1.0 / h.numbers[k, 2]
        for number in range(h.first_holder[k], h.first_holder[k + 1]):
            if first + lane < end and keep[first + lane, r.memory[h.holder[number]] + WEIGHT] > 0.0:
                free = 0.0
        work[LINKS + (count - 1) * LINK + FREE + lane] = np.float32(free)


@inlined
def _fall(
    h: Any, k: int, count: int, dt: float, position: Any, rotation: Any, scratch: Any, work: Any
) -> None:
    """Moves the joints by their velocities and by gravity, anchors to their places in the pose."""
    left, down = of(exp(-h.numbers[k, 1] * dt)), of(-h.numbers[k, 0] * dt)
    for place in range(count):
        at = LINKS + place * LINK
        x, y, z = scaled(load3(work, at + NEW), left)
        fallen = added(load3(work, at + OLD), (x, y + down, z), of(dt))
        here = plus(position, rotated(rotation, load3(scratch, place * JOINT + POINT)))
        store3(work, at + NEW, either3(load(work, at + FREE), fallen, here))


@inlined
def _turn(
    h: Any, k: int, chains: Any, clamps: Any, number: int, rotation: Any, last: Any,
    coming: Any, scratch: Any, work: Any,
) -> None:  # fmt: skip
    """Turns the joints of the poses before step 8 so that the bones lie along the rods; brings an end that is
    held to its place exactly.
    """
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    zero, one, to_base = broadcast(ZERO), broadcast(ONE), conjugate(rotation)
    start, offset = load3(work, LINKS + NEW), load3(scratch, OFFSET)
    for place in range(count):
        way = minus(load3(work, LINKS + place * LINK + NEW), start)
        store3(scratch, place * JOINT + AIM, plus(offset, rotated(to_base, way)))
        where = joint_at(coming, 0, chains.joint[first + place])
        store4(scratch, place * JOINT + LOCAL, load4(coming, where + ROTATION))
    store3(scratch, POINT, offset)
    goal, tolerance = last, spread(chains.tolerance, number)
    end, drawn = pull_forth(scratch, count, one, True, fixed(load3(scratch, JOINT + AIM)))
    missed = length(minus(goal, end))
    held = where_below(zero, load(work, LINKS + (count - 1) * LINK + FREE), zero, one)
    if not h.holds[k, 0]:
        held = zero  # the root gives way
    held = where_below(tolerance, missed, held, zero)
    for _ in range(PULLS):
        if not any_above(held, zero):
            break
        end, drawn = pull_forth(scratch, count, held, False, pull_back(scratch, count, goal, drawn))
        missed = length(minus(goal, end))
        held = where_below(tolerance, missed, held, zero)
    turn_to_points(chains, clamps, number, POINT, scratch)
    note_cuts(chains, number, one, scratch)


@inlined
def _write(
    h: Any, k: int, chains: Any, number: int, values: Any, block: int, rotation: Any, last: Any, scratch: Any
) -> Any:
    """Writes the rotations into the pose; returns how far the root moves so that the last joint stays, if it
    alone is the anchor.
    """
    first, count = chains.first[number], chains.first[number + 1] - chains.first[number]
    zero = broadcast(ZERO)
    for place in range(count - 1):
        if chains.sensitivity[first + place] > ZERO:
            where = joint_at(values, block, chains.joint[first + place])
            store4(values, where + ROTATION, load4(scratch, place * JOINT + LOCAL))
    away = (zero, zero, zero)
    if not h.holds[k, 0]:
        away = rotated(rotation, minus(last, load3(scratch, (count - 1) * JOINT + POINT)))
        top = joint_at(values, block, chains.top[number])
        store3(values, top, plus(load3(values, top), away))
    return away


@inlined
def _keep(
    h: Any, k: int, keep: Any, count: int, first: int, end: int, dt: float, position: Any, rotation: Any,
    whole: Any, scratch: Any, work: Any,
) -> None:  # fmt: skip
    """Keeps places and velocities of the joints as they are in the pose now."""
    column, fastest = h.memory[k], whole * of(FASTEST)
    for place in range(count):
        at = LINKS + place * LINK
        here = plus(position, rotated(rotation, load3(scratch, place * JOINT + POINT)))
        velocity = scaled(minus(here, load3(work, at + OLD)), of(1.0 / dt))
        slower = least(broadcast(ONE), fastest / most(length(velocity), of(1e-12)))
        store3(work, at + OLD, here)
        store3(work, at + NEW, scaled(velocity, slower))
        for lane in range(min(LANES, end - first)):
            for axis in range(3):
                to = column + OF_CHAIN + place * OF_JOINT + axis
                keep[first + lane, to] = work[at + OLD + axis * LANES + lane]
                keep[first + lane, to + 3] = work[at + NEW + axis * LANES + lane]
    for row in range(first, end):
        keep[row, column + SINCE] = 1.0
