"""Runs of random machines without poses: every bit of their states, verdicts, changes and actions as one
digest.

`python step_runs.py` prints the digest and the number of verdicts.
"""

import hashlib
from random import Random
from typing import NamedTuple

import numpy as np
from run_machines import machine
from statwalk.errors import StatwalkError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import build
from statwalk.machine.compile.compile_states import MotionFacts
from statwalk.machine.compile.program import PROGRAM
from statwalk.machine.compile.resolved_table import resolved_tables
from statwalk.machine.runtime.effects import EFFECTS, effects_for
from statwalk.machine.runtime.result import result_of
from statwalk.machine.runtime.state import STATE, fresh
from statwalk.machine.runtime.surroundings import SURROUNDINGS, Inputs, Measurements
from statwalk.maths.packed import packed
from statwalk.stage.steps.step_machines import step_machines

SECONDS = {"stand": 2.0, "walk": 1.0, "hop": 0.5, "turn": 0.913, "nod": 0.213}
FACTS = {name: MotionFacts(seconds, False, ()) for name, seconds in SECONDS.items()}
ACTORS, TICKS, SEEDS = 3, 60, range(14)
KEYS = np.arange(ACTORS, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)


class Digest(NamedTuple):
    bits: str
    verdicts: int


def digest() -> Digest:
    """The digest of one run for each seed whose machine is valid."""
    bits, verdicts = hashlib.sha256(), 0
    for seed in SEEDS:
        for state, result in _run(Random(seed)):
            for array in (*state, *result.verdicts, *result.changes, result.actions):
                bits.update(np.ascontiguousarray(array).tobytes())
            verdicts += len(result.verdicts.rows)
    return Digest(bits.hexdigest(), verdicts)


def _run(chance: Random):
    """The state and the result of each tick."""
    try:
        definition = read_machine(machine(chance, False).text, "m")
        program = build(definition, FACTS, resolved_tables(definition, FACTS)).program
    except StatwalkError:
        return
    state = fresh(program, ACTORS)
    measured = Measurements(np.zeros((3, ACTORS)), KEYS)
    arguments = packed(program, PROGRAM), packed(state, STATE)
    around, effects = packed(measured, SURROUNDINGS), packed(effects_for(program, ACTORS), EFFECTS)
    for tick in range(1, TICKS):
        inputs = _inputs(chance, program.target.shape[1] - 1)
        effects = step_machines(*arguments, 1 / 60, tick, inputs, around, effects)
        yield state, result_of(state, effects.values)


def _inputs(chance: Random, events: int) -> Inputs:
    """None to three inputs: press, hold or release."""
    rows = [
        (chance.randrange(ACTORS), chance.randrange(events), chance.choice([0, 0, 1, 2]), -1)
        for _ in range(chance.choice([0, 0, 1, 3]))
    ]
    return Inputs.of(*np.array(rows, np.int64).reshape(-1, 4).T)


if __name__ == "__main__":
    print(*digest())
