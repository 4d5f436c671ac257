"""Reads a state of a machine file and its motion: a clip, a blend of clips over parameters, or none."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Final, Literal

from statwalk.files.expressions import motion_of_expressions
from statwalk.files.machine_yaml import fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.compile.compile_machine import LARGEST_SPEED
from statwalk.machine.conditions.variables import ENTRY
from statwalk.machine.definition.expression_definition import ExpressionMotion
from statwalk.machine.definition.framing import FRAMINGS, Framing
from statwalk.machine.definition.machine_definition import (
    NO_MOTION,
    BlendDefinition,
    StateDefinition,
)
from statwalk.machine.definition.parameter_definition import ParameterDefinition

STATE_KEYS = ("motion", "loop", "speed", "ground_speed", "markers", "final", "framing")
NONE = "none"
MOST_CLIPS = 64
MOST_MARKERS = 256
FOUND: Final = "found"
FASTEST = 100.0
"""metres a second over the ground"""


def state(node: Node, composite: str, parameters: Mapping[str, ParameterDefinition]) -> StateDefinition:
    """Reads `{motion: walk, loop: true, speed: 1.5, markers: {left-down: 0.05}, framing: face}`; the
    speed may be a parameter.

    :raises MachineError: when a field is missing or wrong.
    """
    entries = node.entries(*STATE_KEYS)
    if "motion" not in entries:
        raise node.refuse(
            "a state needs a motion: `{motion: NAME}`, or a machine of its own: `{machine: {…}}`"
        )
    if "final" in entries and not composite:
        raise entries["final"].refuse("`final` is only for states of a sub-machine")
    return StateDefinition(
        motion=motion(entries["motion"], parameters),
        line=node.line,
        loop=entries["loop"].truth() if "loop" in entries else None,
        speed=speed(entries["speed"]) if "speed" in entries else 1.0,
        ground_speed=ground_speed(entries["ground_speed"]) if "ground_speed" in entries else None,
        markers=markers(entries.get("markers")),
        composite=composite,
        final=fields.truth(entries, "final"),
        framing=framing(entries["framing"]) if "framing" in entries else None,
    )


def framing(node: Node) -> Framing:
    """Reads what the viewer's camera shows: `whole`, `upper body`, `face` or `wide`.

    :raises MachineError: when the value is none of these.
    """
    by_name: dict[str, Framing] = dict(zip(FRAMINGS, FRAMINGS, strict=True))
    return by_name[fields.chosen(node, "framing", FRAMINGS)]


def motion(
    node: Node, parameters: Mapping[str, ParameterDefinition]
) -> str | BlendDefinition | ExpressionMotion:
    """Reads a clip's name, `none`, a pose driven by expressions, `{expressions: …}`, or a blend: `{over:
    speed, clips: {walk: 1.4, run: 3.2}, markers: {walk: {left-down: 0.1}, …}}`; `over` names
    parameters, or values at the entry of the state, as `entry speed`.
    """
    if node.is_text:
        if not node.text():
            raise node.refuse("a motion is the name of a clip, a blend, or `none`")
        return NO_MOTION if node.text() == NONE else node.text()
    if "expressions" in node.entries():
        return motion_of_expressions(node.entries("expressions")["expressions"], parameters)
    entries = node.entries("over", "clips", "markers")
    over, clips = fields.required(node, "over"), fields.required(node, "clips")
    axes = [over] if over.is_text else over.items()
    names = tuple(fields.chosen(axis, "parameter", (*parameters, *ENTRY)) for axis in axes)
    if not 1 <= len(set(names)) == len(names) <= 2:
        raise entries["over"].refuse("a blend is over one parameter, or over two different parameters")
    clip_points = points(clips, len(names))
    return BlendDefinition(names, clip_points, node.line, _sync_markers(entries.get("markers"), clip_points))


def _sync_markers(node: Node | None, clips: Collection[str]) -> dict[str, dict[str, float]]:
    """Reads for each clip of a blend the phases 0…1 of its markers."""
    markers_of_clip = {}
    for name, entry in fields.mapping(node).items():
        if node is not None and name not in clips:
            raise node.unknown("clip of the blend", name, clips, node.key_lines[name])
        markers_of_clip[name] = markers(entry)
    return markers_of_clip


def points(node: Node, axes: int) -> dict[str, tuple[float, ...]]:
    """Reads the point of each clip of a blend: one number for each parameter.

    :raises MachineError: when two clips have the same point, a point has too few or too many numbers, or
        there are too few or too many clips.
    """
    point_of_clip: dict[str, tuple[float, ...]] = {}
    for name, entry in node.entries().items():
        parts = [entry] if entry.is_text else entry.items()
        if len(parts) != axes:
            raise entry.refuse(
                f"the clip {name[:40]} needs {axes} {'number' if axes == 1 else 'numbers'}, one for each "
                "parameter"
            )
        point = tuple(part.number(-fields.FARTHEST, fields.FARTHEST) for part in parts)
        same_clip = next((clip for clip, clip_point in point_of_clip.items() if clip_point == point), None)
        if same_clip is not None:
            raise entry.refuse(
                f"the clips {same_clip[:40]} and {name[:40]} have the same values of the parameters"
            )
        point_of_clip[name] = point
    if not 2 <= len(point_of_clip) <= MOST_CLIPS:
        raise node.refuse(f"a blend has 2 to {MOST_CLIPS} clips, not {len(point_of_clip)}")
    return point_of_clip


def markers(node: Node | None) -> dict[str, float]:
    """Reads phases 0…1 of markers."""
    return {name: phase.number(0, 1) for name, phase in fields.named(node, "marker", MOST_MARKERS).items()}


def speed(node: Node) -> float | str:
    """Reads a factor from 0 to 100, or a parameter's name."""
    return node.text() if node.text().isidentifier() else node.number(0, LARGEST_SPEED)


def ground_speed(node: Node) -> tuple[float, float] | Literal["found"]:
    """Reads `found`, metres a second forward, or `[x, z]` in metres a second.

    :raises MachineError: when the value is none of these.
    """
    if not node.is_text:
        parts = node.items()
        if len(parts) != 2:
            raise node.refuse(f"two numbers are needed, [x, z], not {len(parts)}")
        x, z = (part.number(-FASTEST, FASTEST) for part in parts)
        return x, z
    if node.text()[:1].isalpha() and node.text() != FOUND:
        raise node.refuse(f"{node.text()[:40]!r} is no ground speed: `found`, metres a second, or [x, z]")
    return FOUND if node.text() == FOUND else (0.0, node.number(-FASTEST, FASTEST))
