"""Compiles states to arrays: their motions, durations, markers, speeds, and the composite states
around them.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from statwalk.machine.compile.resolve_defaults import enclosing
from statwalk.machine.conditions.variables import ENTRY
from statwalk.machine.definition.machine_definition import (
    BlendDefinition,
    MachineDefinition,
    StateDefinition,
    nearest,
)
from statwalk.maths.blend_tables import BlendedClip
from statwalk.maths.phases import Marks, warp

LARGEST_SPEED = 100.0


@dataclass(frozen=True)
class MotionFacts:
    """The facts about a motion that a machine needs; seconds.

    `loop` None: the motion's file does not define it. `markers`: name and seconds from the motion's start.
    """

    duration: float
    loop: bool | None = None
    markers: tuple[tuple[str, float], ...] = ()


def state_arrays(
    tables: Mapping[str, MachineDefinition], motions: Mapping[str, MotionFacts]
) -> dict[str, Any]:
    """Returns the fields of Machine that describe the S states of all layers, the base first.

    :raises MachineError: when a motion or parameter does not exist, or a speed may leave 0…100.
    """
    _check_blends(tables)
    states = [(table, name, state) for table in tables.values() for name, state in table.states.items()]
    used = _motions_used(tables, motions)
    speeds = [_speed_of(table, name) for table, name, _ in states]
    histories = tuple(
        (layer, name)
        for layer, table in tables.items()
        for name, composite in table.composites.items()
        if composite.resume
    )
    return {
        "states": tuple(name for _, name, _ in states),
        "layer_of": np.repeat(
            np.arange(len(tables)), [len(table.states) for table in tables.values()]
        ).astype(np.int16),
        "motions": used,
        "motion": np.array(
            [used.index(state.clips[0]) if state.clips else -1 for _, _, state in states], np.int16
        ),
        "blends": tuple(
            state.motion if isinstance(state.motion, BlendDefinition) else None for _, _, state in states
        ),
        "blended_clips": tuple(_blended_clips(state, motions) for _, _, state in states),
        "loop": np.array([_loops(state, motions) for _, _, state in states], bool),
        "duration": np.array([_duration_of(state, motions) for _, _, state in states], np.float64),
        "markers": tuple(markers_of(state, motions) for _, _, state in states),
        "speed": np.array([factor for factor, _ in speeds], np.float64),
        "speed_parameter": np.array([row for _, row in speeds], np.int16),
        "histories": histories,
        "inside": np.array(
            [
                [(layer, composite) in _around(layer, table, name) for layer, composite in histories]
                for layer, table, name in named(tables)
            ],
            bool,
        ).reshape(len(states), len(histories)),
    }


def named(tables: Mapping[str, MachineDefinition]) -> Iterator[tuple[str, MachineDefinition, str]]:
    """Returns layer, table and name of each state."""
    return ((layer, table, name) for layer, table in tables.items() for name in table.states)


def _around(layer: str, table: MachineDefinition, state: str) -> set[tuple[str, str]]:
    return {(layer, composite) for composite in enclosing(table, state)}


def _motions_used(
    tables: Mapping[str, MachineDefinition], motions: Mapping[str, MotionFacts]
) -> tuple[str, ...]:
    for _, table, name in named(tables):
        state = table.states[name]
        for clip in state.clips:
            if clip not in motions:
                motion_names = ", ".join(motions) or "none"
                raise table.refuse(
                    f"the state {name} has no motion {clip!r}{nearest(clip, tuple(motions)) or '.'} There "
                    f"are: {motion_names}",
                    state.line,
                )
    return tuple(
        dict.fromkeys(
            clip for table in tables.values() for state in table.states.values() for clip in state.clips
        )
    )


def _check_blends(tables: Mapping[str, MachineDefinition]) -> None:
    for _, table, name in named(tables):
        motion = table.states[name].motion
        if not isinstance(motion, BlendDefinition):
            continue
        for over in motion.over:
            if over not in table.parameters and over not in ENTRY:
                raise table.refuse(
                    f"{name} is blended over {over!r}, which is no "
                    f"parameter{nearest(over, (*table.parameters, *ENTRY))}",
                    motion.line,
                )


def _loops(state: StateDefinition, motions: Mapping[str, MotionFacts]) -> bool:
    if state.loop is not None or not state.clips:
        return bool(state.loop)
    return bool(motions[state.clips[0]].loop)


def _duration_of(state: StateDefinition, motions: Mapping[str, MotionFacts]) -> float:
    """Seconds: of a blend the longest clip; infinite for a state without motion."""
    return max((motions[clip].duration for clip in state.clips), default=float("inf"))


def markers_of(state: StateDefinition, motions: Mapping[str, MotionFacts]) -> tuple[tuple[str, float], ...]:
    """Returns name and phase of each marker, by phase: the markers of the state, then the markers of its
    (first) clip, as its blend or the clip defines them.
    """
    if not state.clips:
        return ()
    clip, named = state.clips[0], dict(state.markers)
    if isinstance(state.motion, BlendDefinition):
        named = {**state.motion.markers.get(clip, {}), **named}
    marks = [*named.items(), *_own_markers(motions[clip], named)]
    return tuple(sorted(marks, key=lambda marker: (marker[1], marker[0])))


def marks_of(clip: str, facts: MotionFacts, blend: BlendDefinition) -> Marks:
    """Returns name and phase of each marker of a clip in a blend: the markers that the blend defines, then
    the clip's own.
    """
    by_blend = blend.markers.get(clip, {})
    return (*by_blend.items(), *_own_markers(facts, by_blend))


def _own_markers(facts: MotionFacts, others: Container[str]) -> list[tuple[str, float]]:
    """Name and phase of a clip's markers but those whose names are among `others`."""
    duration = facts.duration
    return [(name, time / duration) for name, time in facts.markers if name not in others and duration > 0]


def _blended_clips(state: StateDefinition, motions: Mapping[str, MotionFacts]) -> tuple[BlendedClip, ...]:
    """The clips of a blend, in step with its first clip."""
    blend = state.motion
    if not isinstance(blend, BlendDefinition):
        return ()
    first, loop = markers_of(state, motions), _loops(state, motions)
    marks = [first, *(marks_of(clip, motions[clip], blend) for clip in list(blend.clips)[1:])]
    durations = [motions[clip].duration for clip in blend.clips]
    return tuple(
        BlendedClip(seconds, warp(first, one, loop)) for seconds, one in zip(durations, marks, strict=True)
    )


def _speed_of(definition: MachineDefinition, state: str) -> tuple[float, int]:
    """Factor of time, and the row of the parameter that gives it (-1 none)."""
    written = definition.states[state]
    if isinstance(written.speed, float):
        return written.speed, -1
    parameter_names = tuple(definition.parameters)
    if written.speed not in parameter_names:
        raise definition.refuse(
            f"the state {state} has no parameter "
            f"{written.speed!r}{nearest(written.speed, parameter_names) or '.'} There are: "
            f"{', '.join(parameter_names) or 'none'}",
            written.line,
        )
    parameter = definition.parameters[written.speed]
    if parameter.minimum < 0 or parameter.maximum > LARGEST_SPEED:
        raise definition.refuse(
            f"{written.speed} is the speed of {state}, so it must stay in 0 … {LARGEST_SPEED:g}",
            parameter.line,
        )
    return parameter.default, parameter_names.index(written.speed)
