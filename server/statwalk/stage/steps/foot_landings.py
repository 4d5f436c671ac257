"""Where the motion of an actor's base will next put a foot down."""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.blending import member_phase
from statwalk.maths.reference import called
from statwalk.maths.scalar import sincos
from statwalk.motion.sampling.root_motion import compose, way

LEAVES_S = 0.1
"""seconds before its motion lifts a foot in which it lands no more: it is on its way to the next place"""


@called
def next_landing(
    f: Any, m: Any, s: Any, mem: Any, position: Any, heading: Any, row: int, member: int, foot: int
) -> Any:
    """Returns whether the motion puts the foot down again before it ends, where the middle of the sole is
    then (x, z on the stage), the foot's yaw, and the seconds until then: -1 if it is down already.
    """
    state, time = s.state[row, 0], s.time[row, 0]
    loops = m.states[state, 2] != 0
    best, found, is_down = 2.0, -1, False
    if member >= 0:
        phase = member_phase(m, state, member, time)
        number = member * f.hip.shape[0] + foot
        leaves = LEAVES_S / max(m.durations[state], LEAVES_S)
        for k in range(f.first_span[number], f.first_span[number + 1]):
            down, up = f.span[k, 0], f.span[k, 1]
            last = up - leaves if up != 1.0 else up  # a contact that ends with the clip may go on
            is_down |= down <= phase <= last or down <= phase + 1.0 <= last
            ahead = down - phase
            if loops:
                ahead -= math.floor(ahead)
            if 0.0 <= ahead < best:
                best, found = ahead, k
    if is_down:
        return True, 0.0, 0.0, heading[row], -1.0
    if found < 0:
        return False, 0.0, 0.0, 0.0, 0.0
    duration = m.durations[state]
    if loops and duration > 0.0:
        time -= math.floor(time / duration) * duration
    end, laps = time + best * duration, 0
    if loops and end > duration > 0.0:
        laps = math.floor(end / duration)
        end -= laps * duration
    gone_way = way(m, state, time, min(end, duration), laps, s.smoothed, row, mem.weights)
    x, z, yaw = compose((position[row, 0], position[row, 2], heading[row]), gone_way)
    sine, cosine = sincos(yaw)
    u, v = f.landing[found, 0], f.landing[found, 1]
    x, z = (x + u * cosine + v * sine) / f.unit[0], (z + v * cosine - u * sine) / f.unit[0]
    return True, x, z, yaw + f.landing[found, 2], best * duration
