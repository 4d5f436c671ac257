"""Blends of clips of one actor, in float64, compiled: the weight and phase of each clip, and the pace.

`motions` are BlendTables, or other tables with the same columns; `parameters` (N, P) of all actors.
`motion/blend_space.py` explains the method.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called

ROUNDS = 32
"""rounds of the search for the length of a step at most; the secant method is exact once both points lie
between the same two markers, three rounds are usual
"""


@called
def weigh(motions: Any, state: int, parameters: Any, actor: int, weights: Any) -> None:
    """Writes the weights of a state's members into `weights`; they sum to 1."""
    first, count = motions.states[state, 0], motions.states[state, 1]
    x = parameters[actor, motions.states[state, 3]]
    x = min(max(x, motions.bounds[state, 0]), motions.bounds[state, 1])
    if motions.states[state, 4] < 0:
        _weigh_line(motions, first, count, x, weights)
    else:
        y = parameters[actor, motions.states[state, 4]]
        _weigh_plane(
            motions, first, count, x, min(max(y, motions.bounds[state, 2]), motions.bounds[state, 3]), weights
        )


@inlined
def _weigh_line(motions: Any, first: int, count: int, x: float, weights: Any) -> None:
    """Linear between the neighbours of `x`."""
    passed, start, end = 0, 0.0, 0.0
    for k in range(first, first + count):
        passed += motions.places[k, 0] <= x
    row = min(max(passed - 1, 0), count - 2)
    for k in range(first, first + count):
        if motions.members[k, 3] == row:
            start = motions.places[k, 0]
        elif motions.members[k, 3] == row + 1:
            end = motions.places[k, 0]
    part = (x - start) / (end - start)
    for k in range(count):
        rank = motions.members[first + k, 3]
        weights[k] = 1.0 - part if rank == row else part if rank == row + 1 else 0.0


@inlined
def _weigh_plane(motions: Any, first: int, count: int, x: float, y: float, weights: Any) -> None:
    """Gradient bands (Johansen 2009, section 6.3)."""
    total = 0.0
    for member in range(count):
        weight = 2.0
        for other in range(count):
            if other != member:
                weight = min(weight, _band(motions, first + member, first + other, x, y))
        weights[member] = weight
        total += weight
    for member in range(count):
        weights[member] = weights[member] / total


@inlined
def _band(motions: Any, here: int, other: int, x: float, y: float) -> Any:
    """1…0 from the position of member `here` to the position of member `other`."""
    across, along = (
        motions.places[other, 0] - motions.places[here, 0],
        motions.places[other, 1] - motions.places[here, 1],
    )
    done = ((x - motions.places[here, 0]) * across + (y - motions.places[here, 1]) * along) / (
        across * across + along * along
    )
    return 1.0 - min(max(done, 0.0), 1.0)


@inlined
def phase_of(motions: Any, state: int, time: float) -> Any:
    """Returns the phase of a state's first clip."""
    return time / motions.durations[state] if motions.durations[state] > 0 else 0.0


@inlined
def lifted(motions: Any, member: int, phase: float) -> Any:
    """Returns a member's phase for a phase of the first member, with whole laps."""
    first, count = motions.members[member, 1], motions.members[member, 2]
    if count == 0:
        return phase
    since = phase - motions.places[member, 3]
    laps = np.floor(since)
    part = since - laps
    row = first
    while row < first + count - 2 and motions.knots[row + 1, 0] <= part:
        row += 1
    old, new = motions.knots[row, 0], motions.knots[row, 1]
    way = new + (motions.knots[row + 1, 1] - new) * ((part - old) / (motions.knots[row + 1, 0] - old))
    return motions.places[member, 4] + laps + way


@inlined
def member_phase(motions: Any, state: int, member: int, time: float) -> Any:
    """Returns the phase 0…1 of a member when its state is at `time` seconds."""
    phase = lifted(motions, member, phase_of(motions, state, time))
    return phase - np.floor(phase) if motions.states[state, 2] else phase


@inlined
def _mean_phase(motions: Any, state: int, phase: float, weights: Any) -> Any:
    """The weighted mean of the members' phases, with whole laps."""
    first, total = motions.states[state, 0], 0.0
    for k in range(motions.states[state, 1]):
        total += weights[k] * lifted(motions, first + k, phase)
    return total


@inlined
def _step_of(motions: Any, state: int, phase: float, wanted: float, weights: Any) -> Any:
    """How far the phase of the first member goes while the mean of the members' phases goes `wanted`."""
    begin = _mean_phase(motions, state, phase, weights)
    step, before, gone_before = wanted, 0.0, 0.0
    short, far = 0.0, np.inf
    for _ in range(ROUNDS):
        gone = _mean_phase(motions, state, phase + step, weights) - begin
        if abs(gone - wanted) <= 0.0 or abs(gone - gone_before) <= 0.0:
            break
        short, far = (max(short, step), far) if gone < wanted else (short, min(far, step))
        following = step + (wanted - gone) * ((step - before) / (gone - gone_before))
        if not short <= following <= far:  # a marker bends the way so much that the secant leaves it
            following = 0.5 * (short + far) if far < np.inf else 2.0 * step
        before, gone_before, step = step, gone, following
    return step


@called
def rate(
    motions: Any, state: int, time: float, seconds: float, parameters: Any, actor: int, weights: Any
) -> Any:
    """Returns the factor of time of an actor's motion for the next `seconds`; `weights` is memory as for
    `sample`.

    A lap takes the weighted mean of the clips' durations. Within a lap the pace follows the weighted mean of
    the clips' phases, so that a single clip keeps its own pace.
    """
    if state < 0 or motions.states[state, 1] < 2:
        return 1.0
    weigh(motions, state, parameters, actor, weights)
    first, count, lap, straight = motions.states[state, 0], motions.states[state, 1], 0.0, True
    for k in range(count):
        lap += weights[k] * motions.places[first + k, 2]
        straight = straight and motions.members[first + k, 2] == 0
    factor = motions.durations[state] / lap if lap > 0 else 1.0
    if straight:
        return factor
    phase, wanted = phase_of(motions, state, time), seconds / lap if lap > 0 else seconds
    step = _step_of(motions, state, phase, wanted, weights)
    return factor * (step / wanted) if wanted > 0 else factor
