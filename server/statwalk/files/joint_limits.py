"""Reads the joints and limits of a character file or a machine file (SK5, SK6).

    joints:
      Left.lowerleg: {type: revolute, form: hinge, axis: [1, 0, 0], angle_deg: [0, 150]}
      Left.upperleg: {type: spherical, axis: [0, -1, 0], swing_x_deg: [-30, 80], swing_z_deg: [-20, 45]}
    limits:
      Head: {rotation_deg: [[-40, -70, -30], [40, 70, 30]], translation: [[0, 0, 0], [0, 0, 0]]}

`limits` may also be the FAQ's table, as a `|` block. Degrees; lengths in metres. Everything is relative to
the rest pose, in the joint's own axes there.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

from statwalk.errors import ContentError, TextError
from statwalk.files.faq.constraint_text import read_constraints
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.limit_definition import LimitDefinition
from statwalk.maths.clamp_table import JointLimit, Range
from statwalk.rig.joint_types import TYPES, axis_limits, joint

MOST_DEGREES, FARTHEST = 36_000.0, 1e6
_ANGLES = tuple(f"{name}_deg" for name in ("angle", "twist", "swing_x", "swing_z"))
_SLIDES = ("slide", "slide_x", "slide_z")
_JOINT_KEYS = ("type", "form", "axis", "side", "pitch", "order", "shape", *_ANGLES, *_SLIDES)
Limits = dict[str, LimitDefinition]


def joint_limits(joints: Node | None, limits: Node | None, scale: float = 1.0) -> Limits:
    """Reads the values of `joints` and `limits`, by joint; `scale`: metres for each unit of their lengths.

    :raises ContentError: when a value is wrong, a minimum is more than its maximum, or a joint has both; with
        the line.
    """
    read: Limits = {}
    for name, node in _entries(joints).items():
        read[name] = LimitDefinition(_refused(node, name, partial(_joint, node, scale)), node.line)
    for name, definition in _limits(limits, scale).items():
        if name in read and limits is not None:
            raise limits.refuse(f"{name} stands under `joints` and under `limits`", definition.line)
        read[name] = definition
    return read


def table_limits(node: Node, text: str, scale: float, first_line: int = 0, file: str = "") -> Limits:
    """Reads the FAQ's table of constraints; `first_line`: the lines of the file before it, `file`: the file
    if it is not the node's.

    :raises ContentError: when a row is wrong, with the line in the file.
    """
    try:
        rows = read_constraints(text, scale)
    except TextError as error:
        line = int(error.place.removeprefix("line ")) + first_line
        raise node.error(error.message, file=file or node.file, place=f"line {line}") from None
    return {name: LimitDefinition(row.limit, row.line + first_line) for name, row in rows.items()}


def _entries(node: Node | None) -> dict[str, Node]:
    return {} if node is None or node.value == "" else node.entries()


def _limits(node: Node | None, scale: float) -> Limits:
    if node is None or node.value == "":
        return {}
    if node.is_text:
        return table_limits(node, node.text(), scale, node.first_line - 1)
    return {
        name: LimitDefinition(_refused(entry, name, partial(_axes, entry, scale)), entry.line)
        for name, entry in node.entries().items()
    }


def _refused(node: Node, name: str, read: Callable[[], JointLimit]) -> JointLimit:
    try:
        return read()
    except ContentError:
        raise
    except ValueError as error:
        raise node.refuse(f"{name}: {error}") from None


def _joint(node: Node, scale: float) -> JointLimit:
    entries = node.entries(*_JOINT_KEYS)
    if "type" not in entries:
        raise node.refuse(f"a joint needs a type: {', '.join(TYPES)}")
    ranges: dict[str, Range] = {}
    for key in _ANGLES:
        if key in entries:
            low, high = _pair(entries[key], MOST_DEGREES)
            _check_order(entries[key], key, low, high)
            ranges[key.removesuffix("_deg")] = math.radians(low), math.radians(high)
    for key in _SLIDES:
        if key in entries:
            low, high = _pair(entries[key], FARTHEST)
            _check_order(entries[key], key, low, high)
            ranges[key] = low * scale, high * scale
    words = {key: entries[key].text() for key in ("form", "order", "shape") if key in entries}
    axes = {key: _numbers(entries[key], 3, FARTHEST) for key in ("axis", "side") if key in entries}
    pitch = entries["pitch"].number(-FARTHEST, FARTHEST) * scale if "pitch" in entries else 0.0
    return joint(entries["type"].text(), ranges, axes.get("axis"), axes.get("side"), pitch=pitch, **words)


def _axes(node: Node, scale: float) -> JointLimit:
    """Reads `{rotation_deg: [[x, y, z], [x, y, z]], translation: [[x, y, z], [x, y, z]]}`."""
    entries = node.entries("rotation_deg", "translation")
    turns: list[Range] = [(-math.pi, math.pi)] * 3
    if "rotation_deg" in entries:
        turns = [
            (math.radians(low), math.radians(high)) for low, high in _ends(entries["rotation_deg"], 360.0)
        ]
    ways = None
    if "translation" in entries:
        ways = [(low * scale, high * scale) for low, high in _ends(entries["translation"], FARTHEST)]
    return axis_limits(turns, ways)


def _ends(node: Node, largest: float) -> list[Range]:
    """Reads `[[x, y, z], [x, y, z]]`: the smallest and the largest for each axis."""
    if len(node.items()) != 2:
        raise node.refuse("[[x, y, z], [x, y, z]] is needed: the smallest, then the largest of each axis")
    low, high = (_numbers(part, 3, largest) for part in node.items())
    for axis, least, most in zip("XYZ", low, high, strict=True):
        _check_order(node, axis, least, most)
    return list(zip(low, high, strict=True))


def _check_order(node: Node, name: str, low: float, high: float) -> None:
    if low > high:
        raise node.refuse(f"the minimum of {name} is more than its maximum: {low:g} > {high:g}")


def _pair(node: Node, largest: float) -> Range:
    low, high = _numbers(node, 2, largest)
    return low, high


def _numbers(node: Node, count: int, largest: float) -> tuple[float, ...]:
    if len(node.items()) != count:
        raise node.refuse(f"a list of {count} numbers is needed, not of {len(node.items())}")
    return tuple(part.number(-largest, largest) for part in node.items())
