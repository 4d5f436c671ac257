"""What machines remember, in the words of another version of their table: states, events, parameters and senses by name."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from dataclasses import fields
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runform import Machine
from statwalk.machine.ticking.state import BEGINNING, FOREVER, MOMENT, NEW, RUNNING, MachineState, fresh
from statwalk.maths.arrays import Bools, Ints

SAID = ("condition", "when", "release", "line")
"""members that are left out when two machines are compared: programs, whose text stands beside them, and lines of the file"""


def is_same(old: Machine, new: Machine) -> bool:
    """Whether two machines do the same, whatever their files look like."""
    return all(_plain(getattr(old, one.name)) == _plain(getattr(new, one.name)) for one in fields(Machine))


def _plain(value: object) -> object:
    """A value that can be compared: arrays as bytes, programs and lines left out."""
    if isinstance(value, np.ndarray):
        return value.shape, value.tobytes()
    if isinstance(value, dict):
        return {key: _plain(one) for key, one in value.items()}
    if isinstance(value, tuple) and hasattr(value, "_asdict"):
        return tuple(_plain(one) for name, one in value._asdict().items() if name not in SAID)
    if isinstance(value, tuple):
        return tuple(_plain(one) for one in value)
    if hasattr(value, "__dataclass_fields__"):
        return tuple(_plain(getattr(value, name)) for name in value.__dataclass_fields__ if name not in SAID)
    return value


class Remapped(NamedTuple):
    """The state under the new machine, and the events that it does not know: (row, layer, old column) each."""

    state: MachineState
    lost: list[tuple[int, int, int]]


def remap(old: Machine, new: Machine, state: MachineState) -> Remapped:
    """Where N actors are in the new machine.

    A state that is gone is left for its layer's fallback. Time goes on where the motion is the same, else from the same phase.
    What waits is looked up again.
    """
    if is_same(old, new):
        return Remapped(state, [])
    count = len(state.state)
    blank = fresh(new, count)
    columns = _by_name(old.events, new.events)
    parts = [_layer(old, new, state, blank, layer, columns) for layer in range(len(new.layers))]
    stacked = {name: np.stack([part[name] for part in parts], 1) for name in parts[0]}
    lost = np.argwhere((state.waiting_event >= 0) & (columns[state.waiting_event] < 0))
    waited = [(int(row), int(layer), int(state.waiting_event[row, layer, place])) for row, layer, place in lost]
    return Remapped(blank._replace(**stacked, **_shared(old, new, state, blank)), waited)


def _layer(old: Machine, new: Machine, state: MachineState, blank: MachineState, layer: int, columns: Ints) -> dict[str, NDArray[Any]]:
    """The members of one layer of the new machine, (N, …) each."""
    names = [one.name for one in old.layers]
    if new.layers[layer].name not in names:
        return {name: getattr(blank, name)[:, layer] for name in LAYERED}
    before = names.index(new.layers[layer].name)
    here = state.state[:, before]
    to = _states(old, new, before, layer)[here]
    stays, to = to >= 0, np.where(to >= 0, to, new.fallbacks[layer])
    goes_on = stays & _is_same_motion(old, new, here, to)
    time, passed = _times(old, new, (here, to), (state.time[:, before], state.passed[:, before]), stays, goes_on)
    queue = _queue(state, before, columns)
    some = queue["waiting_event"][:, 0] >= 0
    return queue | {
        "state": to.astype(np.int16),
        "time": time,
        "passed": passed,
        "age": np.where(stays, state.age[:, before], 0).astype(np.int32),
        "ended": np.where(goes_on, state.ended[:, before], RUNNING).astype(np.uint8),
        "wake": np.where(some, NEW, FOREVER),
        "alert": some,
    }


LAYERED = (
    "state",
    "time",
    "passed",
    "age",
    "ended",
    "waiting_event",
    "waiting_until",
    "waiting_held",
    "waiting_other",
    "wake",
    "alert",
)


def _times(
    old: Machine, new: Machine, states: tuple[Ints, Ints], times: tuple[NDArray[Any], NDArray[Any]], stays: Bools, goes_on: Bools
) -> tuple[NDArray[Any], NDArray[Any]]:
    """Seconds into the new motions, and up to which their markers have been met: the same, those of the same phase, or the beginning."""
    was, comes = old.duration[states[0]], new.duration[states[1]]
    some = np.isfinite(was) & np.isfinite(comes) & (was > 0)  # a layer's state without a motion has no phase
    ratio = np.divide(comes, was, out=np.zeros(len(was)), where=some)
    time = np.where(goes_on, times[0], np.where(stays, times[0] * ratio, 0.0))
    return time, np.where(goes_on, times[1], np.where(stays, time, BEGINNING))


def _queue(state: MachineState, layer: int, columns: Ints) -> dict[str, NDArray[Any]]:
    """What waits in a layer, without the events that are gone, the others closer together; no moment of the old table is awaited."""
    event = np.where(state.waiting_event[:, layer] >= 0, columns[state.waiting_event[:, layer]], -1)
    order = np.argsort(event < 0, axis=1, kind="stable")
    kept = {name: np.take_along_axis(getattr(state, name)[:, layer], order, 1) for name in LAYERED[6:9]}
    some = np.take_along_axis(event, order, 1).astype(np.int16)
    kept["waiting_until"] = np.where(kept["waiting_until"] >= MOMENT, NEW, kept["waiting_until"])
    empty = {"waiting_until": 0, "waiting_held": False, "waiting_other": -1}
    return {"waiting_event": some} | {name: np.where(some >= 0, array, empty[name]) for name, array in kept.items()}


def _shared(old: Machine, new: Machine, state: MachineState, blank: MachineState) -> dict[str, NDArray[Any]]:
    """The members that all layers share."""
    parameters = _by_name([one.name for one in new.parameters], [one.name for one in old.parameters])
    senses = _by_name([new.events[one.event] for one in new.senses], [old.events[one.event] for one in old.senses])
    bounds = np.array([(one.minimum, one.maximum) for one in new.parameters], np.float64).reshape(-1, 2).T
    goals = _states(old, new, 0, 0)
    return {
        "held": _taken(state.held, _by_name(new.events, old.events), blank.held),
        "parameters": np.clip(_taken(state.parameters, parameters, blank.parameters), *bounds),
        "smoothed": np.clip(_taken(state.smoothed, parameters, blank.smoothed), *bounds),
        "smoothed_rate": _taken(state.smoothed_rate, parameters, blank.smoothed_rate),
        "sensing": _taken(state.sensing, senses, blank.sensing),
        "last": _last(old, new, state, blank),
        "goal": np.where(state.goal >= 0, goals[state.goal], -1).astype(np.int16),
    }


def _last(old: Machine, new: Machine, state: MachineState, blank: MachineState) -> NDArray[Any]:
    """(N, H) the inner states left last, where the outer ones and they themselves are still there."""
    last = _taken(state.last, _by_name(new.histories, old.histories), blank.last)
    layers = [one.name for one in new.layers]
    for column, (layer, _) in enumerate(new.histories):
        before = [one.name for one in old.layers].index(layer) if (layer, _) in old.histories else -1
        to = _states(old, new, before, layers.index(layer))
        last[:, column] = np.where(last[:, column] >= 0, to[last[:, column]], -1)
    return last


def _states(old: Machine, new: Machine, before: int, layer: int) -> Ints:
    """(S,) for each state of the old machine the row of that name in a layer of the new one, -1 where it is gone."""
    rows = {new.states[row]: row for row in new.rows(layer)}
    return np.array([rows.get(name, -1) if old.layer_of[row] == before else -1 for row, name in enumerate(old.states)])


def _is_same_motion(old: Machine, new: Machine, before: Ints, after: Ints) -> Bools:
    """(N,) whether two states play the same motion, as long and in the same way."""
    key_of = [_motions(old), _motions(new)]
    same = {(one, other): key_of[0][one] == key_of[1][other] for one, other in set(zip(before.tolist(), after.tolist(), strict=True))}
    return np.array([same[pair] for pair in zip(before.tolist(), after.tolist(), strict=True)], bool)


def _motions(machine: Machine) -> list[object]:
    """What each state plays."""
    clips = [machine.motions[row] if row >= 0 else "" for row in machine.motion]
    return [
        (clip, _plain(blend), bool(loop), float(duration))
        for clip, blend, loop, duration in zip(clips, machine.blends, machine.loop, machine.duration, strict=True)
    ]


def _by_name(names: Sequence[Hashable], known: Sequence[Hashable]) -> Ints:
    """(n,) where each of the names stands among the known ones, -1 where it does not; and one -1 more, so that -1 is -1."""
    rows = {name: row for row, name in enumerate(known)}
    return np.array([*(rows.get(name, -1) for name in names), -1])


def _taken(array: NDArray[Any], columns: Iterable[int], blank: NDArray[Any]) -> NDArray[Any]:
    """The columns of an array that a new version still knows, those of `blank` in place of the others."""
    found = blank.copy()
    for to, column in enumerate(list(columns)[: blank.shape[1]]):
        if column >= 0:
            found[:, to] = array[:, column]
    return found
