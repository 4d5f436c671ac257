"""The resolved tables of a machine, with all defaults written out: made once for a definition and shared by
all readers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from statwalk.machine.compile.compile_states import MotionFacts, markers_of
from statwalk.machine.compile.resolve_defaults import Cell, resolve_defaults
from statwalk.machine.definition.machine_definition import MachineDefinition

Motions = Mapping[str, MotionFacts] | None
"""by name; None: the character is unknown"""
Markers = Mapping[str, frozenset[str]]
"""the marker names of each state's motion; states with unknown motions are missing"""


@dataclass(frozen=True)
class ResolvedTable:
    """One layer's table with its defaults written out."""

    layer: str
    definition: MachineDefinition
    """the states and cells of the layer, and everything that the layers share"""
    cells: Mapping[tuple[str, str], Cell]
    """(state, event) -> the cell that counts; blanks without a default are missing"""
    markers: Markers


def resolved_tables(definition: MachineDefinition, motions: Motions) -> tuple[ResolvedTable, ...]:
    """Returns the resolved tables of all layers, the base first. `*` does not stand for the markers of any
    layer.
    """
    tables = definition.tables()
    markers = {layer: _markers(table, motions) for layer, table in tables.items()}
    names = {name for states in markers.values() for of_state in states.values() for name in of_state}
    names |= {name for table in tables.values() for state in table.states.values() for name in state.markers}
    return tuple(
        ResolvedTable(layer, table, resolve_defaults(table, names), markers[layer])
        for layer, table in tables.items()
    )


def _markers(table: MachineDefinition, motions: Motions) -> Markers:
    with_known_clips = {
        name: state
        for name, state in table.states.items()
        if motions is not None and motions.keys() >= set(state.clips)
    }
    return {
        name: frozenset(marker for marker, _ in markers_of(state, motions or {}))
        for name, state in with_known_clips.items()
    }
