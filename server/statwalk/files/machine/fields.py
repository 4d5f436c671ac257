"""What all parts of a machine file share: mappings of names, names that must exist, seconds, shares, points."""

from __future__ import annotations

from collections.abc import Iterable

from statwalk.files.yamltext import Node
from statwalk.machine.authored.table import NAME

LONGEST_SECONDS = 60.0
FARTHEST = 1e6
"""metres"""
MOST_PARTS = 256
"""parameters, senses, colliders, keys or layers"""


def mapping(node: Node | None) -> dict[str, Node]:
    """The entries; none where the key is missing or empty."""
    return {} if node is None or node.value == "" else node.entries()


def named(node: Node | None, kind: str, most: int = MOST_PARTS) -> dict[str, Node]:
    """The entries of a mapping whose keys are names; raises MachineError for a key that cannot be one, or for too many."""
    entries = mapping(node)
    if node is None or not entries:
        return {}
    for name, line in node.key_lines.items():
        if not NAME.fullmatch(name):
            raise node.refuse(f"{name[:40]!r} is no name for the {kind}: letters, digits and _, then also . -", line)
    if len(entries) > most:
        raise node.refuse(f"there are {len(entries):,} of them; at most {most:,} can be read")
    return entries


def name(node: Node, kind: str) -> str:
    """A name; raises MachineError for what cannot be one."""
    if not NAME.fullmatch(node.text()):
        raise node.refuse(f"{node.text()[:40]!r} is no name for the {kind}: letters, digits and _, then also . -")
    return node.text()


def chosen(node: Node, kind: str, known: Iterable[str]) -> str:
    """A name that must exist; raises MachineError with the nearest that does."""
    if node.text() not in known:
        raise node.unknown(kind, node.text(), known)
    return node.text()


def required(node: Node, key: str) -> Node:
    """The value of a key that must be there."""
    if key not in node.entries():
        raise node.refuse(f"the key `{key}` is missing")
    return node.entries()[key]


def seconds(node: Node) -> float:
    """Seconds from 0 to 60."""
    return node.number(0, LONGEST_SECONDS)


def truth(entries: dict[str, Node], key: str) -> bool:
    """`true` or `false`; false where the key is missing."""
    return entries[key].truth() if key in entries else False


def point(node: Node) -> tuple[float, float, float]:
    """`[x, y, z]` in metres; raises MachineError for anything else."""
    parts = node.items()
    if len(parts) != 3:
        raise node.refuse(f"three numbers are wanted, [x, y, z], not {len(parts)}")
    x, y, z = (one.number(-FARTHEST, FARTHEST) for one in parts)
    return x, y, z


def whole(node: Node, lowest: int, highest: int) -> int:
    """A whole number within its limits."""
    value = node.number(lowest, highest)
    if value != int(value):
        raise node.refuse(f"{node.text()[:40]!r} is no whole number")
    return int(value)
