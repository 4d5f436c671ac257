"""Reads the parameters of a machine file: numbers, flags, points, directions, rotations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from statwalk.files.machine_yaml import fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.parameter_definition import (
    COMPONENTS,
    KINDS,
    Kind,
    ParameterDefinition,
    component_names,
    fitting,
)

LARGEST = 1e9
"""largest bound of a parameter"""
RESERVED = ("and", "or", "not", "true", "false", "pi", "if")
"""words of the condition language, which cannot be names of parameters"""
RANGES: Mapping[Kind, tuple[float, float]] = {
    "flag": (0.0, 1.0),
    "direction": (-1.0, 1.0),
    "rotation": (-1.0, 1.0),
}
"""of each component as it is stored; a point has `min` and `max` of its own"""
STANDARD: Mapping[Kind, float | tuple[float, ...]] = {
    "flag": 0.0,
    "point": (0.0, 0.0, 0.0),
    "direction": (0.0, 0.0, 1.0),
    "rotation": (0.0, 0.0, 0.0, 1.0),
}


def parameters(node: Node | None) -> dict[str, ParameterDefinition]:
    """Reads `{pace: {default: 1, min: 0.5, max: 2, smooth: 0.25}}`; conditions use the names of
    parameters.
    """
    definitions: dict[str, ParameterDefinition] = {}
    for name, entry in fields.named(node, "parameter").items():
        if not name.isidentifier() or name in RESERVED:
            raise entry.refuse(
                f"{name[:40]!r} is no name for a parameter; use letters, digits and _, and no word of the "
                "condition language"
            )
        definitions |= parameter(name, entry)
    return definitions


def parameter(name: str, node: Node) -> dict[str, ParameterDefinition]:
    """Reads `{default: 1, min: 0.5, max: 2}`, and perhaps `smooth`: the seconds in which a new value is
    reached, and `handle`: the degree of freedom of a joint that it moves; of another `kind` than a number,
    see `_typed`. Returns the numbers that store it, by name.

    :raises MachineError: when a field is missing, or `min` is more than `max`.
    """
    entries = node.entries("kind", "default", "min", "max", "smooth", "handle")
    smooth = fields.seconds(entries["smooth"]) if "smooth" in entries else 0.0
    kind = _kind(entries["kind"]) if "kind" in entries else "number"
    if kind != "number" and "handle" in entries:
        raise entries["handle"].refuse(f"a handle at a joint is for numbers, not for a {kind}")
    if kind != "number":
        return _typed(name, kind, node, smooth)
    if not {"default", "min", "max"} <= set(entries):
        raise node.refuse("a parameter needs `default`, `min` and `max`")
    lowest, highest = _range(node, LARGEST)
    default = entries["default"].number(lowest, highest)
    standard = ParameterDefinition(default, lowest, highest, node.line, smooth)
    return {name: _with_handle(standard, entries["handle"]) if "handle" in entries else standard}


def _with_handle(parameter: ParameterDefinition, node: Node) -> ParameterDefinition:
    """Reads `{joint: Knee, freedom: angle}`, and perhaps `event`."""
    entries = node.entries("joint", "freedom", "event")
    return replace(
        parameter,
        joint=fields.required(node, "joint").text(),
        freedom=fields.required(node, "freedom").text(),
        event=entries["event"].text() if "event" in entries else "",
    )


def _kind(node: Node) -> Kind:
    return next(kind for kind in KINDS if kind == fields.chosen(node, "kind of parameter", KINDS))


def _range(node: Node, largest: float) -> tuple[float, float]:
    """`min` and `max`, by default as large as may be."""
    entries = node.entries()
    lowest = entries["min"].number(-largest, largest) if "min" in entries else -largest
    highest = entries["max"].number(-largest, largest) if "max" in entries else largest
    if lowest > highest:
        raise node.refuse(f"min {lowest:g} is more than max {highest:g}")
    return lowest, highest


def _typed(name: str, kind: Kind, node: Node, smooth: float) -> dict[str, ParameterDefinition]:
    """Reads `{kind: point, default: [0, 1, 0], min: -5, max: 5}` (metres), `{kind: direction, default: [0,
    0, 1]}`, `{kind: rotation, default: [0, 0, 0, 1]}` (a quaternion x y z w) or `{kind: flag, default: 1}`.
    """
    entries = node.entries()
    if kind in RANGES and {"min", "max"} & set(entries):
        raise node.refuse(f"a {kind} has no `min` and `max`")
    if kind == "flag" and smooth:
        raise entries["smooth"].refuse("a flag is 0 or 1; it has nothing between to be smooth")
    lowest, highest = RANGES.get(kind) or _range(node, fields.FARTHEST)
    if "default" not in entries and not lowest <= 0 <= highest:
        raise node.refuse(f"{name} needs a `default`: 0 is outside {lowest:g} … {highest:g}")
    written = _numbers(entries["default"]) if "default" in entries else STANDARD[kind]
    try:
        numbers = fitting(name, kind, written)
    except ValueError as error:
        raise entries["default"].refuse(str(error)) from None
    if not all(lowest <= number <= highest for number in numbers):
        raise entries["default"].refuse(f"the default lies outside {lowest:g} … {highest:g}")
    vector = name if kind in COMPONENTS else ""
    return {
        part: ParameterDefinition(number, lowest, highest, node.line, smooth, kind, vector)
        for part, number in zip(component_names(name, kind), numbers, strict=True)
    }


def _numbers(node: Node) -> float | list[float]:
    """One number, or a list: of more than four numbers the first five, which are too many."""
    if not isinstance(node.value, list):
        return node.number(-LARGEST, LARGEST)
    return [part.number(-LARGEST, LARGEST) for part in node.items()[:5]]
