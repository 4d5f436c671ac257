"""From authored states to arrays: the motion of each, how long it lasts, its markers, its speed, and the outer states around it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from statwalk.machine.authored.definition import BlendDefinition, MachineDefinition, StateDefinition, nearest
from statwalk.machine.authored.expand import enclosing

LARGEST_SPEED = 100.0


@dataclass(frozen=True)
class MotionFacts:
    """What a machine must know of a motion; seconds. `loop` None: its file does not say. `markers`: name and seconds from its start."""

    duration: float
    loop: bool | None = None
    markers: tuple[tuple[str, float], ...] = ()


def state_arrays(tables: Mapping[str, MachineDefinition], motions: Mapping[str, MotionFacts]) -> dict[str, Any]:
    """The fields of Machine that stand for each of S states, those of all layers one below the other; raises MachineError."""
    check_blends(tables)
    states = [(table, name, state) for table in tables.values() for name, state in table.states.items()]
    used = motions_used(tables, motions)
    speeds = [speed_of(table, name) for table, name, _ in states]
    histories = tuple((layer, outer) for layer, table in tables.items() for outer, one in table.outers.items() if one.resume)
    return {
        "states": tuple(name for _, name, _ in states),
        "layer_of": np.repeat(np.arange(len(tables)), [len(table.states) for table in tables.values()]).astype(np.int16),
        "motions": used,
        "motion": np.array([used.index(state.clips[0]) if state.clips else -1 for _, _, state in states], np.int16),
        "blends": tuple(state.motion if isinstance(state.motion, BlendDefinition) else None for _, _, state in states),
        "loop": np.array([loops(state, motions) for _, _, state in states], bool),
        "duration": np.array([duration_of(state, motions) for _, _, state in states], np.float64),
        "markers": tuple(markers_of(state, motions) for _, _, state in states),
        "speed": np.array([factor for factor, _ in speeds], np.float64),
        "speed_parameter": np.array([row for _, row in speeds], np.int16),
        "histories": histories,
        "inside": np.array(
            [[(layer, outer) in around(layer, table, name) for layer, outer in histories] for layer, table, name in named(tables)], bool
        ).reshape(len(states), len(histories)),
    }


def named(tables: Mapping[str, MachineDefinition]) -> Iterator[tuple[str, MachineDefinition, str]]:
    """Layer, table and name of each state."""
    return ((layer, table, name) for layer, table in tables.items() for name in table.states)


def around(layer: str, table: MachineDefinition, state: str) -> set[tuple[str, str]]:
    """The outer states that a state is part of, each with its layer."""
    return {(layer, outer) for outer in enclosing(table, state)}


def motions_used(tables: Mapping[str, MachineDefinition], motions: Mapping[str, MotionFacts]) -> tuple[str, ...]:
    """The motions of the states, each once; raises MachineError for one that does not exist."""
    for _, table, name in named(tables):
        state = table.states[name]
        for clip in state.clips:
            if clip not in motions:
                known = ", ".join(motions) or "none"
                raise table.refuse(
                    f"the state {name} has no motion {clip!r}{nearest(clip, tuple(motions)) or '.'} There are: {known}", state.line
                )
    return tuple(dict.fromkeys(clip for table in tables.values() for state in table.states.values() for clip in state.clips))


def check_blends(tables: Mapping[str, MachineDefinition]) -> None:
    """Raises MachineError for a blend over what is no parameter."""
    for _, table, name in named(tables):
        motion = table.states[name].motion
        if not isinstance(motion, BlendDefinition):
            continue
        for over in motion.over:
            if over not in table.parameters:
                raise table.refuse(f"{name} is blended over {over!r}, which is no parameter{nearest(over, table.parameters)}", motion.line)


def loops(state: StateDefinition, motions: Mapping[str, MotionFacts]) -> bool:
    """Whether a state's motion begins anew at its end."""
    if state.loop is not None or not state.clips:
        return bool(state.loop)
    return bool(motions[state.clips[0]].loop)


def duration_of(state: StateDefinition, motions: Mapping[str, MotionFacts]) -> float:
    """Seconds: of a blend its longest clip's; without a motion there is no end."""
    return max((motions[clip].duration for clip in state.clips), default=float("inf"))


def markers_of(state: StateDefinition, motions: Mapping[str, MotionFacts]) -> tuple[tuple[str, float], ...]:
    """Name and phase of each marker, by phase: the state's own, then those of its (first) clip, as its blend says or as the clip has."""
    if not state.clips:
        return ()
    clip, named = state.clips[0], dict(state.markers)
    if isinstance(state.motion, BlendDefinition):
        named = {**state.motion.markers.get(clip, {}), **named}
    duration = motions[clip].duration
    own = [(name, time / duration) for name, time in motions[clip].markers if name not in named and duration > 0]
    return tuple(sorted([*named.items(), *own], key=lambda one: (one[1], one[0])))


def speed_of(definition: MachineDefinition, state: str) -> tuple[float, int]:
    """Factor and parameter row of a state's speed; raises MachineError for a parameter that does not exist, or may leave 0…100."""
    one = definition.states[state]
    if isinstance(one.speed, float):
        return one.speed, -1
    known = tuple(definition.parameters)
    if one.speed not in known:
        raise definition.refuse(
            f"the state {state} has no parameter {one.speed!r}{nearest(one.speed, known) or '.'} There are: {', '.join(known) or 'none'}",
            one.line,
        )
    given = definition.parameters[one.speed]
    if given.minimum < 0 or given.maximum > LARGEST_SPEED:
        raise definition.refuse(f"{one.speed} is the speed of {state}, so it must stay in 0 … {LARGEST_SPEED:g}", given.line)
    return given.default, known.index(one.speed)
