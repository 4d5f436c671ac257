"""Reads `view` of a machine file: where states stand in the graph of a layer. It changes nothing else.

view:
  base:
    WALK: [120, 40]
"""

from __future__ import annotations

from statwalk.files.machine_yaml import fields
from statwalk.files.yaml.yaml_text import Node

View = dict[str, dict[str, tuple[float, float]]]


def view(node: Node | None) -> View:
    """Reads the places by layer and state; names of what is not there any more are allowed.

    :raises MachineError: when a place is not two numbers.
    """
    return {
        layer: {state: _place(place) for state, place in fields.mapping(entry).items()}
        for layer, entry in fields.mapping(node).items()
    }


def _place(node: Node) -> tuple[float, float]:
    parts = node.items()
    if len(parts) != 2:
        raise node.refuse(f"a place in the graph is two numbers, [x, y], not {len(parts)}")
    x, y = (part.number(-fields.FARTHEST, fields.FARTHEST) for part in parts)
    return x, y
