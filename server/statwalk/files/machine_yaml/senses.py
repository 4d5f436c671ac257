"""Reads what a character senses: thresholds with hysteresis, and touches of its colliders, which are spheres
and planes on its joints.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from statwalk.files.machine_yaml import conditions, fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.machine_definition import (
    END,
)
from statwalk.machine.definition.sense_definition import ColliderDefinition, SenseDefinition, TouchDefinition

LARGEST_RADIUS = 1e4
"""metres"""
SMALLEST_NORMAL = 1e-6


def senses(
    node: Node | None, variables: tuple[str, ...], colliders: Mapping[str, ColliderDefinition]
) -> dict[str, SenseDefinition | TouchDefinition]:
    """Reads `{RUN: {when: speed > 2.0, release: speed < 1.6}, HIT: {touch: [body, monster]}}`, by the event
    that a sense raises.
    """
    definitions: dict[str, SenseDefinition | TouchDefinition] = {}
    for event, sense in fields.named(node, "event").items():
        if event == END:
            raise sense.refuse("the end of a motion raises END; a sense cannot raise it")
        is_touch = sense.is_mapping and "touch" in sense.entries()
        definitions[event] = touch(sense, colliders) if is_touch else _sense(sense, variables)
    return definitions


def _sense(node: Node, variables: tuple[str, ...]) -> SenseDefinition:
    """Reads `{when: speed > 2.0, release: speed < 1.6}`."""
    entries = node.entries("when", "release", "touch", "on")
    if "when" not in entries:
        raise node.refuse(
            "a sense needs a condition (`when: speed > 2`) or a pair of colliders (`touch: [OWN, OTHER]`)"
        )
    if "on" in entries:
        raise entries["on"].refuse("`on` is for a touch; a condition has `release`")
    release = conditions.condition(entries["release"], variables) if "release" in entries else ""
    return SenseDefinition(conditions.condition(entries["when"], variables), release, node.line)


def touch(node: Node, colliders: Mapping[str, ColliderDefinition]) -> TouchDefinition:
    """Reads `{touch: [body, monster], on: enter}`: a collider of this machine, and the name of a collider
    that any actor on the stage may have.
    """
    entries = node.entries("touch", "on")
    pair = entries["touch"].items()
    if len(pair) != 2:
        raise entries["touch"].refuse("a touch needs two colliders, [OWN, OTHER]")
    own, other = fields.chosen(pair[0], "collider", colliders), fields.name(pair[1], "collider")
    match (
        fields.chosen(entries["on"], "kind of touch", ("enter", "stay", "leave"))
        if "on" in entries
        else "enter"
    ):
        case "stay":
            return TouchDefinition(own, other, "stay", node.line)
        case "leave":
            return TouchDefinition(own, other, "leave", node.line)
    return TouchDefinition(own, other, "enter", node.line)


def colliders(node: Node | None) -> dict[str, ColliderDefinition]:
    """Reads `{body: {sphere: 0.4, joint: Hips}, door: {plane: [0, 0, 1], at: [0, 1, 0], radius: 1}}`; metres,
    in the joint's space.
    """
    return {name: _collider(collider) for name, collider in fields.named(node, "collider").items()}


def _collider(node: Node) -> ColliderDefinition:
    """Reads a sphere with its radius, or a plane (with `radius`: a disc) with its normal."""
    entries = node.entries("sphere", "plane", "joint", "at", "radius")
    if ("sphere" in entries) == ("plane" in entries):
        raise node.refuse("a collider is either a `sphere: RADIUS` or a `plane: [x, y, z]`")
    joint = entries["joint"].text() if "joint" in entries else ""
    center = fields.point(entries["at"]) if "at" in entries else (0.0, 0.0, 0.0)
    if "sphere" in entries:
        if "radius" in entries:
            raise entries["radius"].refuse("`radius` is for a plane; a sphere is written `sphere: RADIUS`")
        return ColliderDefinition(
            "sphere", node.line, joint, center, entries["sphere"].number(0, LARGEST_RADIUS)
        )
    radius = entries["radius"].number(0, LARGEST_RADIUS) if "radius" in entries else 0.0
    return ColliderDefinition("plane", node.line, joint, center, radius, direction(entries["plane"]))


def direction(node: Node) -> tuple[float, float, float]:
    """Reads `[x, y, z]` and returns it at unit length.

    :raises MachineError: when its length is 0.
    """
    x, y, z = fields.point(node)
    length = math.sqrt(x * x + y * y + z * z)
    if length < SMALLEST_NORMAL:
        raise node.refuse("a plane needs a normal of a length other than 0")
    return x / length, y / length, z / length
