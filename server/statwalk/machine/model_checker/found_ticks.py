"""The ticks that an exploration finds: each is kept once, with the events that it took and where it leads."""

from __future__ import annotations

from statwalk.machine.model_checker.node_rows import place_of
from statwalk.machine.model_checker.state_space import (
    OF_NODES,
    OF_TAKEN,
    OF_TICKS,
    StateSpace,
)
from statwalk.machine.runtime.effects import EVENT, FROM, OF_VERDICTS, TO, VERDICT, MachineEffects
from statwalk.machine.runtime.reasons import TAKEN
from statwalk.maths.arrays import Ints
from statwalk.maths.reference import called

EVERYTHING, TOO_MUCH, MORE_NODES, MORE_TICKS, MORE_TAKEN, PAUSED = range(6)
"""how an exploration ends: all is found; it takes more work than is allowed, or more than can be kept of a
node; more room is needed; the caller may cancel it, or go on
"""


@called
def room(m: StateSpace, out: MachineEffects) -> int:
    """Returns EVERYTHING if there is room for one more tick, else what is full."""
    if m.counts[OF_NODES] == m.node.shape[0]:
        return MORE_NODES
    if m.counts[OF_TICKS] == m.start.shape[0]:
        return MORE_TICKS
    return MORE_TAKEN if m.counts[OF_TAKEN] + out.verdicts.shape[0] > m.taken.shape[0] else EVERYTHING


@called
def add_tick(
    m: StateSpace, out: MachineEffects, numbers: Ints, row: int, ticks: int, press: int, is_free: int
) -> None:
    """A tick, and the node that it leads to, unless a tick from the same node has brought about the
    same.
    """
    place, tick = place_of(m, numbers), m.counts[OF_TICKS]
    past = _add_taken(m, out)
    if m.place[place] >= 0 and _is_known(m, m.place[place], ticks, past, is_free):
        return
    if m.place[place] < 0:
        found = m.counts[OF_NODES]
        for k in range(numbers.shape[0]):
            m.node[found, k] = numbers[k]
        m.place[place], m.found_by[found], m.counts[OF_NODES] = found, tick, found + 1
    m.start[tick], m.end[tick], m.press[tick], m.is_free[tick], m.past[tick] = (
        row,
        m.place[place],
        press,
        is_free,
        past,
    )
    m.counts[OF_TICKS], m.counts[OF_TAKEN] = tick + 1, past


@called
def _add_taken(m: StateSpace, out: MachineEffects) -> int:
    """Appends the events taken in the tick to the events of earlier ticks; returns the new end."""
    past = int(m.counts[OF_TAKEN])
    for row in range(out.counts[OF_VERDICTS]):
        if out.verdicts[row, VERDICT] == TAKEN:
            m.taken[past, 0], m.taken[past, 1], m.taken[past, 2] = (
                out.verdicts[row, EVENT],
                out.verdicts[row, FROM],
                out.verdicts[row, TO],
            )
            past += 1
    return past


@called
def _is_known(m: StateSpace, end: int, ticks: int, past: int, is_free: int) -> bool:
    """Whether a tick from the same node leads to the same by the same events, as free of chance at
    least.
    """
    last, count = m.counts[OF_TICKS], past - m.counts[OF_TAKEN]
    for tick in range(ticks, last):
        begin = m.past[tick - 1] if tick > 0 else 0
        if (
            m.end[tick] == end
            and m.past[tick] - begin == count
            and m.is_free[tick] <= is_free
            and _is_same(m, begin, count)
        ):
            return True
    return False


@called
def _is_same(m: StateSpace, begin: int, count: int) -> bool:
    first = m.counts[OF_TAKEN]
    for k in range(count):
        for column in range(3):
            if m.taken[begin + k, column] != m.taken[first + k, column]:
                return False
    return True
