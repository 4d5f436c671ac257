"""Reads `feet` and `contacts` of a machine file.

feet: {left: {hip: thigh.L, knee: shin.L, ankle: foot.L, toe: toe.L}}
contacts: {walk: {left: [[0, 0.6]], right: [[0.5, 1.1]]}}
"""

from __future__ import annotations

from statwalk.files.machine_yaml import fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.feet_definition import ContactDefinition, FootDefinition, Span

MOST_FEET, MOST_SPANS = 16, 64


def feet(node: Node | None) -> dict[str, FootDefinition]:
    """Reads the legs of a machine; none if the file has none.

    :raises MachineError: when a leg names no ankle, or has an unknown key.
    """
    return {name: _foot(entry) for name, entry in fields.named(node, "foot", MOST_FEET).items()}


def _foot(node: Node) -> FootDefinition:
    entries = node.entries("hip", "knee", "ankle", "toe")
    names = {key: entry.text() for key, entry in entries.items()}
    return FootDefinition(node.line, **{"ankle": fields.required(node, "ankle").text(), **names})


def contacts(node: Node | None) -> dict[str, dict[str, ContactDefinition]]:
    """Reads the contacts of clips, by clip and foot.

    :raises MachineError: when a span is no pair of phases, first 0…1, last after it by at most 1.
    """
    return {
        clip: {foot: _contact(spans) for foot, spans in fields.mapping(entry).items()}
        for clip, entry in fields.mapping(node).items()
    }


def _contact(node: Node) -> ContactDefinition:
    spans = node.items()
    if len(spans) > MOST_SPANS:
        raise node.refuse(f"a foot has at most {MOST_SPANS} contacts in a clip, not {len(spans)}")
    return ContactDefinition(tuple(_span(span) for span in spans), node.line)


def _span(node: Node) -> Span:
    ends = node.items()
    if len(ends) != 2:
        raise node.refuse(f"a contact is two phases, [first, last], not {len(ends)}")
    first, last = ends[0].number(0, 1), ends[1].number(0, 2)
    if not first < last <= first + 1:
        raise node.refuse(f"a contact ends after it begins, within one lap: [{first:g}, {last:g}] does not")
    return first, last
