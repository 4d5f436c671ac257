"""Reads the inputs of a machine file: events, keys, parameters; also the defaults and the properties of its
table.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from statwalk.files.machine_yaml import cell_fields, fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.cell_definition import Defaults
from statwalk.machine.definition.machine_definition import (
    END,
    EventDefinition,
    KeyDefinition,
    ParameterDefinition,
    PropertyDefinition,
)

MOST_EVENTS = 4_096
LARGEST = 1e9
"""largest bound of a parameter"""
RESERVED = ("and", "or", "not", "true", "false", "pi", "if")
"""words of the condition language, which cannot be names of parameters"""


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


def keys(node: Node | None, inputs: Collection[str]) -> dict[str, KeyDefinition]:
    """Reads `{ArrowUp: {hold: FORWARD, release: STOP}}`."""
    return {name: key(entry, inputs) for name, entry in fields.mapping(node).items()}


def key(node: Node, inputs: Collection[str]) -> KeyDefinition:
    """Reads `{press: EVENT}` or `{hold: EVENT}` for the key going down, `release: EVENT` for the key coming
    up.
    """
    entries = node.entries("press", "hold", "release")
    sent = {kind: fields.chosen(event, "event", inputs) for kind, event in entries.items()}
    if ("press" in sent) == ("hold" in sent):
        raise node.refuse("a key needs either `press: EVENT` (once) or `hold: EVENT` (as long as it is down)")
    return KeyDefinition(sent.get("hold") or sent["press"], sent.get("release"), "hold" in sent, node.line)


def parameters(node: Node | None) -> dict[str, ParameterDefinition]:
    """Reads `{pace: {default: 1, min: 0.5, max: 2, smooth: 0.25}}`; conditions use the names of
    parameters.
    """
    definitions = {}
    for name, entry in fields.named(node, "parameter").items():
        if not name.isidentifier() or name in RESERVED:
            raise entry.refuse(
                f"{name[:40]!r} is no name for a parameter; use letters, digits and _, and no word of the "
                "condition language"
            )
        definitions[name] = parameter(entry)
    return definitions


def parameter(node: Node) -> ParameterDefinition:
    """Reads `{default: 1, min: 0.5, max: 2}`, and perhaps `smooth`: the seconds in which a new value is
    reached.

    :raises MachineError: when a field is missing, or `min` is more than `max`.
    """
    entries = node.entries("default", "min", "max", "smooth")
    if not {"default", "min", "max"} <= set(entries):
        raise node.refuse("a parameter needs `default`, `min` and `max`")
    lowest, highest = entries["min"].number(-LARGEST, LARGEST), entries["max"].number(-LARGEST, LARGEST)
    if lowest > highest:
        raise node.refuse(f"min {lowest:g} is more than max {highest:g}")
    smooth = fields.seconds(entries["smooth"]) if "smooth" in entries else 0.0
    return ParameterDefinition(entries["default"].number(lowest, highest), lowest, highest, node.line, smooth)


def properties(node: Node | None) -> Iterator[PropertyDefinition]:
    """Yields the properties, each of them a line of text."""
    for sentence in [] if node is None else node.items():
        yield PropertyDefinition(sentence.text(), sentence.line)
