"""What comes from outside, as a machine file says it: events, keys, parameters; and the defaults and properties of its table."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from statwalk.files.machine import fields, outcomes
from statwalk.files.yamltext import Node
from statwalk.machine.authored.celldefinition import Defaults
from statwalk.machine.authored.definition import END, EventDefinition, KeyDefinition, ParameterDefinition, PropertyDefinition

MOST_EVENTS = 4_096
LARGEST = 1e9
"""bounds of a parameter"""
RESERVED = ("and", "or", "not", "true", "false", "pi", "if")
"""words of the conditions, which no parameter can be called"""


def events(node: Node | None) -> dict[str, EventDefinition]:
    """`{JUMP: {buffer: 0.5}}`: inputs beside the columns of the table, or more about them; buffers in seconds."""
    found = {}
    for name, one in fields.named(node, "event", MOST_EVENTS).items():
        if name == END:
            raise one.refuse("END is no input: motions raise it")
        entries = one.entries("buffer") if one.value != "" else {}
        found[name] = EventDefinition(one.line, fields.seconds(entries["buffer"]) if "buffer" in entries else None)
    return found


def defaults(node: Node | None) -> Defaults:
    """`{when: now, blend: 0.2, buffer: 0.3}`; blend (perhaps with its curve) and buffer in seconds."""
    if node is None:
        return Defaults()
    entries, standard = node.entries("when", "blend", "buffer"), Defaults()
    blend, curve = outcomes.blend(entries["blend"]) if "blend" in entries else (None, None)
    return Defaults(
        when=outcomes.when(entries["when"]) if "when" in entries else standard.when,
        blend=standard.blend if blend is None else blend,
        curve=curve or standard.curve,
        buffer=fields.seconds(entries["buffer"]) if "buffer" in entries else standard.buffer,
    )


def keys(node: Node | None, inputs: Collection[str]) -> dict[str, KeyDefinition]:
    """`{ArrowUp: {hold: FORWARD, release: STOP}}`."""
    return {name: key(one, inputs) for name, one in fields.mapping(node).items()}


def key(node: Node, inputs: Collection[str]) -> KeyDefinition:
    """`{press: EVENT}` or `{hold: EVENT}` when it goes down, `release: EVENT` when it comes up."""
    entries = node.entries("press", "hold", "release")
    sent = {kind: fields.chosen(one, "event", inputs) for kind, one in entries.items()}
    if ("press" in sent) == ("hold" in sent):
        raise node.refuse("a key needs either `press: EVENT` (once) or `hold: EVENT` (as long as it is down)")
    return KeyDefinition(sent.get("hold") or sent["press"], sent.get("release"), "hold" in sent, node.line)


def parameters(node: Node | None) -> dict[str, ParameterDefinition]:
    """`{pace: {default: 1, min: 0.5, max: 2, smooth: 0.25}}`; conditions speak of them by name."""
    found = {}
    for name, one in fields.named(node, "parameter").items():
        if not name.isidentifier() or name in RESERVED:
            raise one.refuse(f"{name[:40]!r} is no name for a parameter: letters, digits and _, and no word of the conditions")
        found[name] = parameter(one)
    return found


def parameter(node: Node) -> ParameterDefinition:
    """`{default: 1, min: 0.5, max: 2}`, and perhaps `smooth`, the seconds in which a new value is reached."""
    entries = node.entries("default", "min", "max", "smooth")
    if not {"default", "min", "max"} <= set(entries):
        raise node.refuse("a parameter needs `default`, `min` and `max`")
    lowest, highest = entries["min"].number(-LARGEST, LARGEST), entries["max"].number(-LARGEST, LARGEST)
    if lowest > highest:
        raise node.refuse(f"min {lowest:g} is more than max {highest:g}")
    smooth = fields.seconds(entries["smooth"]) if "smooth" in entries else 0.0
    return ParameterDefinition(entries["default"].number(lowest, highest), lowest, highest, node.line, smooth)


def sentences(node: Node | None) -> Iterator[PropertyDefinition]:
    """The properties, each a line of text."""
    for one in [] if node is None else node.items():
        yield PropertyDefinition(one.text(), one.line)
