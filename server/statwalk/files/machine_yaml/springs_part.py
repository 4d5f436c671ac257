"""Reads `springs` of a machine file.

springs:
  tail: {half_life: 0.15, frequency: 2, below: true}
  hat: {half_life: 0.08, weight: 0.5}
"""

from __future__ import annotations

from statwalk.files.machine_yaml import fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.spring_definition import SpringDefinition

SHORTEST, LONGEST, FASTEST = 0.001, 60.0, 30.0
KEYS = ("half_life", "frequency", "weight", "below")


def springs(node: Node | None) -> dict[str, SpringDefinition]:
    """Reads the springs by the joint on which each begins.

    :raises MachineError: when a field is unknown, missing or out of range.
    """
    entries = fields.mapping(node)
    if node is not None and len(entries) > fields.MOST_PARTS:
        raise node.refuse(f"there are {len(entries):,} springs; at most {fields.MOST_PARTS} are allowed")
    return {joint: _spring(entry) for joint, entry in entries.items()}


def _spring(node: Node) -> SpringDefinition:
    entries = node.entries(*KEYS)
    return SpringDefinition(
        line=node.line,
        half_life=fields.required(node, "half_life").number(SHORTEST, LONGEST),
        frequency=entries["frequency"].number(0, FASTEST) if "frequency" in entries else 0.0,
        weight=entries["weight"].number(0, 1) if "weight" in entries else 1.0,
        below=fields.truth(entries, "below"),
    )
