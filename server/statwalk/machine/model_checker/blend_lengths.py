"""How long a blend of clips takes from phase to phase, at the most and at the least: what parameters may set,
and what a state keeps from its entry, lies between bounds.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise, product

import numpy as np
from numba import types

from statwalk.machine.compile.link import landings
from statwalk.machine.compile.machine import Machine
from statwalk.machine.conditions.variables import ENTRY
from statwalk.maths.arrays import Floats
from statwalk.maths.blend_tables import BLENDS, BlendedClip, BlendTables
from statwalk.maths.blending import weigh
from statwalk.maths.compiling import LONG, kernel, read, write

Pick = Callable[[Sequence[float]], float]
"""`max` or `min`"""
Moments = tuple[tuple[float, float], ...]
"""phases of a motion from 0 to 1, and the seconds that have gone by then at speed 1"""


@kernel(BLENDS, LONG, read(types.float64, 2), write(types.float64, 1))
def _weigh(blends: BlendTables, state: int, parameters: Floats, weights: Floats) -> None:
    weigh(blends, state, parameters, 0, weights)


def blend_moments(machine: Machine, state: int, pick: Pick, as_set: bool) -> Moments:
    """Returns the moments of a state that plays a blend, no sooner (`min`) or no later (`max`) than they are.

    `as_set`: with the parameters' defaults, as nobody sets others; else whatever is set, and when.
    """
    clips = machine.blended_clips[state]
    durations, mixes = np.array([clip.duration for clip in clips]), _mixes(machine, state, as_set)
    phases = _breaks(clips)
    lifted = np.stack([clip.phases.lift(phases) for clip in clips])
    if _is_constant(machine, state, as_set):
        ways = (lifted - lifted[:, :1]).T
        seconds = [_extreme(pick, durations, way, mixes) for way in ways]
    else:
        parts = [_extreme(pick, durations, way, mixes) for way in np.diff(lifted).T]
        seconds = [0.0, *np.cumsum(parts).tolist()]
    return tuple(zip(phases.tolist(), seconds, strict=True))


def _breaks(clips: Sequence[BlendedClip]) -> Floats:
    """The phases of the first clip between which all clips keep their share of its pace."""
    inner = [
        (clip.phases.origin[0] + clip.phases.here[1:-1]) % 1.0
        for clip in clips
        if not clip.phases.is_identity
    ]
    cuts = [clip.phases.origin[0] % 1.0 for clip in clips if not clip.phases.is_identity]
    return np.unique(np.concatenate([[0.0, 1.0], cuts, *inner]))


def _mixes(machine: Machine, state: int, as_set: bool) -> Floats | None:
    """(W, K) weights of the clips, such that what can be lies on the line from each to the next; None where
    it may be any mixture.
    """
    blend, blends = machine.blends[state], machine.program.blends
    assert blend is not None
    bounds, columns = blends.bounds[state].reshape(2, 2), [machine.axis(state, name) for name in blend.over]
    spans = [
        np.clip(_span(machine, name, as_set), *bounds[axis]).tolist() for axis, name in enumerate(blend.over)
    ]
    places = [{low, high} for low, high in spans]
    if len(places) == 1:
        places[0] |= {place for (place,) in blend.clips.values() if spans[0][0] < place < spans[0][1]}
    elif any(len(one) > 1 for one in places):
        return None
    mixes = []
    for point in product(*map(sorted, places)):
        parameters, weights = np.zeros((1, len(machine.axes))), np.zeros(blends.most_members)
        parameters[0, columns] = point
        _weigh(blends, state, parameters, weights)
        mixes.append(weights[: len(blend.clips)])
    return np.array(mixes)


def _span(machine: Machine, name: str, as_set: bool) -> tuple[float, float]:
    """The least and the most that a blend's parameter, or its value from an entry, can be."""
    if name in ENTRY:
        least = 0.0 if name in ("entry speed", "entry phase", "entry time") else -np.inf
        return least, 1.0 if name == "entry phase" else np.inf
    parameter = next(one for one in machine.parameters if one.name == name)
    return (parameter.default,) * 2 if as_set else (parameter.minimum, parameter.maximum)


def _is_constant(machine: Machine, state: int, as_set: bool) -> bool:
    """Whether the mixture stays the same from the motion's beginning on, where it is always entered."""
    blend = machine.blends[state]
    assert blend is not None
    for name in blend.over:
        low, high = _span(machine, name, as_set)
        if name not in ENTRY and low < high:
            return False
    return not any(
        alternative.enter != 0 and state in landings(machine, alternative)
        for alternatives in machine.alternatives.values()
        for alternative in alternatives
    )


def _extreme(pick: Pick, durations: Floats, way: Floats, mixes: Floats | None) -> float:
    """The seconds for a way, given for each clip as a share of its lap: the mean of the durations times the
    mean of the ways.
    """
    if mixes is None:
        return pick(durations.tolist()) * pick(way.tolist())
    laps, ways = mixes @ durations, mixes @ way
    found = (laps * ways).tolist()
    for (lap, gone), (lap_on, gone_on) in pairwise(zip(laps.tolist(), ways.tolist(), strict=True)):
        bend = 2.0 * (lap_on - lap) * (gone_on - gone)
        at = -((lap_on - lap) * gone + (gone_on - gone) * lap) / bend if bend else 0.0
        if 0.0 < at < 1.0:
            found.append((lap + (lap_on - lap) * at) * (gone + (gone_on - gone) * at))
    return pick(found)
