"""Snapshots: states kept so that seeking back is cheap. The older or larger the states, the fewer are kept.

A stage can run all night. A snapshot is the state as bytes: rows without empty lanes, decoded only when it is
opened.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from statwalk.character.role import Role
from statwalk.stage.history.state_codec import from_bytes, to_bytes
from statwalk.stage.state.stage_state import StageState

EVERY = 60
"""ticks between snapshots near the head"""
REACH = 64
"""a snapshot whose number can be halved z times is kept for REACH·2^z numbers: about REACH/2 snapshots for
each doubling of the past
"""
MOST_BYTES = 256 << 20
"""if the snapshots of a crowd take more bytes, the reach is halved until they fit; the newest snapshot is
always kept
"""


class Snapshots:
    """States by tick. The oldest one, of tick `first`, is always kept."""

    def __init__(
        self,
        start: StageState,
        most_bytes: int = MOST_BYTES,
        later: Mapping[int, bytes] = MappingProxyType({}),
    ) -> None:
        self.first = start.tick
        self._data = {self.first: to_bytes(start), **later}
        self._most_bytes = most_bytes

    def __len__(self) -> int:
        return len(self._data)

    @property
    def size(self) -> int:
        """Bytes that the snapshots take in memory."""
        return sum(map(len, self._data.values()))

    @property
    def data(self) -> Mapping[int, bytes]:
        """The states as bytes."""
        return self._data

    def offer(self, state: StageState) -> None:
        """Keeps a state if its tick is a multiple of EVERY, and drops states that are no longer needed."""
        if state.tick % EVERY == 0:
            self._put(self._data | {state.tick: to_bytes(state)}, state.tick)

    def nearest(self, tick: int) -> int:
        """Returns the tick of the latest snapshot up to `tick`."""
        return max(kept for kept in self._data if kept <= tick)

    def open(self, tick: int, roles: Mapping[str, Role]) -> StageState:
        """Returns a copy of the snapshot of a tick that `nearest` returned."""
        return from_bytes(self._data[tick], roles)

    def until(self, tick: int) -> Snapshots:
        """Returns the snapshots before `tick`, the past that a fork shares."""
        return self._with(
            {kept: data for kept, data in self._data.items() if kept < tick or kept == self.first}
        )

    def after(self, tick: int) -> Snapshots:
        """Returns the snapshots from `tick` on, of which there is one."""
        return self._with({kept: data for kept, data in self._data.items() if kept >= tick})

    def _with(self, data: dict[int, bytes]) -> Snapshots:
        other = Snapshots(StageState(), self._most_bytes)
        other.first, other._data = min(data), data
        return other

    def _put(self, data: Mapping[int, bytes], head: int) -> None:
        """Keeps the states that are needed while the head is at `head`."""
        reach = REACH
        kept = [tick for tick in data if tick == self.first or _is_kept(tick, head, reach)]
        while reach and sum(len(data[tick]) for tick in kept) > self._most_bytes:
            reach //= 2
            kept = [tick for tick in kept if tick == self.first or _is_kept(tick, head, reach)]
        self._data = {tick: data[tick] for tick in kept}


def _is_kept(tick: int, head: int, reach: int) -> bool:
    number = tick // EVERY
    halvings = number & -number  # 2^z, the largest power of two that divides `number`
    return number == head // EVERY or head // EVERY - number <= reach * halvings
