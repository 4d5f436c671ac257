"""Reads the fields of a cell, or of one of its alternatives: timing, blend, entry phase, action."""

from __future__ import annotations

import math
import re

from statwalk.files.machine_yaml import fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.cell_definition import (
    AT_END,
    NOW,
    ActionDefinition,
    CellTiming,
    Curve,
    Enter,
)
from statwalk.machine.definition.name_rule import NAME

TIMINGS = ("now", "end", "marker NAME", "window A..B")
WINDOW = re.compile(r"([0-9.]+)\.\.([0-9.]+)")
LONGEST_ACTION = 100
MOST_ARGUMENTS = 8
RAISE = "raise"


def when(node: Node) -> CellTiming:
    """Reads `now`, `end`, `marker NAME` or `window A..B`, with phases 0…1.

    :raises MachineError: when the text is no moment.
    """
    kind, _, rest = node.text().partition(" ")
    match kind, rest.strip():
        case "now", "":
            return NOW
        case "end", "":
            return AT_END
        case "marker", name if NAME.fullmatch(name):
            return CellTiming("marker", marker=name)
        case "window", bounds:
            return window(node, bounds)
    raise node.unknown("moment", node.text(), TIMINGS)


def window(node: Node, bounds: str) -> CellTiming:
    """Reads `0.2..0.6`, a window of the motion's phase; if the first bound is the greater, the window lies
    across the seam of a loop.

    :raises MachineError: when the text is no window.
    """
    match = WINDOW.fullmatch(bounds)
    try:
        first, last = (float(bound) for bound in match.groups()) if match else (math.nan, math.nan)
    except ValueError:
        first = last = math.nan
    if not (0 <= first <= 1 and 0 <= last <= 1 and first != last):
        raise node.refuse(
            f"`window {bounds[:40]}`: a window is written A..B with two phases from 0 to 1, as in `window "
            "0.2..0.6`"
        )
    return CellTiming("window", first=first, last=last)


def blend(node: Node) -> tuple[float | None, Curve | None]:
    """Reads seconds, or `{seconds: 0.1, curve: quintic}`; returns None for a missing part."""
    if node.is_text:
        return fields.seconds(node), None
    entries = node.entries("seconds", "curve")
    return fields.seconds(entries["seconds"]) if "seconds" in entries else None, curve(
        entries["curve"]
    ) if "curve" in entries else None


def curve(node: Node) -> Curve:
    """Reads `cubic` or `quintic`."""
    return "quintic" if fields.chosen(node, "curve", ("cubic", "quintic")) == "quintic" else "cubic"


def enter(node: Node) -> Enter:
    """Reads a phase from 0 to 1, or `match`."""
    return "match" if node.text() == "match" else node.number(0, 1)


def action(node: Node) -> ActionDefinition:
    """Reads `drop`, or with arguments `drop(coins, 3)`.

    :raises MachineError: when the text is no action, or a `raise` does not have two words as arguments.
    """
    text = node.text().strip()
    before_bracket, bracket, rest = text.partition("(")
    name = before_bracket.strip()
    if (
        not name
        or len(text) > LONGEST_ACTION
        or not text.isprintable()
        or (bracket and not rest.endswith(")"))
    ):
        raise node.refuse(
            f"{text[:40]!r} is no action: a name, perhaps with arguments as in drop(coins, 3), of 1 to "
            f"{LONGEST_ACTION} letters"
        )
    inside = rest[:-1].strip()
    arguments = [_argument(node, part.strip()) for part in inside.split(",")] if inside else []
    if len(arguments) > MOST_ARGUMENTS:
        raise node.refuse(f"{name[:40]} has {len(arguments)} arguments; at most {MOST_ARGUMENTS} are allowed")
    if name == RAISE and not (len(arguments) == 2 and all(isinstance(part, str) for part in arguments)):
        raise node.refuse(
            "`raise` is written raise(EVENT, WHOM), where WHOM is other, all, or an actor's name"
        )
    return ActionDefinition(name, tuple(arguments))


def _argument(node: Node, text: str) -> str | float:
    if not text or any(letter in text for letter in "()"):
        raise node.refuse(f"{text[:40]!r} is no argument; write numbers and words with commas between them")
    try:
        value = float(text) if "_" not in text else math.nan
    except ValueError:
        value = math.nan
    return value if math.isfinite(value) else text
