"""Reads `chains` of a machine file.

chains:
  cable: {joints: {from: Link01, to: Anchor}, mass: 6}
  bridge: {joints: {from: Plank01, to: Plank20}, anchor: [Plank01, Plank20], gravity: 9.81, half_life: 0.5}
"""

from __future__ import annotations

from statwalk.files.machine_yaml import fields
from statwalk.files.machine_yaml.solvers_part import joints_of_chain
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.chain_definition import ChainDefinition

KEYS = ("joints", "anchor", "gravity", "half_life", "mass")
MOST_CHAINS = 32
STRONGEST, SHORTEST, LONGEST, LIGHTEST, HEAVIEST = 1_000.0, 0.001, 3_600.0, 0.01, 1_000.0


def chains(node: Node | None) -> dict[str, ChainDefinition]:
    """Reads the hanging chains by name, in the order in which they hang.

    :raises MachineError: when a field is unknown, missing or out of range.
    """
    return {name: _chain(entry) for name, entry in fields.named(node, "chain", MOST_CHAINS).items()}


def _chain(node: Node) -> ChainDefinition:
    entries = node.entries(*KEYS)
    standard = ChainDefinition(node.line, ())
    gravity, half_life, mass = entries.get("gravity"), entries.get("half_life"), entries.get("mass")
    return ChainDefinition(
        line=node.line,
        joints=joints_of_chain(fields.required(node, "joints")),
        anchors=_anchors(entries["anchor"]) if "anchor" in entries else (),
        gravity=gravity.number(-STRONGEST, STRONGEST) if gravity else standard.gravity,
        half_life=half_life.number(SHORTEST, LONGEST) if half_life else standard.half_life,
        mass=mass.number(LIGHTEST, HEAVIEST) if mass else standard.mass,
    )


def _anchors(node: Node) -> tuple[str, ...]:
    """A joint, or two."""
    if not isinstance(node.value, list):
        return (node.text(),)
    if not 0 < len(node.items()) <= 2:
        raise node.refuse(f"a chain has one anchor or two, not {len(node.items())}")
    return tuple(joint.text() for joint in node.items())
