"""Rule 0: motions advance and cross END, markers and windows. Times are seconds into the motion.

A tick leads from `passed` (handled in the tick before) to `time`, across SEAMS seams of a loop.
"""

from __future__ import annotations

import numpy as np

from statwalk.machine.compile.alternatives import AT_END as CELL_AT_END
from statwalk.machine.compile.alternatives import AT_MARKER, MATCH, NOW
from statwalk.machine.compile.program import Program
from statwalk.machine.runtime.effects import MachineEffects, Workspace
from statwalk.machine.runtime.pace import motion_seconds, speed_of
from statwalk.machine.runtime.scratch import AT_END, CARRY, CROSSED, DT, SEAMS
from statwalk.machine.runtime.scratch import OWED as IS_OWED
from statwalk.machine.runtime.state import BEGINNING, ENDED, OWED, RUNNING, MachineState
from statwalk.maths.reference import called, inlined

NEARLY = 1e-6
"""seconds by which a motion may miss its end or a marker: durations are float32 in most files, and sixty
sixtieths hardly ever add up to 1
"""
_ROUNDING = 1e-9
"""share of a lap that rounding may add to a whole number of laps"""


@inlined
def advance(p: Program, s: MachineState, out: MachineEffects, pace: float, i: int, layer: int) -> None:
    """Advances the motion; END comes at the end of a motion and at each wrap of a looping motion.

    `pace`: a factor beside the speed, see `runtime.pace`.
    """
    scratch, clock = out.work.scratch, out.work.clock
    current = s.state[i, layer]
    factor = speed_of(p, s, i, current) * pace
    duration, time = p.duration[current], s.time[i, layer] + clock[DT] * factor
    scratch[IS_OWED], scratch[AT_END], scratch[CROSSED], clock[CARRY] = s.ended[i, layer] == OWED, 0, 1, 0.0
    out.before[i, layer], wraps, seams = s.time[i, layer], 0, seams_carried(s.passed[i, layer], duration)
    if time >= duration - NEARLY:
        left = time - duration
        if p.loop[current]:
            wraps = int(np.floor((time + NEARLY) / duration)) if duration > 0 else 0
            left = max(time - wraps * duration, 0.0) if duration > 0 else 0.0
        clock[CARRY] = max(left, 0.0) / factor if factor > 0 else 0.0
        scratch[AT_END] = p.loop[current] or s.ended[i, layer] != ENDED
        time = left if p.loop[current] else duration
        s.ended[i, layer] = RUNNING if p.loop[current] else ENDED
    s.time[i, layer], out.reached[i, layer], out.wraps[i, layer] = time, time, wraps
    s.passed[i, layer] += seams * duration if seams else 0.0
    scratch[SEAMS] = wraps + seams


@inlined
def seams_carried(passed: float, duration: float) -> int:
    """Returns how many seams of its loop a motion that has just begun crossed with the time left after END,
    see `carry_on`.
    """
    return (
        int(np.ceil((BEGINNING - passed) / duration - _ROUNDING))
        if passed < BEGINNING and duration > 0
        else 0
    )


@inlined
def is_crossed(p: Program, s: MachineState, out: MachineEffects, i: int, layer: int, marker: int) -> bool:
    """Returns whether the motion crossed a marker in this tick; never if the motion began again."""
    scratch = out.work.scratch
    place = p.marker_seconds[marker] - NEARLY
    after, before = s.passed[i, layer] < place, place <= s.time[i, layer]
    if scratch[SEAMS] == 0:
        return bool(scratch[CROSSED] and after and before)
    return bool(scratch[CROSSED] and (after or before or scratch[SEAMS] > 1))


@inlined
def is_before_seam(p: Program, s: MachineState, out: MachineEffects, i: int, layer: int, marker: int) -> bool:
    """Returns whether a crossed marker lies before the seam of the loop; markers before the seam are handled
    first.
    """
    return bool(out.work.scratch[SEAMS] == 0 or s.passed[i, layer] < p.marker_seconds[marker] - NEARLY)


@inlined
def crosses_marker(p: Program, s: MachineState, out: MachineEffects, i: int, layer: int) -> bool:
    """Returns whether the motion crossed a marker that is an event of the table."""
    current = s.state[i, layer]
    for marker in range(p.markers[current], p.markers[current + 1]):
        if p.marker_event[marker] >= 0 and is_crossed(p, s, out, i, layer, marker):
            return True
    return False


