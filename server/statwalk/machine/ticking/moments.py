"""Markers and windows: what a motion has crossed in a tick, also where it jumped over it or began anew. Seconds into the motion.

A tick goes from `passed` (met in the tick before) to `time`; with `wraps` it goes through the seam of a loop.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.authored.celldefinition import Moment
from statwalk.machine.ticking.advance import NEARLY
from statwalk.maths.arrays import Bools, Floats


def crossed(markers: tuple[tuple[str, float], ...], duration: float, passed: float, time: float, wraps: int) -> tuple[str, ...]:
    """The names of the markers (name, phase) after `passed` up to `time`, in the order of time, each once a tick at most."""
    places = [(name, phase * duration - NEARLY) for name, phase in markers]
    if not wraps:
        return tuple(name for name, place in places if passed < place <= time)
    first = [(name, place) for name, place in places if passed < place]
    again = [one for one in places if one not in first and (wraps > 1 or one[1] <= time)]
    return tuple(name for name, _ in first + again)


def in_window(moment: Moment, duration: float, passed: float, time: float, wraps: int) -> bool:
    """Whether the tick touches the window: it is open now, or the motion has jumped over it."""
    opens, closes = moment.first * duration, moment.last * duration
    reached, before = time >= opens - NEARLY, passed < closes - NEARLY
    if wraps:
        return reached or before or wraps > 1 or opens > closes
    inside = before or time <= closes + NEARLY
    return (reached or inside) if opens > closes else (reached and inside)


def any_crossed(places: Floats, passed: Floats, time: Floats, wraps: NDArray[np.integer[Any]]) -> Bools:
    """(n, K) whether each of K markers at `places` seconds (n, K) was crossed; `passed`, `time` and `wraps` (n, 1)."""
    early = places - NEARLY
    before, after = passed < early, early <= time
    return np.where(wraps > 0, before | after | (wraps > 1), before & after)
