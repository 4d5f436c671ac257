"""From the authored machine to the one that runs: full integer tables, immutable; after it nothing can fail."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.authored.definition import BASE, MachineDefinition, TouchDefinition, nearest
from statwalk.machine.built.buildcells import Conditions, cell_arrays
from statwalk.machine.built.buildstates import LARGEST_SPEED, MotionFacts, state_arrays
from statwalk.machine.built.runform import Machine
from statwalk.machine.built.runparts import (
    AT_END,
    AT_MARKER,
    BLANK,
    IN_WINDOW,
    MATCH,
    MEASURED,
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
from statwalk.machine.conditions.parser import parse
from statwalk.machine.conditions.program import Program
from statwalk.machine.conditions.words import ConditionError

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


def build(definition: MachineDefinition, motions: Mapping[str, MotionFacts]) -> Machine:
    """The machine that runs. Raises MachineError with line and nearest name for a motion, marker, parameter or condition that is wrong."""
    tables = definition.tables()
    states = state_arrays(tables, motions)
    variables = (*definition.parameters, *(name for name in MEASURED if name not in definition.parameters))
    conditions = conditions_of(definition, variables)
    return Machine(
        name=definition.name,
        events=definition.columns,
        layers=layers_of(definition),
        initials=tuple(row_of(states, layer, table.initial) for layer, table in enumerate(tables.values())),
        fallbacks=tuple(row_of(states, layer, table.fallback or table.initial) for layer, table in enumerate(tables.values())),
        idle=definition.columns.index(definition.idle) if definition.idle else -1,
        buffer=buffers(definition),
        keys={name: Key(key.press, key.release, key.hold) for name, key in definition.keys.items()},
        parameters=tuple(Parameter(name, one.default, one.minimum, one.maximum, one.smooth) for name, one in definition.parameters.items()),
        variables=variables,
        colliders=tuple(
            Collider(name, one.kind, one.joint, one.center, one.radius, one.normal, one.line) for name, one in definition.colliders.items()
        ),
        **states,
        **cell_arrays(tables, states, conditions),
        **senses_of(definition, conditions),
    )


def row_of(states: Mapping[str, Any], layer: int, name: str) -> int:
    """The row of a layer's state."""
    rows = [
        row for row, (there, known) in enumerate(zip(states["layer_of"], states["states"], strict=True)) if (there, known) == (layer, name)
    ]
    return rows[0]


def buffers(definition: MachineDefinition) -> NDArray[np.float32]:
    """(E,) seconds; END does not wait."""
    own = [definition.defaults.buffer if one.buffer is None else one.buffer for one in definition.events.values()]
    return np.array([*own, 0], np.float32)


def layers_of(definition: MachineDefinition) -> tuple[Layer, ...]:
    """The base and those above it; raises MachineError for a weight that is no parameter."""
    found = [Layer(BASE)]
    for name, one in definition.layers.items():
        weight, row = 1.0, -1
        if isinstance(one.weight, float):
            weight = one.weight
        elif one.weight in definition.parameters:
            row = list(definition.parameters).index(one.weight)
        else:
            hint = nearest(one.weight, tuple(definition.parameters)) or "."
            raise definition.refuse(f"the weight of the layer {name} is {one.weight!r}, which is no parameter{hint}", one.line)
        found.append(Layer(name, one.mode, one.mask, weight, row))
    return tuple(found)


def senses_of(definition: MachineDefinition, conditions: Conditions) -> dict[str, Any]:
    """The fields `senses` and `touches`; raises MachineError for a condition that cannot be read."""
    senses, touches = [], []
    for name, one in definition.senses.items():
        event = definition.columns.index(name)
        if isinstance(one, TouchDefinition):
            touches.append(Touch(event, one.own, one.other, one.on))
        else:
            release = conditions(one.release, one.line) if one.release else None
            senses.append(Sense(event, conditions(one.when, one.line), release, one.when))
    return {"senses": tuple(senses), "touches": tuple(touches)}


def conditions_of(definition: MachineDefinition, variables: tuple[str, ...]) -> Conditions:
    """Reads conditions over `variables`; raises MachineError with the line where one cannot be read."""

    known: dict[str, Program] = {}

    def read(text: str, line: int) -> Program:
        try:
            return known.setdefault(text, known.get(text) or parse(text, variables))
        except ConditionError as error:
            raise definition.refuse(f"{text[:80]!r}: {error}", line) from None

    return read