@called
def is_its_moment(p: Program, s: MachineState, out: MachineEffects, i: int, layer: int, event: int) -> bool:
    """Returns whether the moment that a cell names has come."""
    current = s.state[i, layer]
    when = p.when[current, event]
    if when == NOW:
        return True
    if when == CELL_AT_END:
        return bool(not out.work.scratch[AT_END] and s.ended[i, layer] == ENDED)
    if when == AT_MARKER:
        for marker in range(p.markers[current], p.markers[current + 1]):
            if p.marker_name[marker] == p.marker[current, event] and is_crossed(p, s, out, i, layer, marker):
                return True
        return False
    return _is_in_window(
        p.opens[current, event],
        p.closes[current, event],
        s.passed[i, layer],
        s.time[i, layer],
        out.work.scratch[SEAMS],
    )


@inlined
def _is_in_window(opens: float, closes: float, passed: float, time: float, seams: int) -> bool:
    reached, before = time >= opens - NEARLY, passed < closes - NEARLY
    if seams:
        return bool(reached or before or seams > 1 or opens > closes)
    inside = before or time <= closes + NEARLY
    return bool((reached or inside) if opens > closes else (reached and inside))


@called
def entry(p: Program, s: MachineState, i: int, layer: int, alternative: int, target: int) -> float:
    """Returns the seconds into the motion of `target` at which an alternative enters it; the end of a loop
    counts as its beginning.
    """
    duration, phase = p.duration[target], p.enter[alternative]
    if phase == 0 or not np.isfinite(duration):
        return 0.0
    if phase == MATCH:
        phase = _matched(p, s, i, layer, target)
    start = phase * duration
    return float(np.fmod(start, duration)) if p.loop[target] and duration > 0 else start


@called
def _matched(p: Program, s: MachineState, i: int, layer: int, target: int) -> float:
    """Returns the phase of the motion of `target` that matches the phase of the present motion, see
    `maths.phases`.
    """
    current = s.state[i, layer]
    whole, warp = p.duration[current], p.warps[current, target]
    phase = s.time[i, layer] / whole if whole > 0 else 0.0
    first, past = p.knots[warp], p.knots[warp + 1]
    same = p.warp_origin[warp, 0] == p.warp_origin[warp, 1]
    for k in range(first, past):
        same = same and p.knot[k, 0] == p.knot[k, 1]
    if not same:
        since = phase - p.warp_origin[warp, 0]
        laps = np.floor(since)
        part, k = since - laps, first
        while k + 2 < past and p.knot[k + 1, 0] <= part:
            k += 1
        share = (part - p.knot[k, 0]) / (p.knot[k + 1, 0] - p.knot[k, 0])
        phase = p.warp_origin[warp, 1] + laps + (p.knot[k, 1] + (p.knot[k + 1, 1] - p.knot[k, 1]) * share)
    return phase - np.floor(phase) if p.warp_loop[warp] else phase


@called
def carry_on(p: Program, s: MachineState, w: Workspace, i: int, layer: int) -> None:
    """Advances a motion that was entered at END by the time left in the tick: at the pace of its blend where
    it stays in its lap, else at its speed alone. Markers on the way are handled in the next tick.
    """
    current, entered, left = s.state[i, layer], s.time[i, layer], w.clock[CARRY]
    time, duration = entered + left * speed_of(p, s, i, current), p.duration[current]
    paced = entered + motion_seconds(p, s, w.weights, i, current, entered, left)
    if not p.loop[current]:
        s.time[i, layer] = min(paced, duration)
    elif max(time, paced) < duration:
        s.time[i, layer] = paced
    else:
        s.time[i, layer] = np.fmod(time, duration) if duration > 0 else 0.0
        s.passed[i, layer] -= time - s.time[i, layer] if duration > 0 and time >= duration else 0.0


@inlined
def begin_motion(s: MachineState, w: Workspace, i: int, layer: int, start: float) -> None:
    """Begins the motion of the actor's state `start` seconds after its beginning; END, markers and seams of
    the old motion are cleared.
    """
    s.time[i, layer], s.passed[i, layer], s.ended[i, layer] = start, start + BEGINNING, RUNNING
    w.scratch[AT_END], w.scratch[CROSSED], w.scratch[SEAMS] = 0, 0, 0
