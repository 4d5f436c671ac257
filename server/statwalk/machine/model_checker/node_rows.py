"""A node of the search and the machine's row that it stands for: read, written, and found again by its
numbers.
"""

from __future__ import annotations

import numpy as np

from statwalk.machine.model_checker.state_space import (
    BEGUN,
    ENDED,
    MOST_WAITING,
    NOT_BEGUN,
    OF_NODES,
    QUEUE,
    STATE,
    TIME,
    WAITING,
    StateSpace,
)
from statwalk.machine.runtime.state import BEGINNING, MachineState
from statwalk.maths.arrays import Ints
from statwalk.maths.reference import called

NOW = 1000
"""the number of every tick: what counts is how much later something is"""
_ALMOST = 1e-4
"""of a tick: what a phase makes of a whole number of ticks may miss it by a bit"""


@called
def read_node(m: StateSpace, row: int, s: MachineState) -> None:
    """Makes the machine's row of a node."""
    time, begun, waiting = (
        m.node[row, TIME],
        m.node[row, BEGUN],
        m.node[row, WAITING],
    )
    s.state[0, 0], s.ended[0, 0], s.age[0, 0], s.waiting[0, 0] = (
        m.node[row, STATE],
        m.node[row, ENDED],
        0,
        waiting,
    )
    s.time[0, 0] = time
    s.passed[0, 0] = begun + BEGINNING if begun != NOT_BEGUN else time
    for slot in range(s.waiting_event.shape[2]):
        s.waiting_event[0, 0, slot], s.waiting_for[0, 0, slot], s.waiting_until[0, 0, slot] = -1, 0, 0
        s.waiting_held[0, 0, slot], s.waiting_other[0, 0, slot] = False, -1
        if slot < waiting:
            place = QUEUE + 3 * slot
            s.waiting_event[0, 0, slot], s.waiting_for[0, 0, slot] = (
                m.node[row, place],
                m.node[row, place + 1],
            )
            s.waiting_until[0, 0, slot] = NOW + m.node[row, place + 2]
    for history in range(s.last.shape[1]):
        s.last[0, history] = m.node[row, QUEUE + 3 * MOST_WAITING + history]


@called
def write_node(s: MachineState, is_new: int, numbers: Ints) -> None:
    """Writes the node of the machine's row after a tick. `is_new`: a motion began in the tick."""
    for k in range(numbers.shape[0]):
        numbers[k] = 0
    numbers[STATE], numbers[ENDED], numbers[WAITING] = s.state[0, 0], s.ended[0, 0], s.waiting[0, 0]
    numbers[TIME] = int(np.floor(s.time[0, 0] + _ALMOST))
    numbers[BEGUN] = int(np.floor(s.passed[0, 0] - BEGINNING + _ALMOST)) if is_new else NOT_BEGUN
    for slot in range(s.waiting[0, 0]):
        place = QUEUE + 3 * slot
        numbers[place], numbers[place + 1] = s.waiting_event[0, 0, slot], s.waiting_for[0, 0, slot]
        numbers[place + 2] = max(s.waiting_until[0, 0, slot] - NOW - 1, 0)
    for history in range(s.last.shape[1]):
        numbers[QUEUE + 3 * MOST_WAITING + history] = s.last[0, history]


@called
def place_of(m: StateSpace, numbers: Ints) -> int:
    """The row of the node with these numbers in the table; a free row if the table has no such node."""
    code = 17
    for k in range(numbers.shape[0]):
        code = ((code * 1000003) ^ (numbers[k] + 1)) & 0x7FFFFFFF
    last = m.place.shape[0] - 1
    place = (code ^ (code >> 15)) & last
    while m.place[place] >= 0 and _differs(m, m.place[place], numbers):
        place = (place + 1) & last
    return int(place)


@called
def _differs(m: StateSpace, row: int, numbers: Ints) -> bool:
    for k in range(numbers.shape[0]):  # noqa: SIM110 - kernels know no generators
        if m.node[row, k] != numbers[k]:
            return True
    return False


@called
def put_in_place(m: StateSpace, numbers: Ints) -> None:
    """Fills the table with all nodes."""
    for place in range(m.place.shape[0]):
        m.place[place] = -1
    for row in range(m.counts[OF_NODES]):
        for k in range(numbers.shape[0]):
            numbers[k] = m.node[row, k]
        m.place[place_of(m, numbers)] = row
