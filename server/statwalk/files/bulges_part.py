"""Reads `bulges` of a character file (DS8): muscles that bulge with the angle of a joint.

bulges:
  biceps:
    angle: forearm.rotate_z          # degrees
    cubic: [1, 0.001, 0.00002, 0]    # scale factor = 1 + 0.001·a + 0.00002·a²
    bone: upperarm                   # point, axis and radius are in its space at rest, metres
    point: [0.15, 0.04, 0]
    axis: [1, 0, 0]                  # vertices move away from it; without it, from the point
    radius: [0.12, 0.08, 0.08]       # half axes of an ellipsoid: the bulge fades out towards its surface
    vertices: [3, 4, 10-20]          # or these vertices alone, counted from 0
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from statwalk.character.bulge_targets import with_bulges
from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.vertex_numbers import read_vertices, vertices_in_words
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.expression_definition import channel_of_name
from statwalk.skin.bulge import AXES, Bulge, Point

MOST_BULGES, FARTHEST = 64, 1e6
_KEYS = ("angle", "cubic", "bone", "point", "axis", "radius", "vertices")
_NEEDED = ("angle", "cubic", "bone", "point")


def with_bulges_of(node: Node, character: Character) -> Character:
    """Returns the character with the bulges that `node` describes, without a model.

    :raises ContentError: when a bulge is wrong; with the line.
    """
    bulges = list(read_bulges(node).values())
    try:
        return with_bulges(character, bulges)
    except ContentError as error:
        line = int(error.place.removeprefix("line ") or node.line)
        name = next((bulge.name for bulge in bulges if bulge.line == line), "")
        raise node.refuse(f"bulges: {name}: {error.message}", line) from None


def read_bulges(node: Node | None) -> dict[str, Bulge]:
    """Reads `bulges`, by name.

    :raises ContentError: when a key is missing or unknown, or a value is out of its range; with the line.
    """
    entries = node.entries() if node is not None else {}
    if node is not None and len(entries) > MOST_BULGES:
        raise node.refuse(f"a character has at most {MOST_BULGES} bulges, not {len(entries)}")
    return {name: _bulge(name, entry) for name, entry in entries.items()}


def _bulge(name: str, node: Node) -> Bulge:
    entries = node.entries(*_KEYS)
    for key in _NEEDED:
        if key not in entries:
            raise node.refuse(f"the bulge {name} needs {', '.join(_NEEDED)}; {key} is missing")
    if "radius" not in entries and "vertices" not in entries:
        raise node.refuse(f"the bulge {name} needs vertices, or a radius around its point")
    joint, turn = _angle(entries["angle"])
    cubic = _numbers(entries["cubic"], 4)
    axis = _point(entries["axis"]) if "axis" in entries else None
    if axis is not None and not any(axis):
        raise entries["axis"].refuse("an axis is a direction, not 0 0 0")
    radius = _point(entries["radius"]) if "radius" in entries else None
    if radius is not None and min(radius) <= 0:
        raise entries["radius"].refuse("a radius is [x, y, z], each more than 0")
    return Bulge(
        name,
        joint,
        turn,
        (cubic[0], cubic[1], cubic[2], cubic[3]),
        entries["bone"].text(),
        _point(entries["point"]),
        axis,
        radius,
        read_vertices(entries["vertices"]) if "vertices" in entries else None,
        node.line,
    )


def _angle(node: Node) -> tuple[str, str]:
    joint, channel = channel_of_name(node.text()) or ("", "")
    if not channel.startswith("rotate_"):
        wanted = ", ".join(f"JOINT.rotate_{axis}" for axis in AXES)
        raise node.refuse(f"an angle is {wanted}, not {node.text()[:80]!r}")
    return joint, channel[-1]


def _numbers(node: Node, count: int) -> list[float]:
    if len(node.items()) != count:
        raise node.refuse(f"a list of {count} numbers is needed, not of {len(node.items())}")
    return [part.number(-FARTHEST, FARTHEST) for part in node.items()]


def _point(node: Node) -> Point:
    x, y, z = _numbers(node, 3)
    return x, y, z


def bulges_in_words(bulges: Mapping[str, Bulge]) -> dict[str, Any]:
    """Returns bulges as a character file says them; empty without."""
    return {"bulges": {name: _in_words(bulge) for name, bulge in bulges.items()}} if bulges else {}


def _in_words(bulge: Bulge) -> dict[str, Any]:
    words: dict[str, Any] = {"angle": f"{bulge.joint}.rotate_{bulge.turn}", "cubic": list(bulge.cubic)}
    words |= {"bone": bulge.bone, "point": list(bulge.point)}
    if bulge.axis is not None:
        words["axis"] = list(bulge.axis)
    if bulge.radius is not None:
        words["radius"] = list(bulge.radius)
    if bulge.vertices is not None:
        words["vertices"] = vertices_in_words(bulge.vertices)
    return words
