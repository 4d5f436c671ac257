"""Readers that all parts of a machine file share: mappings of names, existing names, seconds, points, whole
numbers.
"""

from __future__ import annotations

from collections.abc import Iterable

from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.name_rule import NAME, refused_name

LONGEST_SECONDS = 60.0
FARTHEST = 1e6
"""largest coordinate in metres"""
MOST_PARTS = 256
"""most parameters, senses or colliders of a machine"""


def mapping(node: Node | None) -> dict[str, Node]:
    """Returns the entries of a mapping; none if the key is missing or empty."""
    return {} if node is None or node.value == "" else node.entries()


def named(node: Node | None, kind: str, most: int = MOST_PARTS) -> dict[str, Node]:
    """Returns the entries of a mapping whose keys are names.

    :raises MachineError: when a key is no valid name, or there are more than `most` entries.
    """
    entries = mapping(node)
    if node is None or not entries:
        return {}
    for name, line in node.key_lines.items():
        if not NAME.fullmatch(name):
            raise node.refuse(refused_name(name, kind), line)
    if len(entries) > most:
        raise node.refuse(f"there are {len(entries):,} entries here; at most {most:,} are allowed")
    return entries


def name(node: Node, kind: str) -> str:
    """Returns the value as a name.

    :raises MachineError: when the value is no valid name.
    """
    if not NAME.fullmatch(node.text()):
        raise node.refuse(refused_name(node.text(), kind))
    return node.text()


def chosen(node: Node, kind: str, names: Iterable[str]) -> str:
    """Returns the value, which must be one of `names`.

    :raises MachineError: when the name does not exist; the message has the most similar existing name.
    """
    if node.text() not in names:
        raise node.unknown(kind, node.text(), names)
    return node.text()


def required(node: Node, key: str) -> Node:
    """Returns the value of a required key.

    :raises MachineError: when the key is missing.
    """
    if key not in node.entries():
        raise node.refuse(f"the key `{key}` is missing")
    return node.entries()[key]


def seconds(node: Node) -> float:
    """Reads seconds from 0 to 60."""
    return node.number(0, LONGEST_SECONDS)


def truth(entries: dict[str, Node], key: str) -> bool:
    """Reads `true` or `false`; false if the key is missing."""
    return entries[key].truth() if key in entries else False


def point(node: Node) -> tuple[float, float, float]:
    """Reads `[x, y, z]` in metres.

    :raises MachineError: when the value is not a list of three numbers.
    """
    parts = node.items()
    if len(parts) != 3:
        raise node.refuse(f"three numbers are needed, [x, y, z], not {len(parts)}")
    x, y, z = (part.number(-FARTHEST, FARTHEST) for part in parts)
    return x, y, z


def whole(node: Node, lowest: int, highest: int) -> int:
    """Reads a whole number within its limits.

    :raises MachineError: when the value is no such number.
    """
    value = node.number(lowest, highest)
    if value != int(value):
        raise node.refuse(f"{node.text()[:40]!r} is no whole number")
    return int(value)
