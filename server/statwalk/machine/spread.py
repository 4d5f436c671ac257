"""Turns, back in the arrays of a batch: each for all those it counts for; and what has happened, in the order of actors and layers."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.record import CHANGE_KINDS, Action, Changes, Verdict
from statwalk.machine.runparts import MIXED
from statwalk.machine.state import FOREVER, MOMENT, MOST_WAITING, NEW, MachineState
from statwalk.machine.turn import Turn
from statwalk.machine.turns import Turns
from statwalk.maths.arrays import Bools, Floats

TIME = Changes._fields.index("time") - 2
"""where the time stands in a change without actor and layer"""


class Spread:
    """What turns have come to: T turns, of whom G were taken."""

    def __init__(self, turns: Turns) -> None:
        self.turns, self.taken, self.batch, self.at = turns, turns.taken, turns.batch, turns.at
        self.group = np.empty(len(turns.at[0]), np.intp)
        """(T,) which turn counts for each"""
        for number, members in enumerate(turns.members):
            self.group[members] = number
        self.times = self._times()
        """(T,) seconds into the motion"""

    def each(self, value: Callable[[Turn], Any], kind: Any) -> NDArray[Any]:
        """(T, …) a value of the turn that counts for each."""
        return np.array([value(turn) for turn in self.taken], kind)[self.group]

    def _times(self) -> Floats:
        """Where the motion has changed at END, each takes over what was left of its own."""
        changed, carried = self.each(lambda turn: turn.changes > 0, bool), self.each(lambda turn: turn.carried, bool)
        time: Floats = np.where(changed, self.each(lambda turn: turn.time, float), self.batch.moved.time[self.at])
        if carried.any():
            state = self.each(lambda turn: turn.state, int)[carried]
            start = self.each(lambda turn: turn.start, float)[carried]
            time[carried] = self._entering((self.at[0][carried], self.at[1][carried]), state, start)
        return time

    def _entering(self, at: tuple[NDArray[np.intp], NDArray[np.intp]], state: NDArray[Any], start: Floats) -> Floats:
        """`Taking.entering` for many."""
        machine, duration = self.batch.machine, self.batch.machine.duration[state]
        row, speed = machine.speed_parameter[state], machine.speed[state]
        if machine.parameters:
            speed = np.where(row >= 0, self.batch.state.smoothed[at[0], np.maximum(row, 0)], speed)
        time = start + self.batch.moved.carry[at] * speed
        looped = np.where(duration > 0, np.fmod(time, np.where(duration > 0, duration, 1.0)), 0.0)
        return np.where(machine.loop[state], looped, np.minimum(time, duration))

    def state_after(self, after: MachineState) -> MachineState:
        """`after`, the state of those who had no turn, with all turns in it."""
        state, at, times = self.batch.state, self.at, self.times
        changed = self.each(lambda turn: turn.changes > 0, bool)
        passed = np.where(changed, self.each(lambda turn: turn.passed, float), times)
        age = np.where(self.each(lambda turn: turn.entered, bool), 0, after.age[at])
        base = at[1] == 0
        after = after._replace(
            state=put(state.state, at, self.each(lambda turn: turn.state, np.int16)),
            time=put(after.time, at, times),
            passed=put(after.passed, at, passed),
            age=put(after.age, at, age),
            ended=put(after.ended, at, self.each(lambda turn: turn.ended, np.uint8)),
            held=put(state.held, at[0], self.each(lambda turn: turn.held, np.int32)),
            goal=put(state.goal, at[0][base], self.each(lambda turn: turn.goal, np.int16)[base]),
            last=self._last(state.last),
        )
        return self._with_queues(after, changed)

    def _last(self, last: NDArray[np.int16]) -> NDArray[np.int16]:
        """What was left last: each layer has outer states of its own."""
        machine = self.batch.machine
        if not machine.histories:
            return last
        found, own = last.copy(), self.each(lambda turn: turn.last, np.int16)
        layers = [machine.layer_of[machine.inside[:, history].argmax()] for history in range(len(machine.histories))]
        for history, layer in enumerate(layers):
            there = self.at[1] == layer
            found[self.at[0][there], history] = own[there, history]
        return found

    def _with_queues(self, after: MachineState, changed: Bools) -> MachineState:
        """What waits now, and when it must be looked at: in a new state at once, whenever that came about."""
        state = self.batch.state
        wake = put(state.wake, self.at, FOREVER)
        queued = self.each(lambda turn: bool(turn.queue), bool) | (state.waiting_event[self.at][:, 0] >= 0)
        if not queued.any():
            return after._replace(wake=wake)
        at, group = (self.at[0][queued], self.at[1][queued]), self.group[queued]
        event, until, held, other, kept = (part[group] for part in queues_of(self.taken))
        own = np.take_along_axis(state.waiting_until[at], np.maximum(kept, 0), 1)
        until = np.where(kept >= 0, own, until)
        soonest = np.where(event >= 0, until, FOREVER).min(1)
        wake[at] = np.where((event[:, 0] >= 0) & changed[queued], NEW, soonest)
        return after._replace(
            wake=wake,
            waiting_event=put(state.waiting_event, at, event),
            waiting_until=put(state.waiting_until, at, until),
            waiting_held=put(state.waiting_held, at, held),
            waiting_other=put(state.waiting_other, at, other),
            alert=put(state.alert, self.at, self.each(is_alert, bool)),
        )

    def changes(self) -> Changes:
        """The motions that have started."""
        flat = [(*change[2:], turn.carried and change is turn.record.changes[-1]) for turn in self.taken for change in turn.record.changes]
        place, row = spread([len(turn.record.changes) for turn in self.taken], self.group)
        columns: list[tuple[Any, ...]] = list(zip(*flat, strict=True)) if flat else [()] * (len(CHANGE_KINDS) - 1)
        found: list[NDArray[Any]] = [
            np.array(column, kind)[row] for column, kind in zip(columns, (*CHANGE_KINDS[2:], np.bool_), strict=True)
        ]
        carried = found.pop()
        found[TIME] = np.where(carried, self.times[place], found[TIME])
        return Changes(self.at[0][place], self.at[1][place], *found)

    def verdicts(self) -> list[Verdict]:
        """What became of the events."""
        said = [[one[2:] for one in turn.record.verdicts] for turn in self.taken]
        tick, make = self.batch.tick, tuple.__new__  # the calls between it and a NamedTuple take longer than it
        found = [make(Verdict, (tick, actor, *one)) for actor, group in self.each_turn() for one in said[group]]
        if any(one.values for turn in self.taken for one in turn.record.verdicts):
            place, _ = spread([len(several) for several in said], self.group)
            found = [self._asked(one, where) if one.values else one for one, where in zip(found, place.tolist(), strict=True)]
        return found

    def each_turn(self) -> Iterator[tuple[int, int]]:
        """Actor and group of each turn."""
        return zip(self.at[0].tolist(), self.group.tolist(), strict=True)

    def _asked(self, verdict: Verdict, place: int) -> Verdict:
        """The verdict with what the conditions have seen of the actor at a place among the turns."""
        names = [name for name, _ in verdict.values]
        return verdict._replace(values=self.turns.answers[verdict.layer].values_of(names, int(self.turns.index[place])))

    def actions(self) -> list[Action]:
        """What came out."""
        done = [[one[2:] for one in turn.record.actions] for turn in self.taken]
        tick, make = self.batch.tick, Action._make
        return [make((tick, actor, *one)) for actor, group in self.each_turn() for one in done[group]]


def put(array: NDArray[Any], at: Any, values: Any) -> NDArray[Any]:
    """A copy of the array with values in some places."""
    changed = array.copy()
    changed[at] = values
    return changed


def spread(counts: Sequence[int], group: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """For turns (T,) that have as many things as their groups (G): of each thing the turn, and its row among the things of all groups."""
    many = np.array(counts, np.intp)
    each = many[group]
    place = np.repeat(np.arange(len(group)), each)
    begins = (many.cumsum() - many)[group]
    return place, np.arange(len(place)) - np.repeat(each.cumsum() - each, each) + begins[place]


def queues_of(taken: Sequence[Turn]) -> tuple[NDArray[Any], ...]:
    """(G, 16) each: event, until, held, other, and the place in the old queue whose `until` is kept, -1 none."""
    shape = (len(taken), MOST_WAITING)
    event, until, held = np.full(shape, -1, np.int16), np.zeros(shape, np.int64), np.zeros(shape, bool)
    other, kept = np.full(shape, -1, np.int64), np.full(shape, -1, np.intp)
    for row, turn in enumerate(taken):
        for place, one in enumerate(turn.queue):
            event[row, place], until[row, place], held[row, place], other[row, place] = one.event, one.until, one.held, one.other
            kept[row, place] = one.slot if one.until == one.kept else -1
    return event, until, held, other, kept


def is_alert(turn: Turn) -> bool:
    """Whether something waits for a marker, a window or a condition."""
    row = turn.machine.targets[turn.state]
    return any(one.until == MOMENT or (NEW < one.until < MOMENT and row[one.event] == MIXED) for one in turn.queue)
