"""Figures: what is measured, in which unit, and the worst and the mean of it over the trials of a cell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Floats
from statwalk.stage.measure.measured_ground import Spot

UNITS: Mapping[str, str] = {
    "jump": "×",
    "joint": "×",
    "slide": "m",
    "sink": "m",
    "hover": "m",
    "knee": "m",
    "hand": "m/s²",
    "visible": "s",
    "half": "s",
    "arrived": "s",
}
"""the figures: jump of the body and of a joint relative to the motions themselves; slide of a sole in a
contact; skin below the floor; height of all soles while the motion stands; knee behind its leg; acceleration
of a hand; seconds from the event to the first visible motion, half way, and arrival
"""


def unit(name: str) -> str:
    """Returns the unit in which people read a figure: millimetres where UNITS has metres."""
    return "mm" if UNITS[name] == "m" else UNITS[name]


def number(name: str, value: float) -> str:
    """Returns a figure in its `unit`, without the unit: `826`, `1.20`, `never`."""
    if not np.isfinite(value):
        return "never" if UNITS[name] == "s" else "–"
    if UNITS[name] == "m":
        return f"{value * 1000:.0f}"
    return f"{value:.{0 if UNITS[name] == 'm/s²' else 2}f}"


def worded(name: str, value: float) -> str:
    """Returns a figure with its unit, for people: `826 mm`, `1.20 ×`."""
    return f"{number(name, value)} {unit(name)}" if np.isfinite(value) else number(name, value)


class Figure(NamedTuple):
    """One figure of a cell or a motion."""

    mean: float
    """over the phases, without interruptions"""
    worst: float
    phase: float
    """the phase of the old motion at which it is worst"""
    joint: str = ""
    """the joint of the worst, where it is about one"""
    then: str = ""
    """the event that interrupted the worst; empty: none"""
    ticks: int = 0
    """after which it came"""
    place: Spot = Spot()
    """where the trial began that was the worst"""


@dataclass(frozen=True)
class Played:
    """The figures of the trials of a cell, (N,) each; `joints` (N,) of `joint`; `phase`, `then`, `ticks`,
    `places` (N,) say how each was played.
    """

    values: Mapping[str, Floats]
    joints: Sequence[str]
    phase: Sequence[float]
    then: Sequence[str]
    ticks: Sequence[int]
    places: Sequence[Spot]

    def append(self, others: Played) -> Played:
        """Returns these trials followed by others; figures that the others lack are NaN."""
        lost = np.full(len(others.phase), np.nan)
        return Played(
            {
                name: np.concatenate([values, others.values.get(name, lost)])
                for name, values in self.values.items()
            },
            [*self.joints, *others.joints],
            [*self.phase, *others.phase],
            [*self.then, *others.then],
            [*self.ticks, *others.ticks],
            [*self.places, *others.places],
        )

    def figures(self) -> dict[str, Figure]:
        """Returns the worst and the mean of every figure that is finite in any trial."""
        return {name: self._figure(name, values) for name, values in self.values.items() if len(values)}

    def _figure(self, name: str, values: Floats) -> Figure:
        row = int(np.nanargmax(values)) if not np.isnan(values).all() else 0
        plain = values[[not then for then in self.then]]
        return Figure(
            float(np.nanmean(plain)) if len(plain) and not np.isnan(plain).all() else float("nan"),
            float(values[row]),
            float(self.phase[row]),
            self.joints[row] if name == "joint" else "",
            self.then[row],
            self.ticks[row],
            self.places[row],
        )
