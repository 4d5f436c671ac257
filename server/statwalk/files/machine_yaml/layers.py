"""Reads the layers of a machine file: more tables, which run beside the base table, each with a mask and a
weight.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from statwalk.files.machine_yaml import fields, levels
from statwalk.files.machine_yaml.tables import TableFiles
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.machine_definition import BASE, NO_MOTION
from statwalk.machine.definition.parameter_definition import ParameterDefinition

LAYER_KEYS = (*levels.LEVEL_KEYS, "mask", "mode", "weight")
MOST_LAYERS = 16
MOST_JOINTS = 1_024


@dataclass(frozen=True)
class LayerPart:
    """A layer as read; the cells of its table are not resolved yet."""

    flat: levels.FlatStates
    mask: tuple[str, ...]
    mode: Literal["override", "additive"]
    weight: float | str
    line: int


def layers(
    node: Node | None, parameters: Mapping[str, ParameterDefinition], files: TableFiles
) -> dict[str, LayerPart]:
    """Reads `{arms: {mask: [Spine], mode: override, weight: 1, initial: REST, states: …, table: …}}`, lowest
    layer first.
    """
    parts = {}
    for name, entry in fields.named(node, "layer", MOST_LAYERS).items():
        if name == BASE:
            raise entry.refuse(
                f"{BASE} is the layer that every machine has; write its table at the top of the file"
            )
        parts[name] = layer(entry, parameters, files)
    return parts


def layer(node: Node, parameters: Mapping[str, ParameterDefinition], files: TableFiles) -> LayerPart:
    """Reads one layer.

    :raises MachineError: when a field is wrong.
    """
    entries = node.entries(*LAYER_KEYS)
    mode = (
        fields.chosen(entries["mode"], "mode", ("override", "additive")) if "mode" in entries else "override"
    )
    return LayerPart(
        flat=levels.read(node, parameters, files),
        mask=mask(entries.get("mask")),
        mode="additive" if mode == "additive" else "override",
        weight=weight(entries["weight"], parameters) if "weight" in entries else 1.0,
        line=node.line,
    )


def mask(node: Node | None) -> tuple[str, ...]:
    """Reads the names of a mask: a joint stands for itself and everything below it, `TARGET.weight` for a
    morph target, `muscles` for all muscles of the face.
    """
    joints = [] if node is None else node.items()
    if node is not None and not 1 <= len(joints) <= MOST_JOINTS:
        raise node.refuse(
            f"a mask has 1 to {MOST_JOINTS:,} joints; without a mask the layer moves all joints"
        )
    return tuple(joint.text() for joint in joints)


def weight(node: Node, parameters: Mapping[str, ParameterDefinition]) -> float | str:
    """Reads a number from 0 to 1, or the name of a parameter with bounds in 0…1.

    :raises MachineError: when the value is neither.
    """
    if not node.text().isidentifier():
        return node.number(0, 1)
    parameter = parameters[fields.chosen(node, "parameter", parameters)]
    if parameter.minimum < 0 or parameter.maximum > 1:
        raise node.refuse(f"{node.text()[:40]} is the weight of a layer, so it must stay in 0 … 1")
    return node.text()


def check_base(flat: levels.FlatStates, node: Node) -> None:
    """Checks that every state of the base layer has a motion.

    :raises MachineError: when a state has none; `place` is the state's line.
    """
    for name, state in flat.states.items():
        if state.motion == NO_MOTION:
            raise node.refuse(
                f"{name[:80]} has no motion; only a state of a layer above the base may have `motion: none`",
                state.line,
            )
