"""What a character senses: thresholds with hysteresis, and touches of its colliders, which are spheres and planes on its joints."""

from __future__ import annotations

import math
from collections.abc import Mapping

from statwalk.files.machine import conditions, fields
from statwalk.files.yamltext import Node
from statwalk.machine.authored.definition import END, ColliderDefinition, SenseDefinition, TouchDefinition

LARGEST_RADIUS = 1e4
"""metres"""
SMALLEST_NORMAL = 1e-6


def senses(
    node: Node | None, variables: tuple[str, ...], colliders: Mapping[str, ColliderDefinition]
) -> dict[str, SenseDefinition | TouchDefinition]:
    """`{RUN: {when: speed > 2.0, release: speed < 1.6}, HIT: {touch: [body, monster]}}`, by the event that they raise."""
    found: dict[str, SenseDefinition | TouchDefinition] = {}
    for event, one in fields.named(node, "event").items():
        if event == END:
            raise one.refuse("END is raised by motions, not by senses")
        is_touch = one.is_mapping and "touch" in one.entries()
        found[event] = touch(one, colliders) if is_touch else sense(one, variables)
    return found


def sense(node: Node, variables: tuple[str, ...]) -> SenseDefinition:
    """`{when: speed > 2.0, release: speed < 1.6}`."""
    entries = node.entries("when", "release", "touch", "on")
    if "when" not in entries:
        raise node.refuse("a sense needs a condition (`when: speed > 2`) or a pair of colliders (`touch: [OWN, OTHER]`)")
    if "on" in entries:
        raise entries["on"].refuse("`on` is for a touch; a condition has `release`")
    release = conditions.condition(entries["release"], variables) if "release" in entries else ""
    return SenseDefinition(conditions.condition(entries["when"], variables), release, node.line)


def touch(node: Node, colliders: Mapping[str, ColliderDefinition]) -> TouchDefinition:
    """`{touch: [body, monster], on: enter}`: a collider of this machine, and the name of one that any actor on the stage may have."""
    entries = node.entries("touch", "on")
    pair = entries["touch"].items()
    if len(pair) != 2:
        raise entries["touch"].refuse("a touch is of two colliders, [OWN, OTHER]")
    own, other = fields.chosen(pair[0], "collider", colliders), fields.name(pair[1], "collider")
    match fields.chosen(entries["on"], "kind of touch", ("enter", "stay", "leave")) if "on" in entries else "enter":
        case "stay":
            return TouchDefinition(own, other, "stay", node.line)
        case "leave":
            return TouchDefinition(own, other, "leave", node.line)
    return TouchDefinition(own, other, "enter", node.line)


def colliders(node: Node | None) -> dict[str, ColliderDefinition]:
    """`{body: {sphere: 0.4, joint: Hips}, door: {plane: [0, 0, 1], at: [0, 1, 0], radius: 1}}`; metres, in the joint's space."""
    return {name: collider(one) for name, one in fields.named(node, "collider").items()}


def collider(node: Node) -> ColliderDefinition:
    """A sphere of some radius, or a plane (with `radius`: a disc) and the direction that its front looks in."""
    entries = node.entries("sphere", "plane", "joint", "at", "radius")
    if ("sphere" in entries) == ("plane" in entries):
        raise node.refuse("a collider is either a `sphere: RADIUS` or a `plane: [x, y, z]`")
    joint = entries["joint"].text() if "joint" in entries else ""
    center = fields.point(entries["at"]) if "at" in entries else (0.0, 0.0, 0.0)
    if "sphere" in entries:
        if "radius" in entries:
            raise entries["radius"].refuse("`radius` is for a plane; a sphere is written `sphere: RADIUS`")
        return ColliderDefinition("sphere", node.line, joint, center, entries["sphere"].number(0, LARGEST_RADIUS))
    radius = entries["radius"].number(0, LARGEST_RADIUS) if "radius" in entries else 0.0
    return ColliderDefinition("plane", node.line, joint, center, radius, direction(entries["plane"]))


def direction(node: Node) -> tuple[float, float, float]:
    """`[x, y, z]`, made one metre long; raises MachineError where it has no length."""
    x, y, z = fields.point(node)
    length = math.sqrt(x * x + y * y + z * z)
    if length < SMALLEST_NORMAL:
        raise node.refuse("a plane's front needs a direction")
    return x / length, y / length, z / length
