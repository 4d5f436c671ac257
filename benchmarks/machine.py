"""Measures ticks of 1 and 10,000 machines with conditions, buffers, clocks and blends, and of other state
machines: `python benchmarks/machine.py`.

`transitions` and `python-statemachine` run in this process, XState in Node; all get the same events. The
peers run the same small machine with one guard, with the clocks, buffers and blends of an animated character
around it (`peers/machines.py`, `peers/xstate.mjs`). statwalk also returns a verdict with its reason for every
event. All run in turn, and the least time of all rounds counts.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from rounds import XState, least, show
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import MotionFacts, build
from statwalk.machine.compile.program import PROGRAM
from statwalk.machine.runtime.effects import EFFECTS, effects_for
from statwalk.machine.runtime.state import STATE, fresh
from statwalk.machine.runtime.surroundings import SURROUNDINGS, Inputs, Measurements
from statwalk.maths.packed import packed
from statwalk.stage.steps.step_machines import step_machines

sys.path.insert(0, str(Path(__file__).parent / "peers"))
import machines

TICKS, ROUNDS = 20, 5
EVENTS = ("", "FORWARD", "STOP", "JUMP")
FEW = 100
"""python-statemachine runs 100 machines instead of 10,000, and its time is multiplied"""
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
    """Returns (TICKS, count) indices into EVENTS; 0 is no event, and `share` of them are events."""
    chance = np.random.default_rng(count)
    return np.where(chance.random((TICKS, count)) < share, chance.integers(1, len(EVENTS), (TICKS, count)), 0)


def statwalk_job(rows: np.ndarray) -> Callable[[], None]:
    """Returns a job that runs all ticks of the rows; each round continues from the previous round."""
    machine = build(
        read_machine(MACHINE), {name: MotionFacts(seconds) for name, seconds in machines.DURATIONS.items()}
    )
    count, now = rows.shape[1], 0
    program, state = packed(machine.program, PROGRAM), packed(fresh(machine.program, count), STATE)
    effects, around = (
        packed(effects_for(machine.program, count), EFFECTS),
        packed(Measurements.none(count), SURROUNDINGS),
    )
    inputs_by_tick = [Inputs.of(actor := np.flatnonzero(row), row[actor] - 1) for row in rows]

    def job() -> None:
        nonlocal now, effects
        for inputs in inputs_by_tick:
            now += 1
            effects = step_machines(program, state, machines.DT, now, inputs, around, effects)

    return job


def names(rows: np.ndarray) -> Sequence[Sequence[str]]:
    """Returns the names of the events."""
    return [[EVENTS[event] for event in row] for row in rows]


def digits(rows: np.ndarray) -> list[str]:
    """Returns the events as the XState script reads them: one digit for each machine."""
    return ["".join(map(str, row)) for row in rows]


def compare(title: str, count: int, share: float, goals: dict[str, float]) -> None:
    """Prints one table in milliseconds a tick."""
    rows = events_of(count, share)
    some = rows[:, : min(count, FEW)]
    with XState() as node:
        jobs = {
            "statwalk": statwalk_job(rows),
            "transitions": machines.ticks(machines.transitions(count), names(rows)),
            "XState": node.job("machines", crowd=title, events=digits(rows)),
            "python-statemachine": machines.ticks(machines.statemachines(some.shape[1]), names(some)),
        }
        seconds = least(jobs, ROUNDS)
    seconds["python-statemachine"] *= count / some.shape[1]
    show(f"{title}, a tick", {name: value / TICKS for name, value in seconds.items()}, goals)


def main() -> None:
    """Prints the tables."""
    compare("1 machine, an event in every tick", 1, 1.0, GOALS_OF_ONE)
    compare("10,000 machines, an event for each", 10_000, 1.0, GOALS)
    compare("10,000 machines, an event for one in 50", 10_000, 0.02, GOALS)


if __name__ == "__main__":
    main()
