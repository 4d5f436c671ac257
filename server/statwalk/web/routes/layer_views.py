"""Describes the layers of a machine: their states, and their tables cell by cell."""

from __future__ import annotations

from collections.abc import Container, Mapping

from pydantic import TypeAdapter

from statwalk.character.character import Character
from statwalk.character.motions import clip_facts
from statwalk.character.role import Role
from statwalk.machine.compile.compile_states import marks_of
from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.resolved_table import ResolvedTable
from statwalk.machine.definition.expression_definition import ExpressionMotion
from statwalk.machine.definition.machine_definition import (
    BlendDefinition,
    CompositeDefinition,
    StateDefinition,
)
from statwalk.machine.graph import edges, full_table
from statwalk.maths.phases import Marks
from statwalk.web.schemas.table import CellView, CompositeView, LayerView, MarkerView, StateView

CELLS: TypeAdapter[dict[str, CellView]] = TypeAdapter(dict[str, CellView])
"""validates a row of a table: no other thread runs during a validation"""


def _state_views(role: Role, layer: int) -> list[StateView]:
    definitions = role.definition.tables()[role.machine.layers[layer].name].states
    return [
        _state_view(role.machine, role.character, row, definitions[role.machine.states[row]])
        for row in role.machine.rows(layer)
    ]


def _state_view(machine: Machine, character: Character, row: int, definition: StateDefinition) -> StateView:
    has_motion, motion = machine.motion[row] >= 0, definition.motion
    blend = motion if isinstance(motion, BlendDefinition) else None
    return StateView(
        name=machine.states[row],
        motion=machine.motions[machine.motion[row]] if has_motion else None,
        over=list(blend.over) if blend else [],
        clips=list(definition.clips),
        points={clip: list(point) for clip, point in blend.clips.items()} if blend else {},
        clip_markers=_clip_markers(character, blend) if blend else {},
        speed=definition.speed,
        ground_speed=definition.ground_speed,
        loop=bool(machine.loop[row]),
        duration=float(machine.duration[row]) if has_motion else 0.0,
        outer=definition.composite,
        final=definition.final,
        framing=definition.framing,
        markers=_marker_views(machine.markers[row], definition.markers),
        expressions=[line.text for line in definition.motion.assignments]
        if isinstance(definition.motion, ExpressionMotion)
        else [],
    )


def _clip_markers(character: Character, blend: BlendDefinition) -> dict[str, list[MarkerView]]:
    return {
        clip: _marker_views(
            marks_of(clip, clip_facts(character.clips[clip]), blend), blend.markers.get(clip, {})
        )
        for clip in blend.clips
    }


def _marker_views(marks: Marks, written: Container[str]) -> list[MarkerView]:
    """Returns the markers by phase."""
    return [
        MarkerView(name=name, phase=phase, written=name in written)
        for name, phase in sorted(marks, key=lambda mark: (mark[1], mark[0]))
    ]


def _composite_views(composites: Mapping[str, CompositeDefinition]) -> list[CompositeView]:
    return [
        CompositeView(
            name=name,
            initial=composite.initial,
            resume=composite.resume,
            outer=composite.composite,
            final=composite.final,
        )
        for name, composite in composites.items()
    ]


def layer_views(role: Role) -> list[LayerView]:
    """Returns the layers of a machine, the base first."""
    return [_layer_view(role, number, table) for number, table in enumerate(role.resolved)]


def _layer_view(role: Role, number: int, table: ResolvedTable) -> LayerView:
    machine, layer = role.machine, role.machine.layers[number]
    return LayerView.model_validate(
        {
            "name": layer.name,
            "mode": layer.mode,
            "mask": list(layer.mask),
            "weight": layer.weight
            if layer.weight_parameter < 0
            else machine.parameters[layer.weight_parameter].name,
            "initial": machine.states[machine.initials[number]],
            "states": _state_views(role, number),
            "composites": _composite_views(table.definition.composites),
            "table": {state: CELLS.validate_python(cells) for state, cells in full_table(table).items()},
            "rows": [list(row) for row in table.definition.rows],
            "edges": edges(table),
        }
    )
