"""Turns, back in the arrays of a batch: each for all those it counts for; and what has happened, in the order of actors and layers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runparts import MIXED
from statwalk.machine.ticking.record import CHANGE_KINDS, NO_CHANGES, Action, Changes, Verdict
from statwalk.machine.ticking.state import FOREVER, MOMENT, NEW, MachineState
from statwalk.machine.ticking.turn import Turn
from statwalk.machine.ticking.turns import Turns
from statwalk.maths.arrays import Floats

TIME = Changes._fields.index("time") - 2
"""where the time stands in a change without actor and layer"""
STATE, ENDED, GOAL, CHANGED, CARRIED, ENTERED, WAITS, ALERT = range(8)
WORTH_A_LOOK = 4096
"""copying fewer numbers costs less than comparing some of them"""
NOTHING_WAITS = (-1, 0, 0, -1, -1)


class Spread:
    """What turns have come to: T turns, of whom G were taken."""

    def __init__(self, turns: Turns) -> None:
        self.turns, self.taken, self.batch, self.at = turns, turns.taken, turns.batch, turns.at
        self.group = np.empty(len(turns.at[0]), np.intp)
        """(T,) which turn counts for each"""
        for number, members in enumerate(turns.members):
            self.group[members] = number
        self.now = np.array([whole_numbers(turn) for turn in self.taken], np.int64)[self.group].T
        """(8, T) see `whole_numbers`"""
        self.seconds = np.array([(turn.time, turn.passed) for turn in self.taken])[self.group].T
        """(2, T) into the motion, and before its markers that are still to be met"""
        self.changed = self.now[CHANGED] > 0
        self.times = self._times()
        """(T,) seconds into the motion"""

    def _times(self) -> Floats:
        """Where the motion has changed at END, each takes over what was left of its own."""
        time: Floats = np.where(self.changed, self.seconds[0], self.batch.moved.time[self.at])
        carried = self.now[CARRIED] > 0
        if carried.any():
            time[carried] = self._entering((self.at[0][carried], self.at[1][carried]), self.now[STATE][carried], self.seconds[0][carried])
        return time

    def _entering(self, at: tuple[NDArray[np.intp], NDArray[np.intp]], state: NDArray[Any], start: Floats) -> Floats:
        """Seconds into a motion that is entered at `start`, and takes over the time left after END."""
        machine, duration = self.batch.machine, self.batch.machine.duration[state]
        row, speed = machine.speed_parameter[state], machine.speed[state]
        if machine.parameters:
            speed = np.where(row >= 0, self.batch.state.smoothed[at[0], np.maximum(row, 0)], speed)
        time = start + self.batch.moved.carry[at] * speed
        looped = np.where(duration > 0, np.fmod(time, np.where(duration > 0, duration, 1.0)), 0.0)
        return np.where(machine.loop[state], looped, np.minimum(time, duration))

    def state_after(self, after: MachineState) -> MachineState:
        """`after`, the state of those who had no turn, with all turns in it."""
        state, at, now, times = self.batch.state, self.at, self.now, self.times
        base = at[1] == 0
        after = after._replace(
            state=put(state.state, at, now[STATE]),
            time=put(after.time, at, times),
            passed=put(after.passed, at, np.where(self.changed, self.seconds[1], times)),
            age=put(after.age, at, np.where(now[ENTERED] > 0, 0, after.age[at])),
            ended=put(after.ended, at, now[ENDED]),
            held=self._held(state.held),
            goal=put(state.goal, at[0][base], now[GOAL][base]),
            last=self._last(state.last),
        )
        return self._with_queues(after)

    def _held(self, held: NDArray[np.int32]) -> NDArray[np.int32]:
        """What is held down now; the turns of an actor agree."""
        if not any(turn.keys_moved for turn in self.taken):
            return held
        return put(held, self.at[0], np.array([turn.held for turn in self.taken], np.int32)[self.group])

    def _last(self, last: NDArray[np.int16]) -> NDArray[np.int16]:
        """What was left last: each layer has outer states of its own."""
        machine = self.batch.machine
        if not machine.histories:
            return last
        found, own = last.copy(), np.array([turn.last for turn in self.taken], np.int16)[self.group]
        layers = [machine.layer_of[machine.inside[:, history].argmax()] for history in range(len(machine.histories))]
        for history, layer in enumerate(layers):
            there = self.at[1] == layer
            found[self.at[0][there], history] = own[there, history]
        return found

    def _with_queues(self, after: MachineState) -> MachineState:
        """What waits now, and when it must be looked at: in a new state at once, whenever that came about."""
        state = self.batch.state
        queued = (self.now[WAITS] > 0) | (state.waiting_event[..., 0][self.at] >= 0)
        if not queued.any():
            return after._replace(wake=put(state.wake, self.at, FOREVER))
        at, group = (self.at[0][queued], self.at[1][queued]), self.group[queued]
        longest = max(max(len(turn.queue) for turn in self.taken), int((state.waiting_event[at] >= 0).sum(1).max()))
        event, until, held, other, kept = (part[group] for part in queues_of(self.taken, longest))
        first = (*at, slice(longest))
        until = np.where(kept >= 0, np.take_along_axis(state.waiting_until[first], np.maximum(kept, 0), 1), until)
        soonest = np.where(event >= 0, until, FOREVER).min(1)
        wake = np.full(len(self.group), FOREVER)
        wake[queued] = np.where((event[:, 0] >= 0) & self.changed[queued], NEW, soonest)
        return after._replace(
            wake=put(state.wake, self.at, wake),
            waiting_event=put(state.waiting_event, first, event),
            waiting_until=put(state.waiting_until, first, until),
            waiting_held=put(state.waiting_held, first, held),
            waiting_other=put(state.waiting_other, first, other),
            alert=put(state.alert, self.at, self.now[ALERT]),
        )

    def changes(self) -> Changes:
        """The motions that have started."""
        if not self.changed.any():
            return NO_CHANGES
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
    """A copy of the array with values in some places; a large one itself where it has them already."""
    if array.size > WORTH_A_LOOK and (array[at] == values).all():
        return array
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


def queues_of(taken: Sequence[Turn], longest: int) -> tuple[NDArray[Any], ...]:
    """(G, longest) each: event, until, held, other, and the place in the old queue whose `until` is kept, -1 none."""
    rows = [
        [(one.event, one.until, one.held, one.other, one.slot if one.until == one.kept else -1) for one in turn.queue]
        + [NOTHING_WAITS] * (longest - len(turn.queue))
        for turn in taken
    ]
    return tuple(np.array(rows, np.int64).transpose(2, 0, 1))


def whole_numbers(turn: Turn) -> tuple[int, ...]:
    """What a turn has come to, in the order of STATE, ENDED, GOAL, CHANGED, CARRIED, ENTERED, WAITS and ALERT."""
    row = turn.machine.targets[turn.state]
    alert = any(one.until == MOMENT or (NEW < one.until < MOMENT and row[one.event] == MIXED) for one in turn.queue)
    return turn.state, turn.ended, turn.goal, turn.changes, turn.carried, turn.entered, len(turn.queue), alert
