"""Reads the changes that a machine or character file makes to clips.

clips:
  march: {of: walk, seconds: 0.8, exaggerate: 1.3}
  salute-left: {of: salute, mirror: true, ease: ease-in-out}
  leap: {of: jump, anticipate: {amount: 0.3, seconds: 0.25}}
  drop: {of: land, squash: {joint: hips, stretch: {0: 1, 0.1: 0.7, 0.4: 1}}}
  calm: {of: captured, filter: {low_pass: 6, spikes: true}}
  stiff: {of: run, inbetween: switched}
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from statwalk.files.md2.md2_file import INBETWEENS
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.clip_definition import (
    AnticipateChange,
    ClipChange,
    ClipDefinition,
    EaseChange,
    ExaggerateChange,
    FilterChange,
    LengthChange,
    MirrorChange,
    SpeedChange,
    SquashChange,
    SwitchChange,
)
from statwalk.maths.easing import EASINGS
from statwalk.motion.filter_clip import HIGHEST_CUTOFF, Filter
from statwalk.motion.principles import anticipate, exaggerate, retime, squash

MOST_CLIPS, MOST_STRETCHES, MOST_JOINTS = 256, 1000, 256
LONGEST, MOST_FRAMES, FASTEST_RATE = 600.0, 100_000.0, 1000.0
FRAME_RATE = 24.0
"""frames per second, if a file says none"""


def clips(node: Node | None) -> dict[str, ClipDefinition]:
    """Reads `clips` of a machine file: clips made of the character's own, by name.

    :raises ContentError: when a change is unknown or its numbers are out of range.
    """
    if node is None or node.value == "":
        return {}
    entries = node.entries()
    if len(entries) > MOST_CLIPS:
        raise node.refuse(f"there are {len(entries):,} clips here; at most {MOST_CLIPS} are allowed")
    return {name: clip(entry) for name, entry in entries.items()}


def clip(node: Node) -> ClipDefinition:
    """Reads a clip made of another: `of`, and what to do.

    :raises ContentError: as `clips`.
    """
    entries = node.entries("of", "loop", *CHANGES)
    if "of" not in entries:
        raise node.refuse("a clip is made of another clip: of: walk")
    loop = entries["loop"].truth() if "loop" in entries else None
    return ClipDefinition(entries["of"].text(), changes(entries), node.line, loop)


def changes(entries: Mapping[str, Node]) -> tuple[ClipChange, ...]:
    """Reads the changes among a clip's entries, in their order.

    :raises ContentError: as `clips`.
    """
    read = (CHANGES[key](node) for key, node in entries.items() if key in CHANGES)
    return tuple(change for change in read if change is not None)


def _speed(node: Node) -> ClipChange:
    return SpeedChange(node.line, node.number(1 / retime.FASTEST, retime.FASTEST))


def _seconds(node: Node) -> ClipChange:
    return LengthChange(node.line, node.number(1e-3, LONGEST), 1.0)


def _frames(node: Node) -> ClipChange:
    """`frames: 12`, or `frames: {count: 12, rate: 30}`."""
    if not node.is_mapping:
        return LengthChange(node.line, node.number(1, MOST_FRAMES), FRAME_RATE)
    entries = _required(node, ("count",), ("rate",))
    rate = entries["rate"].number(1, FASTEST_RATE) if "rate" in entries else FRAME_RATE
    return LengthChange(node.line, entries["count"].number(1, MOST_FRAMES), rate)


def _ease(node: Node) -> ClipChange:
    if node.text() not in EASINGS:
        raise node.unknown("easing", node.text(), EASINGS)
    return EaseChange(node.line, node.text())


def _exaggerate(node: Node) -> ClipChange:
    if not node.is_mapping:
        return ExaggerateChange(node.line, node.number(0, exaggerate.MOST))
    entries = _required(node, ("factor",), ("joints",))
    return ExaggerateChange(node.line, entries["factor"].number(0, exaggerate.MOST), _joints(entries))


def _anticipate(node: Node) -> ClipChange:
    entries = _required(node, ("amount", "seconds"), ("joints",))
    amount = entries["amount"].number(0, anticipate.MOST_AMOUNT)
    seconds = entries["seconds"].number(1e-3, anticipate.MOST_SECONDS)
    return AnticipateChange(node.line, amount, seconds, _joints(entries))


def _squash(node: Node) -> ClipChange:
    entries = _required(node, ("joint", "stretch"), ("axis",))
    axis = entries["axis"].text() if "axis" in entries else "y"
    if axis not in squash.AXES:
        raise entries["axis"].unknown("axis", axis, squash.AXES)
    return SquashChange(node.line, entries["joint"].text(), axis, _stretch(entries["stretch"]))


def _stretch(node: Node) -> dict[float, float]:
    entries = node.entries()
    if not 0 < len(entries) <= MOST_STRETCHES:
        raise node.refuse(f"a stretch has 1 to {MOST_STRETCHES} factors by seconds, {{0: 1, 0.2: 0.8}}")
    factors: dict[float, float] = {}
    for key, value in entries.items():
        time = Node(key, node.key_lines[key], node.file, node.error).number(0, LONGEST)
        factors[time] = value.number(squash.SMALLEST, squash.LARGEST)
    return factors


def _mirror(node: Node) -> ClipChange | None:
    return MirrorChange(node.line) if node.truth() else None


def _filter(node: Node) -> ClipChange:
    wanted = read_filter(node)
    return FilterChange(node.line, wanted.low_pass, wanted.spikes)


def _inbetween(node: Node) -> ClipChange | None:
    if node.text() not in INBETWEENS:
        raise node.unknown("way from key to key", node.text(), INBETWEENS)
    return SwitchChange(node.line) if node.text() == "switched" else None


def read_filter(node: Node | None) -> Filter:
    """Reads `filter: {low_pass: 6, spikes: true}`; none filters nothing.

    :raises ContentError: when a key is unknown or its value is out of range.
    """
    entries = node.entries("low_pass", "spikes") if node is not None else {}
    low_pass = entries["low_pass"].number(0, HIGHEST_CUTOFF) if "low_pass" in entries else 0.0
    return Filter(low_pass, "spikes" in entries and entries["spikes"].truth())


def _joints(entries: Mapping[str, Node]) -> tuple[str, ...]:
    items = entries["joints"].items() if "joints" in entries else []
    if len(items) > MOST_JOINTS:
        raise entries["joints"].refuse(f"at most {MOST_JOINTS} joints are allowed")
    return tuple(item.text() for item in items)


def _required(node: Node, needed: Iterable[str], allowed: Iterable[str]) -> dict[str, Node]:
    entries = node.entries(*needed, *allowed)
    for key in needed:
        if key not in entries:
            raise node.refuse(f"the key `{key}` is missing")
    return entries


CHANGES: Mapping[str, Callable[[Node], ClipChange | None]] = {
    "speed": _speed,
    "seconds": _seconds,
    "frames": _frames,
    "ease": _ease,
    "exaggerate": _exaggerate,
    "anticipate": _anticipate,
    "squash": _squash,
    "mirror": _mirror,
    "filter": _filter,
    "inbetween": _inbetween,
}
