"""Phases of motions that are in step: where one foot of a walk is down, so it should be in the run that is blended with it.

Motions are matched at their sync markers, pairs (name, phase 0…1). Between the markers that both have phases correspond in a
straight line, round the circle; of a motion that does not loop the ends correspond as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from statwalk.maths.arrays import Floats, floats

Marks = Sequence[tuple[str, float]]


@dataclass(frozen=True, eq=False)
class Warp:
    """From the phases of one motion to those of another: straight between the knots, counted from a common mark."""

    origin: tuple[float, float]
    """phases of the mark where both circles are cut open"""
    here: Floats
    """(K,) 0…1 from there, rising"""
    there: Floats
    """(K,) the same of the other motion"""

    @property
    def is_identity(self) -> bool:
        """Whether phases stay what they are."""
        return self.origin[0] == self.origin[1] and bool((self.here == self.there).all())

    def lift(self, phase: ArrayLike) -> Floats:
        """The other motion's phases for `phase` (…) with whole laps: a lap more for a lap more."""
        given = floats(phase).astype(np.float64)
        if self.is_identity:
            return given
        since = given - self.origin[0]
        laps = np.floor(since)
        part = since - laps
        row = (self.here.searchsorted(part, "right") - 1).clip(0, len(self.here) - 2)
        first, length = self.here[row], self.here[row + 1] - self.here[row]
        way = self.there[row] + (self.there[row + 1] - self.there[row]) * ((part - first) / length)
        lifted: Floats = self.origin[1] + laps + way
        return lifted


def warp(old_marks: Marks, new_marks: Marks, loop: bool = True) -> Warp:
    """How the phases of a motion with `old_marks` correspond to those of one with `new_marks`.

    Marks belong together by name, and by their order where a name is repeated. Without a common name, and of motions that do not
    `loop` at their ends, phases are the same.
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
    """The phases (…) 0…1 of a motion with `new_marks` that correspond to `phase` (…) of one with `old_marks`."""
    lifted = warp(old_marks, new_marks, loop).lift(phase)
    return lifted - np.floor(lifted) if loop else lifted


def _pairs(old_marks: Marks, new_marks: Marks) -> list[tuple[float, float]]:
    """(old, new) phases of the marks that belong together, the first one where the counting of repeated names begins."""
    old, new = _by_name(old_marks), _by_name(new_marks)
    common = sorted((name for name in old if name in new), key=lambda name: (len(old[name]) > 1 or len(new[name]) > 1, old[name][0], name))
    if not common:
        return []
    origin = old[common[0]][0], new[common[0]][0]
    pairs = [origin]
    for name in common:
        ours = sorted((phase - origin[0]) % 1 for phase in old[name])
        theirs = sorted((phase - origin[1]) % 1 for phase in new[name])
        pairs += [(origin[0] + one, origin[1] + other) for one, other in zip(ours, theirs, strict=False)]
    return list(dict.fromkeys((one % 1, other % 1) for one, other in pairs))


def _by_name(marks: Marks) -> dict[str, list[float]]:
    """The phases of each name, rising."""
    found: dict[str, list[float]] = {}
    for name, phase in sorted(marks, key=lambda mark: mark[1]):
        found.setdefault(name, []).append(float(phase))
    return found
