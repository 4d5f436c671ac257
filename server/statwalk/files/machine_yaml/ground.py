"""Reads `foot_lock` and `ground` of a machine file.

foot_lock: true                                   # or 0…1, or a parameter
ground:
  - {from: [-1, 2], to: [1, 2.3], height: 0.17}           # a step
  - {from: [-1, 4], to: [1, 7], height: [0, 0.5]}         # a slope that rises along z; `along: x` otherwise
"""

from __future__ import annotations

from collections.abc import Mapping

from statwalk.files.machine_yaml import fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.machine.definition.parameter_definition import ParameterDefinition

MOST_PIECES = 256
HIGHEST = 1e3
"""metres"""


def foot_lock(node: Node | None, parameters: Mapping[str, ParameterDefinition]) -> float | str:
    """Reads `true`, `false`, a number 0…1, or the name of a parameter.

    :raises MachineError: when it is none of these.
    """
    if node is None or node.text() in ("false", "off", "no"):
        return 0.0
    if node.text() in ("true", "on", "yes"):
        return 1.0
    if node.text() in parameters:
        return node.text()
    return node.number(0, 1)


def ground(node: Node | None) -> tuple[GroundDefinition, ...]:
    """Reads a list of rectangles.

    :raises MachineError: when there are too many, or one has no area.
    """
    pieces = [] if node is None else node.items()
    if node is not None and len(pieces) > MOST_PIECES:
        raise node.refuse(f"{len(pieces)} pieces of ground; at most {MOST_PIECES}")
    return tuple(_piece(piece) for piece in pieces)


def _piece(node: Node) -> GroundDefinition:
    entries = node.entries("from", "to", "height", "along")
    for key in ("from", "to", "height"):
        fields.required(node, key)
    first, last = (_corner(entries[key]) for key in ("from", "to"))
    corner = min(first[0], last[0]), min(first[1], last[1])
    opposite = max(first[0], last[0]), max(first[1], last[1])
    if corner[0] == opposite[0] or corner[1] == opposite[1]:
        raise node.refuse("`from` and `to` are opposite corners [x, z]; they must differ in x and in z")
    axis = fields.chosen(entries["along"], "axis", ("x", "z")) if "along" in entries else "z"
    heights = _heights(entries["height"])
    return GroundDefinition(corner, opposite, heights[0], node.line, heights[1], axis)


def _corner(node: Node) -> tuple[float, float]:
    parts = node.items()
    if len(parts) != 2:
        raise node.refuse(f"two numbers are needed, [x, z], not {len(parts)}")
    x, z = (part.number(-fields.FARTHEST, fields.FARTHEST) for part in parts)
    return x, z


def _heights(node: Node) -> tuple[float, float | None]:
    if not isinstance(node.value, list):
        return node.number(0, HIGHEST), None
    parts = node.items()
    if len(parts) != 2:
        raise node.refuse("a slope has two heights, [BEGIN, END]")
    return parts[0].number(0, HIGHEST), parts[1].number(0, HIGHEST)
