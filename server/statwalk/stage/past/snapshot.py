"""Snapshots: states kept so that going back costs little; the fewer the longer ago, and the larger. A stage can run all night."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from statwalk.stage.fold import StageState

EVERY = 60
"""ticks between snapshots near the head"""
REACH = 16
"""a snapshot whose number can be halved z times is kept for REACH·2^z numbers: about REACH/2 for each doubling of the past"""
MOST_BYTES = 256 << 20
"""where a crowd's snapshots come to more, the reach is halved until they do not; the newest stays in any case"""


class Snapshots:
    """States by tick. The state of tick 0 is always there."""

    def __init__(self, start: StageState, most_bytes: int = MOST_BYTES) -> None:
        self._states = {0: start}
        self._bytes = {0: size(start)}
        self._most_bytes = most_bytes

    def __len__(self) -> int:
        return len(self._states)

    @property
    def bytes(self) -> int:
        """What they take in memory, but for what is shared by all states."""
        return sum(self._bytes.values())

    def offer(self, state: StageState) -> None:
        """Keep a state that is never changed again, if it is its turn, and let go of those whose time is over."""
        if state.tick % EVERY == 0:
            self._put(self._states | {state.tick: state}, self._bytes | {state.tick: size(state)}, state.tick)

    def nearest(self, tick: int) -> StageState:
        """The latest state that is not after `tick`."""
        return self._states[max(kept for kept in self._states if kept <= tick)]

    def until(self, tick: int) -> Snapshots:
        """Those before `tick`: the past that a fork shares."""
        fork = Snapshots(self._states[0], self._most_bytes)
        fork._states = {kept: state for kept, state in self._states.items() if kept < tick or kept == 0}
        fork._bytes = {kept: self._bytes[kept] for kept in fork._states}
        return fork

    def _put(self, states: Mapping[int, StageState], sizes: Mapping[int, int], head: int) -> None:
        """Those of the states that are to be kept while the head is at `head`."""
        reach = REACH
        kept = [tick for tick in states if _is_kept(tick, head, reach)]
        while reach and sum(sizes[tick] for tick in kept) > self._most_bytes:
            reach //= 2
            kept = [tick for tick in kept if _is_kept(tick, head, reach)]
        self._states = {tick: states[tick] for tick in kept}
        self._bytes = {tick: sizes[tick] for tick in kept}


def size(state: StageState) -> int:
    """Bytes of the arrays that a state holds, each counted once."""
    world = (state.contacts.touching, *(state.contacts.bodies or ()), *(array for flight in state.flights for array in flight[1:]))
    arrays: dict[int, np.ndarray[Any, Any]] = {id(array): array for array in world}
    for cast in state.casts:
        own = (cast.ids, cast.position, cast.heading, cast.way, cast.hash)
        arrays |= {id(array): array for array in (*own, *cast.shown, *cast.before, *cast.fading, *cast.machine.arrays())}
    return sum(array.nbytes for array in arrays.values())


def _is_kept(tick: int, head: int, reach: int) -> bool:
    number = tick // EVERY
    halvings = number & -number  # 2^z, the largest power of two that divides it
    return number in (0, head // EVERY) or head // EVERY - number <= reach * halvings
