"""Ticks of 1 and 10,000 machines with conditions, buffers, clocks and blends, beside other state machines; `python benchmarks/machine.py`.

`transitions` and `python-statemachine` run in this process, XState in Node; all get the same events. Theirs is the same small machine
with one guard, and around it what an animated character needs (`peers/machines.py`, `peers/xstate.mjs`). Ours gives, beside the
states, a verdict with its reason for every event. All kinds run in turn, and the least time of all rounds counts.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from rounds import XState, least, show
from statwalk.files.machinefile import read_machine
from statwalk.machine.built.build import MotionFacts, build
from statwalk.machine.ticking.state import fresh
from statwalk.machine.ticking.step import Inputs, step

sys.path.insert(0, str(Path(__file__).parent / "peers"))
import machines

TICKS, ROUNDS = 20, 5
EVENTS = ("", "FORWARD", "STOP", "JUMP")
FEW = 100
"""machines of python-statemachine in place of 10,000, its seconds multiplied"""
GOALS = {"transitions": 1000.0, "XState": 500.0}
GOALS_OF_ONE = {"transitions": 10.0, "XState": 4.0, "python-statemachine": 100.0}
MACHINE = """
character: c.glb
initial: STAT
defaults: {blend: 0.2, buffer: 0.3}
parameters: {stamina: {default: 20, min: 0, max: 100}}
states:
  STAT: {motion: STAT, loop: true}
  STWK: {motion: STWK}
  WALK: {motion: WALK, loop: true}
  CSTP: {motion: CSTP}
  JUMP: {motion: JUMP}
table: |
  state | FORWARD | STOP | JUMP | END
  STAT  | STWK    |      |      |
  STWK  |         | CSTP |      | WALK
  WALK  |         | CSTP |      |
  CSTP  | STWK    |      |      | STAT
  JUMP  |         |      |      | WALK
cells:
  WALK/JUMP: [{if: stamina > 10, to: JUMP}]
"""


def events_of(count: int, share: float) -> np.ndarray:
    """(TICKS, count) rows of EVENTS; `share` of them are events."""
    chance = np.random.default_rng(count)
    return np.where(chance.random((TICKS, count)) < share, chance.integers(1, len(EVENTS), (TICKS, count)), 0)


def ours(rows: np.ndarray) -> Callable[[], None]:
    """All ticks of the rows, on from where the round before has ended."""
    machine = build(read_machine(MACHINE), {name: MotionFacts(seconds) for name, seconds in machines.DURATIONS.items()})
    state, now = fresh(machine, rows.shape[1]), 0
    given = [Inputs(actor := np.flatnonzero(row), row[actor] - 1, np.zeros(len(actor), np.int64)) for row in rows]

    def job() -> None:
        nonlocal state, now
        for inputs in given:
            now += 1
            state = step(machine, state, machines.DT, now, inputs).state

    return job


def names(rows: np.ndarray) -> Sequence[Sequence[str]]:
    """The events by name."""
    return [[EVENTS[event] for event in row] for row in rows]


def digits(rows: np.ndarray) -> list[str]:
    """The events as XState's script wants them."""
    return ["".join(map(str, row)) for row in rows]


def compare(title: str, count: int, share: float, goals: dict[str, float]) -> None:
    """One table: milliseconds a tick."""
    rows = events_of(count, share)
    some = rows[:, : min(count, FEW)]
    with XState() as node:
        jobs = {
            "statwalk": ours(rows),
            "transitions": machines.ticks(machines.transitions(count), names(rows)),
            "XState": node.job("machines", crowd=title, events=digits(rows)),
            "python-statemachine": machines.ticks(machines.statemachines(some.shape[1]), names(some)),
        }
        seconds = least(jobs, ROUNDS)
    seconds["python-statemachine"] *= count / some.shape[1]
    show(f"{title}, a tick", {name: value / TICKS for name, value in seconds.items()}, goals)


def main() -> None:
    """Print the tables."""
    compare("1 machine, an event in every tick", 1, 1.0, GOALS_OF_ONE)
    compare("10,000 machines, an event for each", 10_000, 1.0, GOALS)
    compare("10,000 machines, an event for one in 50", 10_000, 0.02, GOALS)


if __name__ == "__main__":
    main()
