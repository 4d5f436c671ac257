"""The machine as run: full integer tables, one below the other for all layers, and all that cells, states and senses say beside them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.authored.celldefinition import ActionDefinition, Moment
from statwalk.machine.authored.definition import BlendDefinition
from statwalk.machine.built.runparts import BLANK, MIXED, OFF, UNDEFINED, Collider, Key, Layer, Outcome, Parameter, Sense, Touch


@dataclass(frozen=True, eq=False)
class Machine:
    """The machine as run; S states (those of the base, then those of each layer), L layers, E events of which END is the last. Seconds."""

    name: str
    states: tuple[str, ...]
    """names as in their layer"""
    events: tuple[str, ...]
    layers: tuple[Layer, ...]
    """the base first"""
    layer_of: NDArray[np.int16]
    """(S,) the layer of each state"""
    layer_concerns: NDArray[np.bool_]
    """(L, E) which layers an event goes to: those whose tables say anything about it, else the base alone"""
    initials: tuple[int, ...]
    """the state that each layer begins in"""
    target: NDArray[np.int16]
    """(S, E) the next state, or BLANK, OFF, UNDEFINED, MIXED"""
    when: NDArray[np.uint8]
    """(S, E) NOW, AT_END, AT_MARKER or IN_WINDOW"""
    restart: NDArray[np.bool_]
    """(S, E); this and the next four: of the first outcome, where there are several"""
    blend: NDArray[np.float32]
    """(S, E)"""
    curve: NDArray[np.uint8]
    """(S, E) row of CURVES"""
    enter: NDArray[np.float32]
    """(S, E) phase 0…1 at which the new motion begins, or MATCH"""
    action: NDArray[np.int16]
    """(S, E) row of `actions`, -1 none"""
    moments: Mapping[tuple[int, int], Moment]
    """the marker or window where `when` names one"""
    outcomes: Mapping[tuple[int, int], tuple[Outcome, ...]]
    """for every cell that is neither blank nor off, all that it can lead to; the first that is true counts, or one is drawn by weight"""
    sources: Mapping[tuple[int, int], tuple[str, str]]
    """where each cell stands in the file: row and column as written"""
    buffer: NDArray[np.float32]
    """(E,) how long an event waits in a blank cell"""
    motion: NDArray[np.int16]
    """(S,) row of `motions`: of a blend the first clip; -1 where a layer's state has none"""
    blends: tuple[BlendDefinition | None, ...]
    """(S,) the blend of clips that a state plays, if it plays one"""
    loop: NDArray[np.bool_]
    """(S,)"""
    duration: NDArray[np.float64]
    """(S,) of a blend the longest clip's; infinite where there is no motion"""
    markers: tuple[tuple[tuple[str, float], ...], ...]
    """(S,) name and phase 0…1 of each marker, by phase; those of a blend are its first clip's"""
    speed: NDArray[np.float64]
    """(S,) factor of time, where speed_parameter is -1"""
    speed_parameter: NDArray[np.int16]
    """(S,) row of `parameters` that gives the factor, -1 none"""
    idle: int
    """the event that stands for nobody touching anything, -1 none"""
    fallbacks: tuple[int, ...]
    """for each layer, the state of an actor whose own is gone after an edit"""
    actions: tuple[ActionDefinition, ...]
    motions: tuple[str, ...]
    keys: Mapping[str, Key]
    parameters: tuple[Parameter, ...]
    variables: tuple[str, ...]
    """the names that conditions may ask for: the parameters, then those of MEASURED that are none"""
    senses: tuple[Sense, ...]
    touches: tuple[Touch, ...]
    colliders: tuple[Collider, ...]
    histories: tuple[tuple[str, str], ...]
    """layer and name of the outer states that are resumed where they were left"""
    inside: NDArray[np.bool_]
    """(S, H) which states are part of each of them"""
    undefined: Mapping[tuple[int, int], str]
    """what the table names where the target is UNDEFINED"""

    @property
    def initial(self) -> int:
        """The state that the base begins in."""
        return self.initials[0]

    @property
    def end(self) -> int:
        """The column of END."""
        return len(self.events) - 1

    @property
    def alternatives(self) -> dict[tuple[int, int], tuple[Outcome, ...]]:
        """The cells with several outcomes (MIXED)."""
        return {place: several for place, several in self.outcomes.items() if self.target[place] == MIXED}

    def rows(self, layer: int) -> range:
        """The rows of a layer's states."""
        found = np.flatnonzero(self.layer_of == layer)
        return range(int(found[0]), int(found[-1]) + 1)

    @cached_property
    def end_matters(self) -> NDArray[np.bool_]:
        """(S,) whether END, or the idle event in its place, finds a cell with something to do."""
        at_end = self.target[:, self.end]
        idle = self.target[:, self.idle] if self.idle >= 0 else np.full(len(self.states), OFF)
        idle_acts = (idle >= 0) | (idle == MIXED)
        return np.asarray((at_end >= 0) | (at_end == UNDEFINED) | (at_end == MIXED) | ((at_end == BLANK) & idle_acts))

    @cached_property
    def targets(self) -> list[list[int]]:
        """`target` as Python numbers, for looking up one cell."""
        found: list[list[int]] = self.target.tolist()
        return found

    @cached_property
    def columns(self) -> dict[str, int]:
        """Events by their names; END is not among them."""
        return {name: column for column, name in enumerate(self.events[:-1])}

    @cached_property
    def received(self) -> NDArray[np.bool_]:
        """(E, L) which layers an input goes to: those that its event concerns, else the base."""
        found = self.layer_concerns.T.copy()
        found[self.end] = False
        found[:, 0] |= ~found.any(axis=1)
        return found

    @cached_property
    def receivers(self) -> list[list[bool]]:
        """(L, E) the same as Python values."""
        receivers: list[list[bool]] = self.received.T.tolist()
        return receivers

    @cached_property
    def marker_seconds(self) -> NDArray[np.float64]:
        """(S, K) where the markers of each motion stand, seconds; infinite in place of those that it has not."""
        return seconds_of(self.markers, self.duration)

    @cached_property
    def heard(self) -> NDArray[np.float64]:
        """(S, K) the same for markers with a cell that says what they mean."""
        says = [
            {name for name, column in self.columns.items() if self.target[row, column] not in (BLANK, OFF)}
            for row in range(len(self.states))
        ]
        return seconds_of(
            [[one for one in markers if one[0] in said] for markers, said in zip(self.markers, says, strict=True)], self.duration
        )

    @cached_property
    def windows(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """(S, E) each: the seconds at which the window of a cell opens and closes; infinite where there is no motion, or no window."""
        opens, closes = np.full(self.when.shape, np.inf), np.full(self.when.shape, np.inf)
        for place, moment in self.moments.items():
            if np.isfinite(self.duration[place[0]]):
                opens[place], closes[place] = moment.first * self.duration[place[0]], moment.last * self.duration[place[0]]
        return opens, closes

    @cached_property
    def whens(self) -> list[list[int]]:
        """`when` as Python numbers."""
        found: list[list[int]] = self.when.tolist()
        return found


def seconds_of(markers: Sequence[Sequence[tuple[str, float]]], duration: NDArray[np.float64]) -> NDArray[np.float64]:
    """(S, K) the seconds at which the markers (name, phase) of each motion stand, filled up with infinity."""
    found = np.full((len(markers), max(map(len, markers), default=0)), np.inf)
    for row, several in enumerate(markers):
        found[row, : len(several)] = [phase * duration[row] for _, phase in several]
    return found
