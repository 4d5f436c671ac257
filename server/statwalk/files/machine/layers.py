"""Layers of a machine file: more tables that run beside the first, each on some joints and with a weight."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from statwalk.files.machine import fields, levels
from statwalk.files.yamltext import Node
from statwalk.machine.authored.definition import BASE, NO_MOTION, ParameterDefinition

LAYER_KEYS = (*levels.LEVEL_KEYS, "mask", "mode", "weight")
MOST_LAYERS = 16
MOST_JOINTS = 1_024


@dataclass(frozen=True)
class Layer:
    """A layer as read, its cells not yet looked into."""

    flat: levels.Flat
    mask: tuple[str, ...]
    mode: Literal["override", "additive"]
    weight: float | str
    line: int


def layers(node: Node | None, parameters: Mapping[str, ParameterDefinition], folder: Path | None) -> dict[str, Layer]:
    """`{arms: {mask: [Spine], mode: override, weight: 1, initial: REST, states: …, table: …}}`, from below to above."""
    found = {}
    for name, one in fields.named(node, "layer", MOST_LAYERS).items():
        if name == BASE:
            raise one.refuse(f"{BASE} is the layer that every machine has: its table stands at the top of the file")
        found[name] = layer(one, parameters, folder)
    return found


def layer(node: Node, parameters: Mapping[str, ParameterDefinition], folder: Path | None) -> Layer:
    """One layer; raises MachineError."""
    entries = node.entries(*LAYER_KEYS)
    mode = fields.chosen(entries["mode"], "mode", ("override", "additive")) if "mode" in entries else "override"
    return Layer(
        flat=levels.read(node, parameters, folder),
        mask=mask(entries.get("mask")),
        mode="additive" if mode == "additive" else "override",
        weight=weight(entries["weight"], parameters) if "weight" in entries else 1.0,
        line=node.line,
    )


def mask(node: Node | None) -> tuple[str, ...]:
    """Names of joints, each with all below it."""
    joints = [] if node is None else node.items()
    if node is not None and not 1 <= len(joints) <= MOST_JOINTS:
        raise node.refuse(f"a mask is of 1 to {MOST_JOINTS:,} joints; without one the layer moves all")
    return tuple(one.text() for one in joints)


def weight(node: Node, parameters: Mapping[str, ParameterDefinition]) -> float | str:
    """A number from 0 to 1, or a parameter that stays there; raises MachineError for any other."""
    if not node.text().isidentifier():
        return node.number(0, 1)
    given = parameters[fields.chosen(node, "parameter", parameters)]
    if given.minimum < 0 or given.maximum > 1:
        raise node.refuse(f"{node.text()[:40]} is the weight of a layer, so it must stay in 0 … 1")
    return node.text()


def check_base(flat: levels.Flat, node: Node) -> None:
    """Raises MachineError where a state of the base layer has no motion."""
    for name, state in flat.states.items():
        if state.motion == NO_MOTION:
            raise node.refuse(
                f"{name[:80]} has no motion; only a layer's state may have none, which leaves the layers below as they are", state.line
            )
