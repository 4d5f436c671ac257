"""The steps of the tick that work on poses, each for one block of sixteen actors; `tick` calls them in order.

`p` Program, `m` MotionTables, `t` PoseTables, `s` MachineState, `o` PoseOffsets, `mem` PoseMemory, `done`
MachineEffects of the tick.
"""

from __future__ import annotations

from typing import Any

from statwalk.machine.runtime.effects import CHANGE_CURVE, CHANGE_FROM, OF_CHANGES
from statwalk.machine.runtime.pace import motion_seconds
from statwalk.machine.runtime.state import BEGINNING, MOST_WAITING
from statwalk.machine.runtime.timing import seams_carried
from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.scalar import modulo
from statwalk.maths.simd.hashing import hash_row, hash_span
from statwalk.maths.simd.lanes import load, store
from statwalk.maths.simd.pose_layout import end_row, first_row, index_at
from statwalk.motion.layer_lanes import additive_block, override_block
from statwalk.motion.sampling.root_motion import compose, way
from statwalk.motion.sampling.sample import sample_block
from statwalk.solve.contract_lanes import contract_lanes
from statwalk.solve.express import express

NONE = -1.0
"""seconds of a transition: none begins"""
QUINTIC = 1
"""row of CURVES"""


@inlined
def time_in(p: Any, state: int, time: float) -> Any:
    """Returns the seconds into a state's motion: wrapped if it loops."""
    return modulo(time, p.duration[state]) if p.loop[state] != 0 and p.duration[state] > 0.0 else time


@inlined
def note_transitions(t: Any, s: Any, done: Any, mem: Any) -> None:
    """Writes for each actor and layer the transition that the last change of its state begins; a layer that
    shows no motion begins none.
    """
    for row in range(mem.seconds.shape[0]):
        for layer in range(mem.seconds.shape[1]):
            mem.seconds[row, layer] = NONE
    for number in range(done.counts[OF_CHANGES]):
        row, layer = done.changes[number, 0], done.changes[number, 1]
        shows = layer == 0 or t.plays[done.changes[number, CHANGE_FROM]] or t.plays[s.state[row, layer]]
        mem.seconds[row, layer] = done.blend[number] if shows else NONE
        mem.quintic[row, layer] = done.changes[number, CHANGE_CURVE] == QUINTIC


@called
def sample_layers(
    m: Any, t: Any, s: Any, masks: Any, mem: Any, states: Any, times: Any, out: Any, block: int
) -> None:
    """Puts the local poses of a block's motions of `states` (N, L) at `times` (N, L), upper layers over lower
    layers, into block 0 of `out`.
    """
    first = first_row(block)
    count = end_row(block, s.state.shape[0]) - first
    sample_block(m, states, times, 0, False, s.smoothed, first, count, mem.weights, mem.rows, out, 0)
    _express_motions(t.expressions, states, times, 0, s.smoothed, mem, out, block)
    for layer in range(1, states.shape[1]):
        lies_over = False
        for row in range(first, first + count):
            parameter = t.weight_parameter[layer]
            weight = s.smoothed[row, parameter] if parameter >= 0 else t.weight[layer]
            mem.layer_weight[row, layer] = min(max(weight, 0.0), 1.0) if t.plays[states[row, layer]] else 0.0
            lies_over |= mem.layer_weight[row, layer] > 0.0
        if lies_over:
            sample_block(
                m, states, times, layer, False, s.smoothed, first, count, mem.weights, mem.rows, mem.over, 0
            )
            _express_motions(t.expressions, states, times, layer, s.smoothed, mem, mem.over, block)
            if t.is_additive[layer]:  # relative to the motion's first pose; expressions: to the pose at rest
                sample_block(
                    m,
                    states,
                    times,
                    layer,
                    True,
                    s.smoothed,
                    first,
                    count,
                    mem.weights,
                    mem.rows,
                    mem.first,
                    0,
                )
                additive_block(out, mem.over, mem.first, 0, mem.layer_weight, masks, layer, block)
            else:
                override_block(out, mem.over, 0, mem.layer_weight, masks, layer, block)


@called
def _express_motions(
    x: Any, states: Any, times: Any, layer: int, smoothed: Any, mem: Any, out: Any, block: int
) -> None:
    """Sets, in block 0 of `out`, the channels of the motions that are driven by expressions."""
    if x.first_assignment.shape[0] == 2:  # no state has an expression
        return
    first = first_row(block)
    for row in range(first, end_row(block, states.shape[0])):
        group = x.group[states[row, layer]]
        if group > 0:
            values, stack = mem.express_values, mem.express_stack
            time = times[row, layer]
            express(x, group, smoothed, row, 0.0, time, values, stack, out, 0, row - first)


