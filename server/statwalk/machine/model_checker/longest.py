"""The most ticks that it can take from each node until a goal is entered."""

from __future__ import annotations

import numpy as np
from numba import types

from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.compiling import inlined, kernel, read, write

_INTS = read(types.int64, 1)


@inlined
def _count(start: Ints, is_goal: Bools, left: Ints, value: Floats) -> None:
    """How many ticks of each node enter no goal; a tick that enters one takes 1."""
    for tick in range(start.shape[0]):
        if is_goal[tick]:
            value[start[tick]] = 1.0
        else:
            left[start[tick]] += 1


@inlined
def _settle(
    start: Ints,
    by_end: Ints,
    first: Ints,
    is_goal: Bools,
    left: Ints,
    queue: Ints,
    value: Floats,
    node: int,
    count: int,
) -> int:
    """Passes a settled node's length to the nodes before it; a node whose ticks are all known joins the
    queue.
    """
    for k in range(first[node], first[node + 1]):
        tick = by_end[k]
        if not is_goal[tick]:
            before = start[tick]
            value[before] = max(value[before], value[node] + 1)
            left[before] -= 1
            if left[before] == 0:
                queue[count] = before
                count += 1
    return count


@kernel(
    _INTS,
    _INTS,
    _INTS,
    read(types.boolean, 1),
    write(types.int64, 1),
    write(types.int64, 1),
    write(types.float64, 1),
)
def _fill(
    start: Ints, by_end: Ints, first: Ints, is_goal: Bools, left: Ints, queue: Ints, value: Floats
) -> None:
    _count(start, is_goal, left, value)
    count, done = 0, 0
    for node in range(left.shape[0]):
        if left[node] == 0:
            queue[count] = node
            count += 1
    while done < count:
        count = _settle(start, by_end, first, is_goal, left, queue, value, queue[done], count)
        done += 1
    for node in range(left.shape[0]):  # what is left leads round for ever
        if left[node] > 0:
            value[node] = np.inf


def longest(start: Ints, end: Ints, is_goal: Bools, nodes: int) -> Floats:
    """(M,) ticks, infinite where a goal can be avoided for ever.

    `start`, `end`, `is_goal` (T,): of each tick; whether it enters a goal.
    """
    by_end = np.argsort(end, kind="stable")
    first = np.searchsorted(end[by_end], np.arange(nodes + 1))
    value = np.zeros(nodes)
    _fill(
        start.astype(np.int64),
        by_end,
        first,
        is_goal,
        np.zeros(nodes, np.int64),
        np.zeros(nodes, np.int64),
        value,
    )
    return value
