"""The inputs of one cast in a tick: events raised in the tick before, then the commands of this tick, in
order.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.machine.runtime.surroundings import HOLD, NOTHING, PRESS, RELEASE, TRAVEL, Inputs
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.commands import Command, Hold, Press, Release, Set, Travel
from statwalk.stage.state.pending_events import NO_SUCH_EVENT, NO_SUCH_STATE, Notice, PendingEvent
from statwalk.stage.steps.travel_events import presses

KINDS: Mapping[type[Command], int] = {Press: PRESS, Hold: HOLD, Release: RELEASE}


class InputBatch(NamedTuple):
    """A cast with its parameters set, the inputs of its machines, and notices about inputs that the machines
    cannot take.
    """

    cast: Cast
    inputs: Inputs
    notices: tuple[Notice, ...]


class _Input(NamedTuple):
    """One input; `name` is an event, or a state if `kind` is TRAVEL."""

    actor: int
    name: str
    kind: int
    other: int = -1


def input_batch(
    cast: Cast, pending: Sequence[PendingEvent], commands: Sequence[Command], dt: float
) -> InputBatch:
    """Returns the inputs of one cast.

    An input whose name was removed by an edit gives a notice, not an error.
    """
    goal = cast.machine.goal
    if not pending and not commands and goal[goal.argmax()] < 0:
        return InputBatch(cast, NOTHING, ())
    rows: list[tuple[int, int, int, int]] = []
    lost: list[Notice] = []
    machine = cast.role.machine
    columns = {name: column for column, name in enumerate(machine.events[:-1])}
    goals = {"": -1} | {machine.states[row]: row for row in machine.rows(0)}
    for item in _inputs(pending, commands):
        row, column = cast.row(item.actor), (goals if item.kind == TRAVEL else columns).get(item.name)
        if row >= 0 and column is not None:
            rows.append((row, column, item.kind, item.other))
        elif row >= 0:
            reason = NO_SUCH_STATE if item.kind == TRAVEL else NO_SUCH_EVENT
            lost.append(Notice(item.actor, item.name, item.other, reason))
    rows += presses(cast, rows, dt)
    return InputBatch(
        _with_parameters(cast, commands), Inputs.of(*np.array(rows, np.int64).reshape(-1, 4).T), tuple(lost)
    )


def _inputs(pending: Iterable[PendingEvent], commands: Iterable[Command]) -> Iterable[_Input]:
    """All inputs, in order."""
    yield from (_Input(event.actor, event.event, event.kind, event.other) for event in pending)
    for command in commands:
        match command:
            case Press() | Hold() | Release():
                yield _Input(command.actor, command.event, KINDS[type(command)])
            case Travel():
                yield _Input(command.actor, command.state, TRAVEL)


def _with_parameters(cast: Cast, commands: Iterable[Command]) -> Cast:
    """The cast with parameters set; a value beyond the bounds, which an edit may have moved, is clamped."""
    parameter_of = {
        parameter.name: (number, parameter) for number, parameter in enumerate(cast.role.machine.parameters)
    }
    values: list[tuple[int, int, float]] = []
    for command in commands:
        if (
            isinstance(command, Set)
            and command.parameter in parameter_of
            and (row := cast.row(command.actor)) >= 0
        ):
            number, parameter = parameter_of[command.parameter]
            values.append((row, number, min(max(command.value, parameter.minimum), parameter.maximum)))
    return cast.with_parameters(values) if values else cast
