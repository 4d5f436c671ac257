"""One tick of N machines: motions advance, events are looked up, actions come out. Pure; the meaning is that of "One tick", rules 0 to 5.

Whoever has nothing to decide is stepped in a few array operations; the others take a `Turn`, one for all who are alike.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.built.runform import Machine
from statwalk.machine.ticking.advance import advance, speeds
from statwalk.machine.ticking.deciding import deciding
from statwalk.machine.ticking.given import Given
from statwalk.machine.ticking.record import NO_CHANGES, Action, Changes, Verdict
from statwalk.machine.ticking.sensing import sense
from statwalk.machine.ticking.smoothing import smooth
from statwalk.machine.ticking.spread import Spread
from statwalk.machine.ticking.state import MachineState
from statwalk.machine.ticking.turn import HOLD, PRESS, RAISED, RELEASE, TOUCH, TRAVEL
from statwalk.machine.ticking.turns import Batch, Turns
from statwalk.maths.arrays import Bools, Floats, Ints

__all__ = [
    "HOLD",
    "NOTHING",
    "PRESS",
    "RAISED",
    "RELEASE",
    "TOUCH",
    "TRAVEL",
    "Action",
    "Changes",
    "Inputs",
    "StepResult",
    "Surroundings",
    "Verdict",
    "speeds",
    "step",
]


class Inputs(NamedTuple):
    """What came from outside for this tick, (M,) each: what was touched, what others raised, then the log's, in its order."""

    actor: Ints
    """row of the batch"""
    event: Ints
    """column; of TRAVEL the state of the base to go to, -1 to go nowhere"""
    kind: Ints
    """PRESS, HOLD, RELEASE, TOUCH, RAISED or TRAVEL"""
    other: Ints | None = None
    """id of the actor that was touched, or raised the event; -1, or None for all: none"""


NOTHING = Inputs(*(np.zeros(0, np.int64) for _ in range(3)))


class Surroundings(NamedTuple):
    """What is not the machine's own, of N actors and L layers."""

    rate: Floats
    """(N, L) factor of time of each motion, beside its speed: what a blend of clips of several durations needs, else 1"""
    measured: Floats
    """(3, N) as shown at the tick before: metres per second along the ground, radians per second (left positive), height in metres"""
    key: NDArray[np.uint64]
    """(N,) of each actor's chance"""

    @classmethod
    def none(cls, actors: int, layers: int) -> Surroundings:
        """Standing still."""
        return cls(np.ones((actors, layers)), np.zeros((3, actors)), np.zeros(actors, np.uint64))


class StepResult(NamedTuple):
    """The state after the tick, and what happened in it."""

    state: MachineState
    changes: Changes
    verdicts: list[Verdict]
    actions: list[Action]
    time_before: NDArray[np.float64]
    """(N, L) seconds into the old motion at the end of the tick before"""
    time_reached: NDArray[np.float64]
    """(N, L) seconds into the old motion that it got to, before any change"""
    wraps: NDArray[np.int64]
    """(N, L) how often it began anew on the way"""


def step(
    machine: Machine, state: MachineState, dt: float, tick: int, inputs: Inputs = NOTHING, surroundings: Surroundings | None = None
) -> StepResult:
    """All actors after `dt` seconds, in the tick that `tick` names; `state` is left as it is."""
    around = surroundings or Surroundings.none(*state.state.shape)
    state = smooth(machine, state, dt)
    moved = advance(machine, state, dt, around.rate)
    after = state._replace(time=moved.time, passed=moved.time, age=state.age + np.int32(1), ended=moved.ended)
    some = deciding(machine, state, moved, tick, around.measured, dt)
    raised = np.zeros_like(state.sensing)
    if machine.senses:
        sensing, raised = sense(machine, state, around.measured, dt)
        after = after._replace(sensing=sensing)
        hear(machine, raised, some)
    if len(inputs.actor):
        receive(machine, inputs, some)
    if not some.any():
        return StepResult(after, NO_CHANGES, [], [], state.time, moved.time, moved.wraps)
    given = Given(len(some), inputs, raised)
    done = Spread(Turns(Batch(machine, state, moved, around.measured, around.key, tick, dt), some, given))
    return StepResult(done.state_after(after), done.changes(), done.verdicts(), done.actions(), state.time, moved.time, moved.wraps)


def hear(machine: Machine, raised: Bools, some: Bools) -> None:
    """Notes in `some` (N, L) the layers concerned by the senses `raised` (N, K)."""
    for column, one in enumerate(machine.senses):
        some |= raised[:, column, None] & machine.received[one.event]


def receive(machine: Machine, inputs: Inputs, some: Bools) -> None:
    """Notes in `some` (N, L) the layers concerned by the inputs."""
    travels = inputs.kind == TRAVEL
    some[inputs.actor[travels], 0] = True
    which, layers = machine.received[inputs.event[~travels]].nonzero()
    some[inputs.actor[~travels][which], layers] = True
