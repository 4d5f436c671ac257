"""Reads the inputs of a machine file: events and keys; also the defaults and the properties of its
table.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from statwalk.files.machine_yaml import cell_fields, fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.cell_definition import Defaults
from statwalk.machine.definition.machine_definition import (
    END,
    EventDefinition,
    KeyDefinition,
    PropertyDefinition,
)
from statwalk.machine.definition.parameter_definition import ParameterDefinition

MOST_EVENTS = 4_096
ANY_STATE = "*"
FASTEST = 1e6
"""units a second"""


def events(node: Node | None) -> dict[str, EventDefinition]:
    """Reads `{JUMP: {buffer: 0.5}}`: events that the table has no column for, or buffers of events in
    seconds.
    """
    definitions = {}
    for name, event in fields.named(node, "event", MOST_EVENTS).items():
        if name == END:
            raise event.refuse("END cannot be sent: the end of a motion raises it")
        entries = event.entries("buffer") if event.value != "" else {}
        definitions[name] = EventDefinition(
            event.line, fields.seconds(entries["buffer"]) if "buffer" in entries else None
        )
    return definitions


def defaults(node: Node | None) -> Defaults:
    """Reads `{when: now, blend: 0.2, buffer: 0.3}`; blend (also with a curve) and buffer in seconds."""
    if node is None:
        return Defaults()
    entries, standard = node.entries("when", "blend", "buffer"), Defaults()
    blend, curve = cell_fields.blend(entries["blend"]) if "blend" in entries else (None, None)
    return Defaults(
        when=cell_fields.when(entries["when"]) if "when" in entries else standard.when,
        blend=standard.blend if blend is None else blend,
        curve=curve or standard.curve,
        buffer=fields.seconds(entries["buffer"]) if "buffer" in entries else standard.buffer,
    )


def keys(
    node: Node | None,
    inputs: Collection[str],
    parameters: Mapping[str, ParameterDefinition],
    states: Collection[str],
) -> dict[str, KeyDefinition]:
    """Reads `{ArrowUp: {hold: FORWARD, release: STOP}}`; `states`: of all layers, with composites."""
    return {name: key(entry, inputs, parameters, states) for name, entry in fields.mapping(node).items()}


def key(
    node: Node,
    inputs: Collection[str],
    parameters: Mapping[str, ParameterDefinition],
    states: Collection[str],
) -> KeyDefinition:
    """Reads `{press: EVENT}` or `{hold: EVENT}` for the key going down, `release: EVENT` for the key coming
    up; or `{change: {STATE: {PARAMETER: 0.5}}}`, units a second while the key is down.
    """
    entries = node.entries("press", "hold", "release", "change")
    if "change" in entries:
        if len(entries) > 1:
            raise node.refuse("a key that changes parameters sends no events: leave `change` alone")
        change = _change(entries["change"], parameters, states)
        return KeyDefinition(None, None, False, node.line, change)
    sent = {kind: fields.chosen(event, "event", inputs) for kind, event in entries.items()}
    if ("press" in sent) == ("hold" in sent):
        raise node.refuse(
            "a key needs `press: EVENT` (once), `hold: EVENT` (as long as it is down) or `change: …`"
        )
    return KeyDefinition(sent.get("hold") or sent["press"], sent.get("release"), "hold" in sent, node.line)


def _change(
    node: Node, parameters: Mapping[str, ParameterDefinition], states: Collection[str]
) -> dict[str, dict[str, float]]:
    entries = fields.mapping(node)
    if not entries:
        raise node.refuse("`change` needs a state, or '*', and the parameters that move: {REACH: {aim.x: 1}}")
    for state, entry in entries.items():
        if state not in states and state != ANY_STATE:
            raise entry.unknown("state", state, states)
    return {state: _rates(entry, parameters) for state, entry in entries.items()}


def _rates(node: Node, parameters: Mapping[str, ParameterDefinition]) -> dict[str, float]:
    movable = {name: known for name, known in parameters.items() if known.kind in ("number", "point")}
    for name, entry in fields.mapping(node).items():
        if name not in movable:
            raise entry.unknown("number, or component of a point,", name, movable)
    return {name: entry.number(-FASTEST, FASTEST) for name, entry in fields.mapping(node).items()}


def properties(node: Node | None) -> Iterator[PropertyDefinition]:
    """Yields the properties, each of them a line of text."""
    for sentence in [] if node is None else node.items():
        yield PropertyDefinition(sentence.text(), sentence.line)
