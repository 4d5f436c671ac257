"""The state of machines, mapped to another version of their table: states, events, parameters and senses by
name; a state that has another name, by its motion.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.machine import Machine
from statwalk.machine.runtime.state import (
    BEGINNING,
    FOR_BUFFER,
    LOOK_UP,
    QUEUE,
    RUNNING,
    UNSET,
    MachineState,
    fresh,
)
from statwalk.maths.arrays import Bools, Ints
from statwalk.stage.migrate.match_states import is_same, is_same_motion, matched_states


class MigratedState(NamedTuple):
    """The state under the new machine; the actors whose state the new machine does not have: (row, layer of
    the new machine) each; and the pending events that it does not have: (row, layer, old column) each.
    """

    state: MachineState
    displaced: set[tuple[int, int]]
    lost: list[tuple[int, int, int]]


def remap(old: Machine, new: Machine, state: MachineState) -> MigratedState:
    """Returns the state of N actors under the new machine.

    An actor whose state is gone goes to the fallback of its layer. Time goes on if the motion is the same,
    else from the same phase. Pending events are looked up again.
    """
    if is_same(old, new):
        return MigratedState(state, set(), [])
    count = len(state.state)
    blank = fresh(new.program, count)
    columns = _by_name(old.events, new.events)
    parts = [_layer(old, new, state, blank, layer, columns) for layer in range(len(new.layers))]
    stacked = {name: np.stack([part[name] for part in parts], 1) for name in LAYERED}
    displaced = {
        (row, layer) for layer, part in enumerate(parts) for row in np.flatnonzero(part["displaced"]).tolist()
    }
    lost = np.argwhere((state.waiting_event >= 0) & (columns[state.waiting_event] < 0))
    lost_events = [
        (int(row), int(layer), int(state.waiting_event[row, layer, place])) for row, layer, place in lost
    ]
    mapped = blank._replace(**stacked, **_shared(old, new, state, blank))
    arrays = [
        np.ascontiguousarray(array, like.dtype)
        for array, like in zip(mapped.arrays(), blank.arrays(), strict=True)
    ]
    return MigratedState(MachineState._make(arrays), displaced, lost_events)


def _layer(
    old: Machine, new: Machine, state: MachineState, blank: MachineState, layer: int, columns: Ints
) -> dict[str, NDArray[Any]]:
    """The members of one layer of the new machine, (N, …) each, and which actors are displaced."""
    names = [old_layer.name for old_layer in old.layers]
    if new.layers[layer].name not in names:
        none = np.zeros(len(blank.state), bool)
        return {name: getattr(blank, name)[:, layer] for name in LAYERED} | {"displaced": none}
    before = names.index(new.layers[layer].name)
    old_states = state.state[:, before]
    new_states = matched_states(old, new, before, layer)[old_states]
    stays, new_states = new_states >= 0, np.where(new_states >= 0, new_states, new.fallbacks[layer])
    goes_on = stays & is_same_motion(old, new, old_states, new_states)
    time, passed = _times(
        old, new, (old_states, new_states), (state.time[:, before], state.passed[:, before]), stays, goes_on
    )
    queue = _queue(state, before, columns)
    return queue | {
        "state": new_states.astype(np.int16),
        "time": time,
        "passed": passed,
        "age": np.where(stays, state.age[:, before], 0).astype(np.int32),
        "ended": np.where(goes_on, state.ended[:, before], RUNNING).astype(np.uint8),
        "stayed": _stayed(old, new, state.stayed[:, before], (old_states, new_states), columns),
        "displaced": ~stays,
    }


LAYERED = ("state", "time", "passed", "age", "ended", "waiting", *QUEUE, "stayed")


def _times(
    old: Machine,
    new: Machine,
    states: tuple[Ints, Ints],
    times: tuple[NDArray[Any], NDArray[Any]],
    stays: Bools,
    goes_on: Bools,
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Seconds into the new motions, and up to which their markers have been handled: the same seconds, the
    seconds at the same phase, or the beginning.
    """
    was, comes = old.duration[states[0]], new.duration[states[1]]
    some = np.isfinite(was) & np.isfinite(comes) & (was > 0)  # a layer's state without a motion has no phase
    ratio = np.divide(comes, was, out=np.zeros(len(was)), where=some)
    time = np.where(goes_on, times[0], np.where(stays, times[0] * ratio, 0.0))
    return time, np.where(goes_on, times[1], np.where(stays, time, BEGINNING))


