"""From the authored machine to the one that runs: a full integer table, immutable; after it nothing can fail."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.definition import MachineDefinition, nearest
from statwalk.machine.expand import Cell, expand

BLANK, OFF, UNDEFINED = -1, -2, -3
"""targets that are no state: nothing stands there, a `-`, a name that is no state"""
NOW, AT_END = 0, 1
LARGEST_SPEED = 100.0


@dataclass(frozen=True)
class MotionFacts:
    """What a machine must know of a motion; seconds. `loop` None: its file does not say."""

    duration: float
    loop: bool | None = None
    markers: tuple[tuple[str, float], ...] = ()


@dataclass(frozen=True)
class Parameter:
    """A named number that the outside sets, and its bounds."""

    name: str
    default: float
    minimum: float
    maximum: float


@dataclass(frozen=True)
class Key:
    """What a key sends: `press` when it goes down (kept down where `hold`), `release` when it comes up."""

    press: str | None
    release: str | None
    hold: bool


@dataclass(frozen=True, eq=False)
class Machine:
    """The machine as run; S states, E events of which END is the last. Seconds."""

    name: str
    states: tuple[str, ...]
    events: tuple[str, ...]
    target: NDArray[np.int16]
    """(S, E) the next state, or BLANK, OFF, UNDEFINED"""
    when: NDArray[np.uint8]
    """(S, E) NOW or AT_END"""
    restart: NDArray[np.bool_]
    """(S, E)"""
    blend: NDArray[np.float32]
    """(S, E)"""
    action: NDArray[np.int16]
    """(S, E) row of `actions`, -1 none"""
    buffer: NDArray[np.float32]
    """(E,) how long an event waits in a blank cell"""
    motion: NDArray[np.int16]
    """(S,) row of `motions`"""
    loop: NDArray[np.bool_]
    """(S,)"""
    duration: NDArray[np.float64]
    """(S,)"""
    speed: NDArray[np.float64]
    """(S,) factor of time, where speed_parameter is -1"""
    speed_parameter: NDArray[np.int16]
    """(S,) row of `parameters` that gives the factor, -1 none"""
    initial: int
    idle: int
    """the event that stands for nobody touching anything, -1 none"""
    actions: tuple[str, ...]
    motions: tuple[str, ...]
    keys: Mapping[str, Key]
    parameters: tuple[Parameter, ...]
    undefined: Mapping[tuple[int, int], str]
    """what the table names where the target is UNDEFINED"""

    @property
    def end(self) -> int:
        """The column of END."""
        return len(self.events) - 1

    @cached_property
    def end_matters(self) -> NDArray[np.bool_]:
        """(S,) whether END, or the idle event in its place, finds a cell with something to do."""
        at_end = self.target[:, self.end]
        idle = self.target[:, self.idle] >= 0 if self.idle >= 0 else np.zeros(len(self.states), bool)
        return np.asarray((at_end >= 0) | (at_end == UNDEFINED) | ((at_end == BLANK) & idle))

    @cached_property
    def targets(self) -> list[list[int]]:
        """`target` as Python numbers, for looking up one cell."""
        found: list[list[int]] = self.target.tolist()
        return found

    @cached_property
    def waits_for_end(self) -> list[list[bool]]:
        """Whether a cell waits for END, as Python numbers."""
        found: list[list[bool]] = (self.when == AT_END).tolist()
        return found


def build(definition: MachineDefinition, motions: Mapping[str, MotionFacts]) -> Machine:
    """The machine that runs. Raises MachineError with line and nearest name for a motion or parameter that does not exist."""
    states, events = tuple(definition.states), definition.columns
    used = motions_used(definition, motions)
    cells = expand(definition)
    actions = tuple(dict.fromkeys(str(cell.action) for cell in cells.values() if cell.action))
    speeds = [speed_of(definition, state) for state in states]
    facts = [motions[definition.states[state].clips[0]] for state in states]
    loops = [bool(facts[row].loop) if one.loop is None else one.loop for row, one in enumerate(definition.states.values())]
    return Machine(
        name=definition.name,
        states=states,
        events=events,
        initial=states.index(definition.initial),
        idle=events.index(definition.idle) if definition.idle else -1,
        actions=actions,
        motions=used,
        motion=np.array([used.index(one.clips[0]) for one in definition.states.values()], np.int16),
        loop=np.array(loops, bool),
        duration=np.array([fact.duration for fact in facts], np.float64),
        speed=np.array([factor for factor, _ in speeds], np.float64),
        speed_parameter=np.array([row for _, row in speeds], np.int16),
        buffer=np.array(
            [definition.defaults.buffer if one.buffer is None else one.buffer for one in definition.events.values()] + [0], np.float32
        ),
        keys={name: Key(key.press, key.release, key.hold) for name, key in definition.keys.items()},
        parameters=tuple(Parameter(name, one.default, one.minimum, one.maximum) for name, one in definition.parameters.items()),
        undefined={
            (states.index(state), events.index(event)): cell.to
            for (state, event), cell in cells.items()
            if not cell.off and cell.to not in definition.states
        },
        **table_arrays(states, events, cells, actions),
    )


def table_arrays(
    states: tuple[str, ...], events: tuple[str, ...], cells: Mapping[tuple[str, str], Cell], actions: tuple[str, ...]
) -> dict[str, Any]:
    """target, when, restart, blend and action, each (S, E)."""
    shape = (len(states), len(events))
    target, when = np.full(shape, BLANK, np.int16), np.full(shape, NOW, np.uint8)
    restart, blend, action = np.zeros(shape, bool), np.zeros(shape, np.float32), np.full(shape, -1, np.int16)
    state_rows, event_rows = {name: row for row, name in enumerate(states)}, {name: row for row, name in enumerate(events)}
    for (state, event), cell in cells.items():
        place = state_rows[state], event_rows[event]
        target[place] = OFF if cell.off else state_rows.get(cell.to, UNDEFINED)
        when[place] = AT_END if cell.when.kind == "end" else NOW
        restart[place] = cell.restart
        blend[place] = cell.blend
        action[place] = actions.index(str(cell.action)) if cell.action else -1
    return {"target": target, "when": when, "restart": restart, "blend": blend, "action": action}


def motions_used(definition: MachineDefinition, motions: Mapping[str, MotionFacts]) -> tuple[str, ...]:
    """The motions of the states, each once; raises MachineError for one that does not exist."""
    for name, state in definition.states.items():
        for clip in state.clips:
            if clip not in motions:
                known = ", ".join(motions) or "none"
                raise definition.refuse(
                    f"the state {name} has no motion {clip!r}{nearest(clip, tuple(motions)) or '.'} There are: {known}", state.line
                )
    return tuple(dict.fromkeys(clip for state in definition.states.values() for clip in state.clips))


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
