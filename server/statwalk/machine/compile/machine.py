"""The compiled machine: full integer tables of all layers, the base first, and the data of cells, states and
senses beside them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.alternatives import (
    BLANK,
    MIXED,
    OFF,
    UNDEFINED,
    Alternative,
    Collider,
    Key,
    Layer,
    Parameter,
    Sense,
    Touch,
)
from statwalk.machine.compile.program import Program, ProgramText
from statwalk.machine.conditions.variables import ENTRY
from statwalk.machine.definition.cell_definition import ActionDefinition, CellTiming
from statwalk.machine.definition.machine_definition import BlendDefinition
from statwalk.maths.blend_tables import BlendedClip


@dataclass(frozen=True, eq=False)
class Machine:
    """The compiled machine: S states (the states of the base, then of each layer), L layers, E events of
    which END is the last. Seconds.
    """

    name: str
    states: tuple[str, ...]
    """names as in their layer's table"""
    events: tuple[str, ...]
    layers: tuple[Layer, ...]
    """the base first"""
    layer_of: NDArray[np.int16]
    """(S,) the layer of each state"""
    layer_concerns: NDArray[np.bool_]
    """(L, E) the layers whose tables have a cell for an event; an event that no table has goes to the base
    alone
    """
    initials: tuple[int, ...]
    """the state that each layer begins in"""
    target: NDArray[np.int16]
    """(S, E) the next state, or BLANK, OFF, UNDEFINED, MIXED"""
    when: NDArray[np.uint8]
    """(S, E) NOW, AT_END, AT_MARKER or IN_WINDOW"""
    timings: Mapping[tuple[int, int], CellTiming]
    """the marker or window of each cell whose `when` is AT_MARKER or IN_WINDOW"""
    alternatives: Mapping[tuple[int, int], tuple[Alternative, ...]]
    """the alternatives, often only one, of every cell that is neither blank nor off: the first true one
    counts, or one is drawn by weight
    """
    sources: Mapping[tuple[int, int], tuple[str, str]]
    """the row and column of the file in which each cell is written"""
    buffer: NDArray[np.float32]
    """(E,) seconds that an event waits in a blank cell"""
    motion: NDArray[np.int16]
    """(S,) row of `motions`: of a blend the first clip; -1 for a state without motion"""
    blends: tuple[BlendDefinition | None, ...]
    """(S,) the blend of clips that a state plays; None for a state that plays one clip or none"""
    blended_clips: tuple[tuple[BlendedClip, ...], ...]
    """(S,) the clips of each blend, empty for a state without one"""
    loop: NDArray[np.bool_]
    """(S,)"""
    duration: NDArray[np.float64]
    """(S,) of a blend the longest clip; infinite for a state without motion"""
    markers: tuple[tuple[tuple[str, float], ...], ...]
    """(S,) name and phase 0…1 of each marker, by phase; a blend has the markers of its first clip"""
    speed: NDArray[np.float64]
    """(S,) factor of time, if speed_parameter is -1"""
    speed_parameter: NDArray[np.int16]
    """(S,) row of `parameters` that gives the factor, -1 none"""
    idle: int
    """the event that stands for no input at all, -1 none"""
    fallbacks: tuple[int, ...]
    """for each layer, the state of an actor whose own state was removed by an edit"""
    actions: tuple[ActionDefinition, ...]
    motions: tuple[str, ...]
    keys: Mapping[str, Key]
    parameters: tuple[Parameter, ...]
    variables: tuple[str, ...]
    """the names that conditions may ask for: the parameters, then `conditions.variables.NAMES` that
    are no parameter
    """
    senses: tuple[Sense, ...]
    touches: tuple[Touch, ...]
    colliders: tuple[Collider, ...]
    histories: tuple[tuple[str, str], ...]
    """layer and name of the composite states that resume the inner state left last"""
    inside: NDArray[np.bool_]
    """(S, H) the states inside each composite state of `histories`"""
    undefined: Mapping[tuple[int, int], str]
    """the unknown name in each cell whose target is UNDEFINED"""
    program: Program = field(init=False, repr=False)
    """the machine as the tick reads it"""
    text: ProgramText = field(init=False, repr=False)
    """the text for the numbers of the program"""

    @property
    def initial(self) -> int:
        """Returns the state that the base begins in."""
        return self.initials[0]

    @property
    def end(self) -> int:
        """Returns the column of END."""
        return len(self.events) - 1

    def rows(self, layer: int) -> range:
        """Returns the rows of a layer's states."""
        rows = np.flatnonzero(self.layer_of == layer)
        return range(int(rows[0]), int(rows[-1]) + 1)

    @cached_property
    def end_matters(self) -> NDArray[np.bool_]:
        """Returns (S,) whether END, or the idle event in its place, has a cell that may change something."""
        at_end = self.target[:, self.end]
        idle = self.target[:, self.idle] if self.idle >= 0 else np.full(len(self.states), OFF)
        idle_acts = (idle >= 0) | (idle == MIXED)
        return np.asarray(
            (at_end >= 0) | (at_end == UNDEFINED) | (at_end == MIXED) | ((at_end == BLANK) & idle_acts)
        )

    @cached_property
    def entry_values(self) -> tuple[tuple[int, str], ...]:
        """Returns (V,) state and name, `entry speed`, of each value that a state keeps from its entry: those
        that motions are blended over.
        """
        blends = enumerate(self.blends)
        return tuple((row, name) for row, blend in blends if blend for name in blend.over if name in ENTRY)

    @cached_property
    def axes(self) -> tuple[tuple[str, ...], ...]:
        """Returns (P + V,) the columns of `MachineState.smoothed`: a parameter's name, or layer, state and
        name of an entry value.
        """
        kept = (
            (self.layers[self.layer_of[row]].name, self.states[row], name) for row, name in self.entry_values
        )
        return (*((parameter.name,) for parameter in self.parameters), *kept)

    def axis(self, state: int, name: str) -> int:
        """Returns the column of `MachineState.smoothed` over which a state's motion is blended."""
        layer = self.layers[self.layer_of[state]].name
        return self.axes.index((layer, self.states[state], name) if name in ENTRY else (name,))

    @cached_property
    def columns(self) -> dict[str, int]:
        """Returns the columns of the events by name, without END."""
        return {name: column for column, name in enumerate(self.events[:-1])}

    @cached_property
    def received(self) -> NDArray[np.bool_]:
        """Returns (E, L) the layers that receive an input: the layers with cells for its event, else the
        base.
        """
        is_received = self.layer_concerns.T.copy()
        is_received[self.end] = False
        is_received[:, 0] |= ~is_received.any(axis=1)
        return is_received

    @cached_property
    def windows(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Returns (S, E) the seconds at which a cell's window opens, and at which it closes; infinite for a
        cell without a window or a motion.
        """
        opens, closes = np.full(self.when.shape, np.inf), np.full(self.when.shape, np.inf)
        for place, timing in self.timings.items():
            if np.isfinite(self.duration[place[0]]):
                opens[place], closes[place] = (
                    timing.first * self.duration[place[0]],
                    timing.last * self.duration[place[0]],
                )
        return opens, closes
