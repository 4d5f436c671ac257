"""Snapshots: states kept so that going back costs little; fewer of them the longer ago, so that a stage can run all night."""

from __future__ import annotations

from statwalk.stage.fold import StageState

EVERY = 60
"""ticks between snapshots near the head"""
REACH = 16
"""a snapshot whose number can be halved z times is kept for REACH·2^z numbers: about REACH/2 for each doubling of the past"""


class Snapshots:
    """States by tick. The state of tick 0 is always there."""

    def __init__(self, start: StageState) -> None:
        self._states = {0: start}

    def __len__(self) -> int:
        return len(self._states)

    def offer(self, state: StageState) -> None:
        """Keep a state that is never changed again, if it is its turn, and let go of those whose time is over."""
        if state.tick % EVERY == 0:
            self._states[state.tick] = state
            self._states = {tick: kept for tick, kept in self._states.items() if _is_kept(tick, state.tick)}

    def nearest(self, tick: int) -> StageState:
        """The latest state that is not after `tick`."""
        return self._states[max(kept for kept in self._states if kept <= tick)]

    def until(self, tick: int) -> Snapshots:
        """Those before `tick`: the past that a fork shares."""
        fork = Snapshots(self._states[0])
        fork._states.update({kept: state for kept, state in self._states.items() if kept < tick})
        return fork


def _is_kept(tick: int, head: int) -> bool:
    number = tick // EVERY
    halvings = number & -number  # 2^z, the largest power of two that divides it
    return number == 0 or head // EVERY - number <= REACH * halvings
