"""All that can happen to an actor: the nodes that it can come to, and how long it can take from each of
them to a goal.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.program import Program
from statwalk.machine.model_checker.explore import explore
from statwalk.machine.model_checker.found_ticks import EVERYTHING, MORE_NODES, MORE_TAKEN, MORE_TICKS, PAUSED
from statwalk.machine.model_checker.longest import longest
from statwalk.machine.model_checker.state_space import (
    BEGUN,
    MOST_GUESSES,
    MOST_WAITING,
    NODE_ARRAYS,
    NOTHING,
    OF_NODES,
    OF_WORK,
    QUEUE,
    STATE,
    TAKEN_ARRAYS,
    TICK_ARRAYS,
    Guesses,
    StateSpace,
    columns,
    doubled,
    empty_state_space,
    trimmed,
)
from statwalk.machine.model_checker.work import TOO_MANY, TooManyError, Work
from statwalk.machine.runtime.effects import MOST_DRAWS, effects_for
from statwalk.machine.runtime.state import fresh
from statwalk.machine.runtime.surroundings import Inputs, Measurements
from statwalk.maths.arrays import Bools, Floats, Ints

MOST_BYTES = 1 << 27
"""of memory for one search"""
PAUSE_WORK = 100_000
"""ticks between two looks at the checkpoint: some 50 ms"""
SHORT = {MORE_NODES: NODE_ARRAYS, MORE_TICKS: TICK_ARRAYS, MORE_TAKEN: TAKEN_ARRAYS}
"""the arrays that need more room, by how an exploration ends"""


class Taken(NamedTuple):
    """An event that is taken in a state; `to` -1: the state stays and its motion goes on."""

    event: int
    state: int
    to: int


class SearchStep(NamedTuple):
    """A tick: the event that comes from outside, and what it leads to."""

    press: int
    taken: tuple[Taken, ...] = ()
    is_free: bool = False
    """conditions or chance have decided"""

    @property
    def changes(self) -> tuple[tuple[int, int], ...]:
        """Event and new state of each change."""
        return tuple((one.event, one.to) for one in self.taken if one.to >= 0)


def beginning(program: Program) -> Ints:
    """(1, C) the node in which an actor begins."""
    numbers = np.zeros((1, columns(program.inside.shape[1])), np.int32)
    numbers[0, STATE], numbers[0, BEGUN] = program.initials[0], 0
    numbers[0, QUEUE + 3 * MOST_WAITING :] = -1
    return numbers


def searched(
    program: Program, starts: Ints, first: Sequence[int], presses: Sequence[int], work: Work
) -> Search:
    """All that can follow the nodes `starts` (N, C).

    first    the events that come in the tick after a start that is marked as first
    presses  the events that may come in every other tick; at most one in each

    :raises TooManyError: if there is more than `work` allows.
    """
    room = 2 * (64 + program.target.shape[1] * 12 + 4 * len(program.marker_event))
    surroundings, inputs = Measurements.none(1), Inputs.of([0], [0])
    guesses, space = _no_guesses(program, starts), _space_of(program, starts, room)
    given = np.array(first, np.int64), np.array([NOTHING, *presses], np.int64)
    effects, state = effects_for(program, 1, room), fresh(program, 1)
    end = PAUSED
    while end in SHORT or end == PAUSED:
        end = explore(
            program, state, surroundings, inputs, effects, space, guesses, *given, work.left, PAUSE_WORK
        )
        if end in SHORT:
            space = doubled(space, SHORT[end])
            if sum(array.nbytes for array in space) > MOST_BYTES:
                break
        work.checkpoint()
    work.spend(int(space.counts[OF_WORK]))
    if end != EVERYTHING:
        raise TooManyError(TOO_MANY)
    return Search(trimmed(space))


def _no_guesses(program: Program, starts: Ints) -> Guesses:
    return Guesses(
        np.zeros((MOST_GUESSES, len(program.code) - 1), np.uint8),
        np.zeros((MOST_GUESSES, MOST_DRAWS)),
        np.zeros(starts.shape[1], np.int32),
    )


def _space_of(program: Program, starts: Ints, room: int) -> StateSpace:
    """A state space with the nodes `starts`, and room for at least `room` more."""
    count = len(starts)
    size = max(1 << 12, 1 << int(2 * count).bit_length(), 1 << room.bit_length())
    space = empty_state_space(program.inside.shape[1], size)
    space.node[:count], space.found_by[:count], space.counts[OF_NODES] = starts, -1, count
    return space


class Search:
    """Nodes and ticks, once all are found. T ticks, M nodes."""

    def __init__(self, space: StateSpace) -> None:
        self.space = space
        self.start, self.end = space.start, space.end
        self.states: NDArray[np.int32] = space.node[:, STATE]
        """(M,)"""
        self.first_taken = np.concatenate([[0], space.past]).astype(np.int64)
        self.tick_of = np.repeat(np.arange(len(self.start)), np.diff(self.first_taken))
        """(K,) of each event that is taken"""
        self.work = len(self.start) + len(self.tick_of)
        """the cost of one pass over all ticks"""

    @cached_property
    def first_tick(self) -> NDArray[np.int64]:
        """(M + 1,) where the ticks of each node begin."""
        return np.searchsorted(self.start, np.arange(len(self.states) + 1))

    def _changes_to(self, states: Collection[int]) -> Bools:
        """(K,) the events taken that lead to one of the states."""
        return np.isin(self.space.taken[:, 2], list(states))

    def ticks_of(self, taken: Bools) -> Bools:
        """(T,) the ticks in which one of the events is taken."""
        found = np.zeros(len(self.start), bool)
        found[self.tick_of[taken]] = True
        return found

    def entering(self, states: Collection[int]) -> Bools:
        """(T,) the ticks in which one of the states is entered, perhaps to be left again in it."""
        return self.ticks_of(self._changes_to(states))

    def entering_after(self, states: Collection[int], since: Collection[int]) -> Bools:
        """(T,) the ticks in which one of the states is entered no sooner than one of `since`, if that is
        entered in the tick.
        """
        first = self._first(since)
        begun = np.where(first == len(self.tick_of), 0, first)
        return self.ticks_of(self._changes_to(states) & (np.arange(len(first)) >= begun))

    def entering_before(self, states: Collection[int], others: Collection[int]) -> Bools:
        """(T,) the ticks in which one of the states is entered, and none of `others` sooner than it."""
        return self.ticks_of(self._changes_to(states) & (np.arange(len(self.tick_of)) < self._first(others)))

    def _first(self, states: Collection[int]) -> NDArray[np.int64]:
        """(K,) the first event that leads to one of the states in the tick of each event; K where none
        does.
        """
        first, leads = np.full(len(self.start), len(self.tick_of)), np.flatnonzero(self._changes_to(states))
        np.minimum.at(first, self.tick_of[leads], leads)
        return first[self.tick_of]

    def longest(self, goals: Collection[int]) -> Floats:
        """(M,) the most ticks that it can take until one of `goals` is entered; infinite where they can be
        avoided.
        """
        return longest(self.start, self.end, self.entering(goals), len(self.states))

    def step(self, tick: int) -> SearchStep:
        """A tick in a form to be told."""
        events = self.space.taken[self.first_taken[tick] : self.first_taken[tick + 1]].tolist()
        taken = tuple(Taken(*event) for event in events)
        return SearchStep(int(self.space.press[tick]), taken, bool(self.space.is_free[tick]))

    def way(self, node: int) -> list[int]:
        """The ticks by which a node was found."""
        ticks: list[int] = []
        while (tick := int(self.space.found_by[node])) >= 0:
            ticks.append(tick)
            node = int(self.start[tick])
        return ticks[::-1]

    def beyond(self, node: int, goals: Collection[int], values: Floats, limit: int) -> list[int]:
        """Ticks from a node that enter no goal, `limit` of them; from outside comes as little as will do,
        as late as it can.
        """
        is_goal, run = self.entering(goals), list[int]()
        while len(run) < limit:
            some = range(int(self.first_tick[node]), int(self.first_tick[node + 1]))
            tick = next(
                one for one in some if not is_goal[one] and len(run) + 1 + values[self.end[one]] > limit
            )
            run.append(tick)
            node = int(self.end[tick])
        return run

    def shortest(self, goals: Bools, allowed: Bools) -> list[int] | None:
        """The fewest ticks from the beginning to one of `goals` (T,), by `allowed` ones (T,); None where
        there is no way.

        Ticks in which nothing is left to conditions and chance are tried first.
        """
        sure = self.space.is_free == 0
        return self._shortest(goals & sure, allowed & sure) or self._shortest(goals, allowed)

    def _shortest(self, goals: Bools, allowed: Bools) -> list[int] | None:
        found_by = np.full(len(self.states), -1)
        seen, border = np.zeros(len(self.states), bool), np.array([0])
        seen[0] = True
        while len(border):
            counts = self.first_tick[border + 1] - self.first_tick[border]
            ticks = np.repeat(
                self.first_tick[border] - np.concatenate([[0], np.cumsum(counts)[:-1]]), counts
            ) + np.arange(counts.sum())
            if goals[ticks].any():
                return self._back(found_by, int(ticks[goals[ticks]][0]))
            ticks = ticks[allowed[ticks] & ~seen[self.end[ticks]]]
            border, rows = np.unique(self.end[ticks], return_index=True)
            border = border[np.argsort(rows)]
            found_by[border] = ticks[np.sort(rows)]
            seen[border] = True
        return None

    def _back(self, found_by: Ints, tick: int) -> list[int]:
        ticks = [tick]
        while (before := int(found_by[self.start[ticks[-1]]])) >= 0:
            ticks.append(before)
        return ticks[::-1]
