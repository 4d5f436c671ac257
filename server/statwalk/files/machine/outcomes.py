"""What a cell, or one of its alternatives, says of the way to the next state: moment, blend, phase to enter at, action, condition."""

from __future__ import annotations

import math
import re

from statwalk.files.machine import fields
from statwalk.files.yamltext import Node
from statwalk.machine.authored.celldefinition import AT_END, NOW, ActionDefinition, Curve, Enter, Moment
from statwalk.machine.authored.table import NAME

MOMENTS = ("now", "end", "marker NAME", "window A..B")
WINDOW = re.compile(r"([0-9.]+)\.\.([0-9.]+)")
LONGEST_ACTION = 100
MOST_ARGUMENTS = 8
RAISE = "raise"


def when(node: Node) -> Moment:
    """`now`, `end`, `marker NAME` or `window A..B`, with phases 0…1; raises MachineError for any other moment."""
    kind, _, rest = node.text().partition(" ")
    match kind, rest.strip():
        case "now", "":
            return NOW
        case "end", "":
            return AT_END
        case "marker", name if NAME.fullmatch(name):
            return Moment("marker", marker=name)
        case "window", bounds:
            return window(node, bounds)
    raise node.unknown("moment", node.text(), MOMENTS)


def window(node: Node, bounds: str) -> Moment:
    """`0.2..0.6`: a window of the motion's phase; the first may be the greater where it lies across the seam of a loop."""
    match = WINDOW.fullmatch(bounds)
    try:
        first, last = (float(one) for one in match.groups()) if match else (math.nan, math.nan)
    except ValueError:
        first = last = math.nan
    if not (0 <= first <= 1 and 0 <= last <= 1 and first != last):
        raise node.refuse(f"`window {bounds[:40]}`: a window is written A..B with two phases from 0 to 1, as in `window 0.2..0.6`")
    return Moment("window", first=first, last=last)


def blend(node: Node) -> tuple[float | None, Curve | None]:
    """Seconds, or `{seconds: 0.1, curve: quintic}`; None for what is not said."""
    if node.is_text:
        return fields.seconds(node), None
    entries = node.entries("seconds", "curve")
    return fields.seconds(entries["seconds"]) if "seconds" in entries else None, curve(entries["curve"]) if "curve" in entries else None


def curve(node: Node) -> Curve:
    """`cubic` or `quintic`."""
    return "quintic" if fields.chosen(node, "curve", ("cubic", "quintic")) == "quintic" else "cubic"


def enter(node: Node) -> Enter:
    """A phase from 0 to 1, or `match`."""
    return "match" if node.text() == "match" else node.number(0, 1)


def action(node: Node) -> ActionDefinition:
    """`drop`, or with arguments `drop(coins, 3)`; raises MachineError for what is none, and where `raise` has not its two."""
    text = node.text().strip()
    head, bracket, rest = text.partition("(")
    name = head.strip()
    if not name or len(text) > LONGEST_ACTION or not text.isprintable() or (bracket and not rest.endswith(")")):
        raise node.refuse(
            f"{text[:40]!r} is no action: a name, perhaps with arguments as in drop(coins, 3), of 1 to {LONGEST_ACTION} letters"
        )
    inside = rest[:-1].strip()
    parts = [argument(node, part.strip()) for part in inside.split(",")] if inside else []
    if len(parts) > MOST_ARGUMENTS:
        raise node.refuse(f"{name[:40]} has {len(parts)} arguments; at most {MOST_ARGUMENTS} can be read")
    if name == RAISE and not (len(parts) == 2 and all(isinstance(part, str) for part in parts)):
        raise node.refuse("`raise` is written raise(EVENT, WHOM), where WHOM is other, all, or an actor's name")
    return ActionDefinition(name, tuple(parts))


def argument(node: Node, text: str) -> str | float:
    """A finite number, or a word."""
    if not text or any(letter in text for letter in "()"):
        raise node.refuse(f"{text[:40]!r} is no argument: numbers and words, with commas between")
    try:
        value = float(text) if "_" not in text else math.nan
    except ValueError:
        value = math.nan
    return value if math.isfinite(value) else text