def _queue(state: MachineState, layer: int, columns: Ints) -> dict[str, NDArray[Any]]:
    """The pending events of a layer, without events that are gone, moved up; no event waits for a moment of
    the old table.
    """
    event = np.where(state.waiting_event[:, layer] >= 0, columns[state.waiting_event[:, layer]], -1)
    order = np.argsort(event < 0, axis=1, kind="stable")
    kept = {name: np.take_along_axis(getattr(state, name)[:, layer], order, 1) for name in QUEUE[1:]}
    events = np.take_along_axis(event, order, 1).astype(np.int16)
    buffered = kept["waiting_for"] == FOR_BUFFER
    kept["waiting_for"] = np.where(buffered, FOR_BUFFER, LOOK_UP)
    kept["waiting_until"] = np.where(buffered, kept["waiting_until"], UNSET)
    empty = {"waiting_for": LOOK_UP, "waiting_until": 0, "waiting_held": False, "waiting_other": -1}
    filled = {name: np.where(events >= 0, array, empty[name]) for name, array in kept.items()}
    return filled | {"waiting_event": events, "waiting": (events >= 0).sum(1)}


def _stayed(
    old: Machine, new: Machine, stayed: NDArray[Any], states: tuple[Ints, Ints], columns: Ints
) -> NDArray[Any]:
    """(N, E) the stays that have put END off, if the new table has the same text in the same place."""
    mapped = np.full((len(stayed), len(new.events)), -1, np.int32)
    for row, event in np.argwhere(stayed >= 0).tolist():
        if columns[event] >= 0:
            was = old.program.alternatives[states[0][row] * len(old.events) + event]
            first, past = new.program.alternatives[states[1][row] * len(new.events) + columns[event] :][:2]
            place = int(first + stayed[row, event] - was)
            same = first <= place < past and new.text.written[place] == old.text.written[stayed[row, event]]
            mapped[row, columns[event]] = place if same else -1
    return mapped


def _shared(old: Machine, new: Machine, state: MachineState, blank: MachineState) -> dict[str, NDArray[Any]]:
    """The members that all layers share."""
    parameters = _by_name(
        [parameter.name for parameter in new.parameters], [parameter.name for parameter in old.parameters]
    )
    senses = _by_name(
        [new.events[sense.event] for sense in new.senses],
        [old.events[sense.event] for sense in old.senses],
    )
    limits = [(parameter.minimum, parameter.maximum) for parameter in new.parameters]
    bounds = np.array(limits, np.float64).reshape(-1, 2).T
    wide = np.concatenate([bounds, np.tile([[-np.inf], [np.inf]], len(new.entry_values))], 1)
    goals = matched_states(old, new, 0, 0)
    return {
        "held": _taken(state.held, _by_name(new.events, old.events), blank.held),
        "parameters": np.clip(_taken(state.parameters, parameters, blank.parameters), *bounds),
        "smoothed": _taken(state.smoothed, _by_name(new.axes, old.axes), blank.smoothed).clip(*wide),
        "smoothed_rate": _taken(state.smoothed_rate, parameters, blank.smoothed_rate),
        "sensing": _taken(state.sensing, senses, blank.sensing),
        "last": _last(old, new, state, blank),
        "goal": np.where(state.goal >= 0, goals[state.goal], -1).astype(np.int16),
    }


def _last(old: Machine, new: Machine, state: MachineState, blank: MachineState) -> NDArray[Any]:
    """(N, H) the inner states that were left last, where the composite state still has them."""
    last, layers = blank.last.copy(), [old_layer.name for old_layer in old.layers]
    for column, (name, _) in enumerate(new.histories):
        before = layers.index(name) if name in layers else -1
        layer = [new_layer.name for new_layer in new.layers].index(name)
        to = matched_states(old, new, before, layer)
        row = _history(old, new, column, to)
        if row >= 0:
            inner = np.where(state.last[:, row] >= 0, to[state.last[:, row]], -1)
            last[:, column] = np.where((inner >= 0) & new.inside[inner, column], inner, -1)
    return last


def _history(old: Machine, new: Machine, column: int, to: Ints) -> int:
    """The row in the old machine of a composite state that resumes: by name; if its name is new, the only
    one that is gone and had the same inner states; -1 none. `to`: the new row of each old state.
    """
    if new.histories[column] in old.histories:
        return old.histories.index(new.histories[column])
    known = set(np.flatnonzero(new.inside[:, column]).tolist()) & set(to.tolist())
    gone = [row for row, name in enumerate(old.histories) if name not in new.histories]
    alike = [row for row in gone if known and set(to[old.inside[:, row]].tolist()) - {-1} == known]
    return alike[0] if len(alike) == 1 else -1


def _by_name(names: Sequence[Hashable], known_names: Sequence[Hashable]) -> Ints:
    """(n + 1,) the row of each name among `known_names`, -1 none; the last entry is -1, so that index -1
    gives -1.
    """
    rows = {name: row for row, name in enumerate(known_names)}
    return np.array([*(rows.get(name, -1) for name in names), -1])


def _taken(array: NDArray[Any], columns: Iterable[int], blank: NDArray[Any]) -> NDArray[Any]:
    """The columns of an array that the new version still has; other columns are taken from `blank`."""
    taken = blank.copy()
    for to, column in enumerate(list(columns)[: blank.shape[1]]):
        if column >= 0:
            taken[:, to] = array[:, column]
    return taken
