"""Compiles a machine definition: full integer tables, immutable; nothing can fail after it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.alternatives import (
    AT_END,
    AT_MARKER,
    BLANK,
    IN_WINDOW,
    MATCH,
    MIXED,
    NOW,
    OFF,
    UNDEFINED,
    Collider,
    Key,
    Layer,
    Parameter,
    Sense,
    Touch,
)
from statwalk.machine.compile.compile_cells import Conditions, cell_arrays
from statwalk.machine.compile.compile_states import LARGEST_SPEED, MotionFacts, state_arrays
from statwalk.machine.compile.link import linked
from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.resolved_table import ResolvedTable, resolved_tables
from statwalk.machine.conditions.variables import variables_of
from statwalk.machine.definition.machine_definition import (
    BASE,
    MachineDefinition,
    nearest,
)
from statwalk.machine.definition.sense_definition import TouchDefinition
from statwalk.maths.formula.parser import parse
from statwalk.maths.formula.postfix import Formula
from statwalk.maths.formula.tokens import ConditionError

__all__ = [
    "AT_END",
    "AT_MARKER",
    "BLANK",
    "IN_WINDOW",
    "LARGEST_SPEED",
    "MATCH",
    "MIXED",
    "NOW",
    "OFF",
    "UNDEFINED",
    "Machine",
    "MotionFacts",
    "build",
]


def build(
    definition: MachineDefinition,
    motions: Mapping[str, MotionFacts],
    resolved: Sequence[ResolvedTable] | None = None,
) -> Machine:
    """Returns the compiled machine; `resolved`: the tables of this definition and these motions, if they are
    resolved already.

    :raises MachineError: when a motion, marker, parameter or condition is wrong; with the line and the
        nearest name.
    """
    resolved = resolved_tables(definition, motions) if resolved is None else resolved
    tables = {table.layer: table.definition for table in resolved}
    states = state_arrays(tables, motions)
    variables = variables_of(definition.parameters)
    conditions = _conditions_of(definition, variables)
    machine = Machine(
        name=definition.name,
        events=definition.columns,
        layers=_layers_of(definition),
        initials=tuple(_row_of(states, layer, table.initial) for layer, table in enumerate(tables.values())),
        fallbacks=tuple(
            _row_of(states, layer, table.fallback or table.initial)
            for layer, table in enumerate(tables.values())
        ),
        idle=definition.columns.index(definition.idle) if definition.idle else -1,
        buffer=buffers(definition),
        keys={name: Key(key.press, key.release, key.hold) for name, key in definition.keys.items()},
        parameters=tuple(
            Parameter(
                name,
                put.default,
                put.minimum,
                put.maximum,
                put.smooth,
                put.kind,
                put.vector,
                put.joint,
                put.freedom,
                put.event,
            )
            for name, put in definition.parameters.items()
        ),
        variables=variables,
        colliders=tuple(
            Collider(name, shape.kind, shape.joint, shape.center, shape.radius, shape.normal, shape.line)
            for name, shape in definition.colliders.items()
        ),
        **states,
        **cell_arrays(resolved, states, conditions),
        **_senses_of(definition, conditions),
    )
    return linked(machine)


def _row_of(states: Mapping[str, Any], layer: int, name: str) -> int:
    rows = [
        row
        for row, (owner, state) in enumerate(zip(states["layer_of"], states["states"], strict=True))
        if (owner, state) == (layer, name)
    ]
    return rows[0]


def buffers(definition: MachineDefinition) -> NDArray[np.float32]:
    """Returns (E,) the seconds that each event waits in a blank cell; 0 for END, which does not wait."""
    own = [
        definition.defaults.buffer if event.buffer is None else event.buffer
        for event in definition.events.values()
    ]
    return np.array([*own, 0], np.float32)


def _layers_of(definition: MachineDefinition) -> tuple[Layer, ...]:
    layers = [Layer(BASE)]
    for name, layer in definition.layers.items():
        weight, row = 1.0, -1
        if isinstance(layer.weight, float):
            weight = layer.weight
        elif layer.weight in definition.parameters:
            row = list(definition.parameters).index(layer.weight)
        else:
            hint = nearest(layer.weight, tuple(definition.parameters)) or "."
            raise definition.refuse(
                f"the weight of the layer {name} is {layer.weight!r}, which is no parameter{hint}", layer.line
            )
        layers.append(Layer(name, layer.mode, layer.mask, weight, row))
    return tuple(layers)


def _senses_of(definition: MachineDefinition, conditions: Conditions) -> dict[str, Any]:
    senses, touches = [], []
    for name, sense in definition.senses.items():
        event = definition.columns.index(name)
        if isinstance(sense, TouchDefinition):
            touches.append(Touch(event, sense.own, sense.other, sense.on))
        else:
            release = conditions(sense.release, sense.line) if sense.release else None
            senses.append(Sense(event, conditions(sense.when, sense.line), release))
    return {"senses": tuple(senses), "touches": tuple(touches)}


def _conditions_of(definition: MachineDefinition, variables: tuple[str, ...]) -> Conditions:
    formulas: dict[str, Formula] = {}

    def read(text: str, line: int) -> Formula:
        try:
            return formulas.setdefault(text, formulas.get(text) or parse(text, variables))
        except ConditionError as error:
            raise definition.refuse(f"{text[:80]!r}: {error}", line) from None

    return read
