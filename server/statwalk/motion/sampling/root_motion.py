"""The root motion of one actor, in float64, compiled; `motion.root` explains it.

`motions` are MotionTables. Root motion is x, z (metres), yaw (radians).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.blending import lifted, phase_of, weigh
from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.motion.sampling.edges import edges_before


@inlined
def compose(place: Any, way: Any) -> Any:
    """Returns the place after root motion `way`, given in the frame of `place`."""
    sine, cosine = sincos(place[2])
    x, z, yaw = way
    return place[0] + (x * cosine + z * sine), place[1] + (z * cosine - x * sine), place[2] + yaw


@inlined
def relative(origin: Any, place: Any) -> Any:
    """Returns `place` in the frame of `origin`."""
    sine, cosine = sincos(origin[2])
    x, z = place[0] - origin[0], place[1] - origin[1]
    return x * cosine - z * sine, z * cosine + x * sine, place[2] - origin[2]


@inlined
def _row_of(motions: Any, row: int) -> Any:
    """One place of a root track."""
    return motions.ways[row, 0], motions.ways[row, 1], motions.ways[row, 2]


@inlined
def _place_at(motions: Any, root: int, time: float) -> Any:
    """The place of a root track at `time` seconds; the ends hold."""
    search, first = motions.roots[root, 0], motions.roots[root, 1]
    count, edge = motions.searches[search, 1], motions.searches[search, 0]
    key = min(max(edges_before(motions, search, time) - 1, 0), count - 2)
    start, end = motions.edges[edge + key], motions.edges[edge + key + 1]
    part = min(max((time - start) / (end - start), 0.0), 1.0)
    a, b, c = _row_of(motions, first + key)
    x, z, yaw = _row_of(motions, first + key + 1)
    return a + (x - a) * part, b + (z - b) * part, c + (yaw - c) * part


@inlined
def _displacement(motions: Any, root: int, start: float, end: float, wraps: int) -> Any:
    """The root motion along a track from `start` to `end` seconds through `wraps` repeats."""
    search, row = motions.roots[root, 0], motions.roots[root, 1]
    if search < 0:
        return 0.0, 0.0, 0.0
    now, first = _place_at(motions, root, end), _row_of(motions, row)
    last = _row_of(motions, row + motions.searches[search, 1] - 1)
    way = relative(_place_at(motions, root, start), last if wraps > 0 else now)
    for done in range(1, wraps + 1):
        way = compose(way, relative(first, now if done == wraps else last))
    return way


@inlined
def _member_way(motions: Any, state: int, member: int, begin: float, reached: float) -> Any:
    """The root motion of one clip between phases of the first clip, with whole laps."""
    root, duration = motions.members[member, 4], motions.places[member, 2]
    start, end = lifted(motions, member, begin), lifted(motions, member, reached)
    first, last = 0.0, 0.0
    if motions.states[state, 2]:
        first, last = np.floor(start), np.floor(end)
    return _displacement(
        motions, root, (start - first) * duration, (end - last) * duration, int(last - first)
    )


@called
def way(
    motions: Any, state: int, start: float, end: float, wraps: int, parameters: Any, actor: int, weights: Any
) -> Any:
    """Returns x, z, yaw of an actor's root motion from `start` to `end` seconds through `wraps` repeats, in
    its frame at `start`.

    `parameters` (N, P) and the memory `weights` as for `sample`.
    """
    first, count = 0, 0
    if state >= 0:
        first, count = motions.states[state, 0], motions.states[state, 1]
    if count == 0:
        return 0.0, 0.0, 0.0
    if count == 1:
        return _displacement(motions, motions.members[first, 4], start, end, wraps)
    weigh(motions, state, parameters, actor, weights)
    begin, reached = phase_of(motions, state, start), phase_of(motions, state, end) + wraps
    x, z, yaw = 0.0, 0.0, 0.0
    for k in range(count):
        if weights[k] > 0:
            u, v, turn = _member_way(motions, state, first + k, begin, reached)
            x, z, yaw = x + u * weights[k], z + v * weights[k], yaw + turn * weights[k]
    return x, z, yaw