@called
def express_block(x: Any, smoothed: Any, ahead: float, mem: Any, out: Any, block: int) -> None:
    """Runs the machine's expressions on the poses of a block's actors, in block 0 of `out`, as they are
    `ahead` ticks after this one; then the muscles follow their contractions.
    """
    first, frame = first_row(block), mem.clock[0] + ahead
    if x.first_assignment[1] > 0:
        for row in range(first, end_row(block, smoothed.shape[0])):
            values, stack = mem.express_values, mem.express_stack
            express(x, 0, smoothed, row, frame, frame * mem.clock[1], values, stack, out, 0, row - first)
    contract_lanes(x, out, 0)


@called
def look_ahead(p: Any, s: Any, mem: Any, block: int, dt: float) -> None:
    """Writes the time of each motion of a block in `dt` seconds, if no event happens."""
    for row in range(first_row(block), end_row(block, s.state.shape[0])):
        for layer in range(s.state.shape[1]):
            state, time = s.state[row, layer], s.time[row, layer]
            ahead = motion_seconds(p, s, mem.weights, row, state, time, dt)
            mem.ahead[row, layer] = time_in(p, state, time + ahead)


@called
def root_motion(p: Any, m: Any, s: Any, mem: Any, done: Any, row: int) -> Any:
    """Returns the root motion of an actor's base layer in a tick, x, z (metres), yaw (radians): the rest of
    the old motion, then the new motion if one began.
    """
    reached, wraps = done.reached[row, 0], done.wraps[row, 0]
    has_changed = mem.seconds[row, 0] >= 0.0
    entered, after = s.passed[row, 0] - BEGINNING, s.time[row, 0]
    if (
        has_changed and wraps > 0 and after > entered
    ):  # a loop was left at its END; the new motion got the rest of the tick
        reached, wraps = p.duration[mem.old_state[row, 0]], wraps - 1
    delta = way(m, mem.old_state[row, 0], done.before[row, 0], reached, wraps, s.smoothed, row, mem.weights)
    if has_changed:
        laps = seams_carried(s.passed[row, 0], p.duration[s.state[row, 0]])
        entered += laps * p.duration[s.state[row, 0]] if laps > 0 else 0.0
        delta = compose(delta, way(m, s.state[row, 0], entered, after, laps, s.smoothed, row, mem.weights))
    return delta


@inlined
def move_root(position: Any, heading: Any, root_delta: Any, row: int) -> None:
    """Moves an actor by the root motion of this tick."""
    place, delta = (
        (position[row, 0], position[row, 2], heading[row]),
        (root_delta[row, 0], root_delta[row, 1], root_delta[row, 2]),
    )
    position[row, 0], position[row, 2], heading[row] = compose(place, delta)


@called
def hash_actor(
    word: Any, s: Any, o: Any, position: Any, heading: Any, root_delta: Any, solver_memory: Any, row: int
) -> Any:
    """Returns the hash after hashing an actor's rows, without poses; of the queue only the places in use
    count.
    """
    layers = s.state.shape[1]
    word = hash_row(hash_row(word, s.state, row), s.age, row)
    word = hash_row(hash_row(hash_row(word, s.time, row), s.passed, row), s.ended, row)
    for layer in range(layers):
        first, count = (row * layers + layer) * MOST_WAITING, s.waiting[row, layer]
        word = hash_span(hash_span(word, s.waiting_event, first, count), s.waiting_for, first, count)
        word = hash_span(hash_span(word, s.waiting_until, first, count), s.waiting_held, first, count)
        word = hash_span(word, s.waiting_other, first, count)
    word = hash_row(hash_row(hash_row(word, s.waiting, row), s.held, row), s.stayed, row)
    word = hash_row(hash_row(hash_row(word, s.parameters, row), s.smoothed, row), s.smoothed_rate, row)
    word = hash_row(hash_row(hash_row(word, s.sensing, row), s.last, row), s.goal, row)
    word = hash_row(hash_row(hash_row(word, position, row), heading, row), root_delta, row)
    word = hash_row(word, solver_memory, row)
    return hash_row(
        hash_row(hash_row(hash_row(word, o.elapsed, row), o.duration, row), o.quintic, row),
        o.old_root_delta,
        row,
    )


@inlined
def keep_block(coming: Any, out: Any, block: int) -> None:
    """Copies the poses of block 0 of `coming` into a block of a buffer."""
    for channel in range(out.shape[1]):
        store(out, index_at(out, block, channel), load(coming, index_at(coming, 0, channel)))
