"""Samples poses of motions, compiled: one actor as a packed row, or sixteen actors side by side in a block of
a PoseBuffer.

`motions` are MotionTables. An actor's pose depends on its own state, time and parameters alone: every lane
gives the same bits.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.blending import member_phase, weigh
from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_functions import fused, turned
from statwalk.maths.simd.lanes import LANES, broadcast, load, store
from statwalk.maths.simd.pose_lanes import load4, store4
from statwalk.maths.simd.pose_layout import index_at
from statwalk.maths.simd.transpose import store_columns
from statwalk.motion.keys.segment_kinds import (
    ARC,
    CUBIC,
    CUBIC_TURN,
    HOLD,
    LINE,
    LOOSE,
    OWN_CLOCKS,
    RATIONAL,
    SPLINE_TURN,
    VECTORS,
)
from statwalk.motion.sampling.edges import edges_before
from statwalk.motion.sampling.segment_lanes import (
    arc,
    cubic,
    cubic_turn,
    fraction,
    line,
    put_some,
    rational,
    rational_turn,
    spline_turn,
    unit,
)


@inlined
def _evaluate(motions: Any, group: int, values: Any, row: int, part: Any, out: Any, to: int) -> None:
    """Evaluates sixteen lanes of a row of a group at the fraction `part` of their segments."""
    kind, mask = motions.groups[group, 0], motions.groups[group, 4]
    if kind == LINE:
        store(out, to, line(values, row, part))
    elif kind == HOLD:
        store(out, to, load(values, row))
    elif kind == CUBIC:
        store(out, to, cubic(values, row, part, LANES))
    elif kind == RATIONAL:
        store(out, to, rational(values, row, part))
    else:
        if kind == ARC:
            rotation = arc(values, row, part)
        elif kind == CUBIC_TURN:
            rotation = cubic_turn(values, row, part)
        elif kind == SPLINE_TURN:
            rotation = spline_turn(values, row, part)
        else:
            rotation = rational_turn(values, row, part)
        if mask < 0:
            store4(out, to, rotation)
        else:
            put_some(out, to, rotation, load(motions.values, mask))


@inlined
def _seconds_since(motions: Any, search: int, edge: int, time: float) -> Any:
    """Seconds since the last of `edge` edges, and the fraction to the next edge; 0 before the first and after
    the last edge.
    """
    if not 0 < edge < motions.searches[search, 1]:
        return 0.0, 0.0
    last = motions.searches[search, 0] + edge - 1
    since = time - motions.edges[last]
    return since, since * motions.paces[last]


@inlined
def _gather(motions: Any, group: int, time: float, out: Any, at: int) -> None:
    """Puts the rows of unrelated lanes side by side: their fractions, then the numbers to evaluate."""
    vectors = VECTORS[motions.groups[group, 0]]
    for lane in range(LANES):
        search = motions.groups[group, 1] + lane
        edge = edges_before(motions, search, time)
        out[at + lane] = np.float32(_seconds_since(motions, search, edge, time)[1])
        row = motions.searches[search, 4] + edge * vectors
        for k in range(vectors):
            out[at + LANES * (k + 1) + lane] = motions.values[row + k]


@inlined
def _sample_group(
    motions: Any, group: int, edge: int, time: float, since: Any, part: Any, out: Any, at: int, spare: int
) -> None:
    """Writes sixteen channels of a clip, `since` seconds and the fraction `part` after an edge, into the
    packed row at `at`.
    """
    row, to, clock = motions.groups[group, 1], at + motions.groups[group, 3], motions.groups[group, 5]
    if clock == LOOSE:
        _gather(motions, group, time, out, spare)
        _evaluate(motions, group, out, spare + LANES, load(out, spare), out, to)
        return
    row += edge * motions.groups[group, 2]
    if clock == OWN_CLOCKS:
        part = fraction(motions.values, row, since)
        row += 2 * LANES
    _evaluate(motions, group, motions.values, row, part, out, to)


@called
def _sample_clip(motions: Any, clip: int, time: float, out: Any, at: int, spare: int) -> None:
    """Writes a clip at `time` seconds as a packed row at `at`; memory at `spare` is overwritten."""
    width = motions.base.shape[1]
    if not motions.clips[clip, 2]:
        for number in range(0, width, LANES):
            store(out, at + number, load(motions.base, clip * width + number))
    for search in range(motions.clips[clip, 0], motions.clips[clip, 1]):
        edge = edges_before(motions, search, time)
        since, part = _seconds_since(motions, search, edge, time)
        seconds, whole = broadcast(np.float32(since)), broadcast(np.float32(part))
        for group in range(motions.searches[search, 4], motions.searches[search, 5]):
            _sample_group(motions, group, edge, time, seconds, whole, out, at, spare)


@inlined
def _add_weighted(motions: Any, weight: float, row: int, out: Any, at: int) -> None:
    """Adds the packed row at `row` times its weight to the row at `at`; rotations are aligned with the sum so
    far.
    """
    part, turns, width = broadcast(np.float32(weight)), motions.layout[0], motions.layout[1]
    for number in range(0, turns, 4 * LANES):
        a, b = at + number, row + number
        x, y, z, w = load4(out, a)
        u, v, t, s = load4(out, b)
        side = turned(part, fused(w, s, fused(z, t, fused(y, v, x * u))))
        store4(out, a, (fused(u, side, x), fused(v, side, y), fused(t, side, z), fused(s, side, w)))
    for number in range(turns, width, LANES):
        store(out, at + number, fused(load(out, row + number), part, load(out, at + number)))


@inlined
def _clear(motions: Any, out: Any, at: int) -> None:
    for number in range(0, motions.layout[1], LANES):
        store(out, at + number, broadcast(np.float32(0)))


@inlined
def _straighten(motions: Any, out: Any, at: int) -> None:
    """Normalises the rotations of a packed row."""
    for number in range(at, at + motions.layout[0], 4 * LANES):
        x, y, z, w = load4(out, number)
        store4(out, number, unit(x, y, z, w))


@inlined
def sample(
    motions: Any,
    state: int,
    time: float,
    start: bool,
    parameters: Any,
    actor: int,
    weights: Any,
    out: Any,
    at: int,
    spare: int,
) -> None:
    """Writes the local pose of one actor in a state as the packed row at `at` of `out`; a row at `spare` is
    overwritten, and after it the numbers that `_gather` puts side by side.

    `start`: the pose at the start of the motion, whatever the time. A state without motion (or -1) gives the
    rest pose. `parameters` (N, P) float64 of all actors, `weights` float64 memory for as many numbers as a
    blend space has members.
    """
    first, count = 0, 0
    if state >= 0:
        first, count = motions.states[state, 0], motions.states[state, 1]
    if count > 1:
        weigh(motions, state, parameters, actor, weights)
        _clear(motions, out, at)
    for k in range(max(count, 1)):
        if count > 1 and weights[k] == 0:
            continue
        clip, seconds = 0, 0.0
        if count > 0:
            clip = motions.members[first + k, 0]
            if not start:
                seconds = (
                    time
                    if count == 1
                    else member_phase(motions, state, first + k, time) * motions.places[first + k, 2]
                )
        _sample_clip(motions, clip, seconds, out, spare if count > 1 else at, spare + motions.layout[1])
        if count > 1:
            _add_weighted(motions, weights[k], spare, out, at)
    if count > 1:
        _straighten(motions, out, at)


@inlined
def _put_block(motions: Any, rows: Any, out: Any, block: int) -> None:
    """Writes sixteen packed rows, one after the other, as block `block` of a PoseBuffer's values
    (B, C, 16).
    """
    width, base = motions.layout[1], index_at(out, block, 0)
    for number in range(0, width, LANES):
        store_columns(out, base, motions.layout, 2 + number, rows, number, width)
    for number in range(motions.common.shape[0]):
        store(out, base + motions.common[number], broadcast(motions.common_values[number]))


@called
def sample_block(
    motions: Any, states: Any, times: Any, layer: int, start: bool, parameters: Any,
    first: int, count: int, weights: Any, rows: Any, out: Any, block: int,
) -> None:  # fmt: skip
    """Writes the local poses of actors first…first + count (at most 16) as block `block` of a PoseBuffer's
    values; other lanes hold the rest pose.

    states, times (N, L) and the `layer` to sample; `rows` float32 memory of `MotionTables.memory` numbers;
    `sample` explains the other arguments.
    """
    width = motions.layout[1]
    for lane in range(LANES):
        state, time, actor = -1, 0.0, first
        if lane < count:
            actor = first + lane
            state, time = states[actor, layer], times[actor, layer]
        sample(motions, state, time, start, parameters, actor, weights, rows, lane * width, LANES * width)
    _put_block(motions, rows, out, block)
