"""Matches the phases of two motions: when a foot of the walk is down, it should be down in the run that is
blended with it.

Motions are matched at their sync markers, pairs (name, phase 0…1). Between common markers phases correspond
linearly, round the circle; for motions that do not loop the ends correspond as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths.arrays import Floats, floats
from statwalk.maths.columns import lock_fields

Marks = Sequence[tuple[str, float]]


@dataclass(frozen=True, eq=False)
class Warp:
    """Maps the phases of one motion to the phases of another: linear between the knots, counted from a common
    marker.
    """

    origin: tuple[float, float]
    """phases of the marker at which both circles are cut open"""
    here: Floats
    """(K,) knots 0…1 from the origin on, rising, in the old motion"""
    there: Floats
    """(K,) the same knots in the new motion"""

    def __post_init__(self) -> None:
        lock_fields(self)

    @property
    def is_identity(self) -> bool:
        """Returns whether phases stay the same."""
        return self.origin[0] == self.origin[1] and bool((self.here == self.there).all())

    def lift(self, phase: ArrayLike) -> Floats:
        """Returns the new motion's phases for `phase` (…) with whole laps: each lap adds a lap."""
        phases = floats(phase).astype(np.float64)
        if self.is_identity:
            return phases
        since = phases - self.origin[0]
        laps = np.floor(since)
        part = since - laps
        row = (self.here.searchsorted(part, "right") - 1).clip(0, len(self.here) - 2)
        first, length = self.here[row], self.here[row + 1] - self.here[row]
        beyond = self.there[row] + (self.there[row + 1] - self.there[row]) * ((part - first) / length)
        lifted: Floats = self.origin[1] + laps + beyond
        return lifted


def warp(old_marks: Marks, new_marks: Marks, loop: bool = True) -> Warp:
    """Returns the warp from the phases of a motion with `old_marks` to the phases of a motion with
    `new_marks`.

    Markers correspond by name, and by their order if a name is repeated. Without a common name, and at the
    ends of motions that do not `loop`, phases are the same.
    """
    pairs = _pairs(old_marks, new_marks)
    origin = pairs[0] if pairs and loop else (0.0, 0.0)
    knots = [(0.0, 0.0)]
    for old, new in sorted(((old - origin[0]) % 1, (new - origin[1]) % 1) for old, new in pairs):
        if knots[-1][0] < old < 1 and knots[-1][1] < new < 1:  # the others would go backwards
            knots.append((old, new))
    here, there = np.array([*knots, (1.0, 1.0)], np.float64).T
    return Warp(origin, here, there)


def match(old_marks: Marks, new_marks: Marks, phase: ArrayLike, loop: bool = True) -> Floats:
    """Returns the phases (…) 0…1 of a motion with `new_marks` that correspond to `phase` (…) of a motion with
    `old_marks`.
    """
    lifted = warp(old_marks, new_marks, loop).lift(phase)
    return lifted - np.floor(lifted) if loop else lifted


def _pairs(old_marks: Marks, new_marks: Marks) -> list[tuple[float, float]]:
    """(old, new) phases of corresponding markers; the first pair is the origin for counting
    repeated names.
    """
    old, new = _by_name(old_marks), _by_name(new_marks)
    common = sorted(
        (name for name in old if name in new),
        key=lambda name: (len(old[name]) > 1 or len(new[name]) > 1, old[name][0], name),
    )
    if not common:
        return []
    origin = old[common[0]][0], new[common[0]][0]
    pairs = [origin]
    for name in common:
        ours = sorted((phase - origin[0]) % 1 for phase in old[name])
        theirs = sorted((phase - origin[1]) % 1 for phase in new[name])
        pairs += [
            (origin[0] + old_phase, origin[1] + new_phase)
            for old_phase, new_phase in zip(ours, theirs, strict=False)
        ]
    return list(dict.fromkeys((old_phase % 1, new_phase % 1) for old_phase, new_phase in pairs))


def _by_name(marks: Marks) -> dict[str, list[float]]:
    """The phases of each name, rising."""
    phases: dict[str, list[float]] = {}
    for name, phase in sorted(marks, key=lambda mark: mark[1]):
        phases.setdefault(name, []).append(float(phase))
    return phases
