"""A state of a machine file and its motion: a clip, a blend of clips over parameters, or none."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from statwalk.files.machine import fields
from statwalk.files.yamltext import Node
from statwalk.machine.authored.definition import NO_MOTION, BlendDefinition, ParameterDefinition, StateDefinition
from statwalk.machine.built.build import LARGEST_SPEED

STATE_KEYS = ("motion", "loop", "speed", "markers", "final")
NONE = "none"
MOST_CLIPS = 64
MOST_MARKERS = 256


def state(node: Node, outer: str, parameters: Mapping[str, ParameterDefinition]) -> StateDefinition:
    """`{motion: walk, loop: true, speed: 1.5, markers: {left-down: 0.05}}`; the speed may be a parameter."""
    entries = node.entries(*STATE_KEYS)
    if "motion" not in entries:
        raise node.refuse("a state needs a motion: `{motion: NAME}`, or a machine of its own: `{machine: {…}}`")
    if "final" in entries and not outer:
        raise entries["final"].refuse("`final` is for the states of a sub-machine")
    return StateDefinition(
        motion=motion(entries["motion"], parameters),
        line=node.line,
        loop=entries["loop"].truth() if "loop" in entries else None,
        speed=speed(entries["speed"]) if "speed" in entries else 1.0,
        markers=markers(entries.get("markers")),
        outer=outer,
        final=fields.truth(entries, "final"),
    )


def motion(node: Node, parameters: Mapping[str, ParameterDefinition]) -> str | BlendDefinition:
    """A clip's name, `none`, or a blend: `{over: speed, clips: {walk: 1.4, run: 3.2}, markers: {walk: {left-down: 0.1}, …}}`."""
    if node.is_text:
        if not node.text():
            raise node.refuse("a motion is the name of a clip, a blend, or none")
        return NO_MOTION if node.text() == NONE else node.text()
    entries = node.entries("over", "clips", "markers")
    over, clips = fields.required(node, "over"), fields.required(node, "clips")
    axes = [over] if over.is_text else over.items()
    names = tuple(fields.chosen(one, "parameter", parameters) for one in axes)
    if not 1 <= len(set(names)) == len(names) <= 2:
        raise entries["over"].refuse("a blend is over one parameter, or over two that differ")
    found = points(clips, len(names))
    return BlendDefinition(names, found, node.line, sync_markers(entries.get("markers"), found))


def sync_markers(node: Node | None, clips: Collection[str]) -> dict[str, dict[str, float]]:
    """For each clip of a blend, phases 0…1 of named moments; raises MachineError for what is none of its clips."""
    found = {}
    for name, one in fields.mapping(node).items():
        if node is not None and name not in clips:
            raise node.unknown("clip of the blend", name, clips, node.key_lines[name])
        found[name] = markers(one)
    return found


def points(node: Node, axes: int) -> dict[str, tuple[float, ...]]:
    """For each clip where it stands: one number for each parameter; raises MachineError where two stand on the same spot."""
    found: dict[str, tuple[float, ...]] = {}
    for name, one in node.entries().items():
        parts = [one] if one.is_text else one.items()
        if len(parts) != axes:
            raise one.refuse(f"the clip {name[:40]} needs {axes} {'number' if axes == 1 else 'numbers'}, one for each parameter")
        where = tuple(part.number(-fields.FARTHEST, fields.FARTHEST) for part in parts)
        same = next((other for other, there in found.items() if there == where), None)
        if same is not None:
            raise one.refuse(f"the clips {same[:40]} and {name[:40]} stand on the same spot")
        found[name] = where
    if not 2 <= len(found) <= MOST_CLIPS:
        raise node.refuse(f"a blend is of 2 to {MOST_CLIPS} clips, not {len(found)}")
    return found


def markers(node: Node | None) -> dict[str, float]:
    """Phases 0…1 of named moments."""
    return {name: one.number(0, 1) for name, one in fields.named(node, "marker", MOST_MARKERS).items()}


def speed(node: Node) -> float | str:
    """A factor from 0 to 100, or a parameter's name."""
    return node.text() if node.text().isidentifier() else node.number(0, LARGEST_SPEED)
