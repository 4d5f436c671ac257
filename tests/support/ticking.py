"""One machine, tick by tick: durations are in ticks, inputs are `EVENT` (a press), `+EVENT` (it goes down)
and `-EVENT` (it comes up).
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import Machine, MotionFacts, build
from statwalk.machine.compile.program import PROGRAM, Program
from statwalk.machine.runtime.effects import EFFECTS, MachineEffects, effects_for
from statwalk.machine.runtime.reasons import VERDICTS
from statwalk.machine.runtime.result import StepResult, result_of
from statwalk.machine.runtime.state import STATE, MachineState, fresh
from statwalk.machine.runtime.surroundings import HOLD, PRESS, RELEASE, SURROUNDINGS, Inputs, Measurements
from statwalk.maths.packed import packed
from statwalk.stage.effects.words import Line, lines, sentence, values_of
from statwalk.stage.steps.step_machines import step_machines

RATE = 60
DT = 1 / RATE
KINDS = {"+": HOLD, "-": RELEASE}
Markers = Mapping[str, Mapping[str, float]]
"""motion -> marker -> ticks from its start"""


def text_of(table: str, ticks: dict[str, float], more: str = "") -> str:
    """A machine file: a state for each key of `ticks`, which loops where the name is in lower case; the first
    is the initial one.
    """
    states = "".join(f"  {name}: {{motion: {name}, loop: {str(name.islower()).lower()}}}\n" for name in ticks)
    rows = "".join(f"  {line}\n" for line in table.strip().splitlines())
    return f"character: c.glb\ninitial: {next(iter(ticks))}\nstates:\n{states}table: |\n{rows}{more}"


def machine_of(
    table: str, ticks: dict[str, float], more: str = "", markers: Markers | None = None
) -> Machine:
    return built(text_of(table, ticks, more), ticks, markers)


def built(text: str, ticks: dict[str, float], markers: Markers | None = None) -> Machine:
    """The machine of a file; `ticks` are the durations of the motions."""
    facts = {
        name: MotionFacts(
            count / RATE, None, tuple((mark, at / RATE) for mark, at in (markers or {}).get(name, {}).items())
        )
        for name, count in ticks.items()
    }
    return build(read_machine(text), facts)


def inputs_of(machine: Machine, *texts: str, actor: int = 0) -> Inputs:
    """The inputs of one actor."""
    events = [machine.events.index(text.lstrip("+-")) for text in texts]
    kinds = [KINDS.get(text[0], PRESS) for text in texts]
    return Inputs.of(np.full(len(texts), actor), events, kinds)


class Verdict(NamedTuple):
    """What became of an event, in words; states and events as rows of the machine, the actor as a row of the
    batch.
    """

    actor: int
    layer: int
    event: int
    verdict: str
    reason: str
    from_state: int
    to_state: int
    cell: tuple[str, str]
    values: tuple[tuple[str, float], ...]
    other: int


class Action(NamedTuple):
    """What came out."""

    actor: int
    name: str
    arguments: tuple[str | float, ...]
    other: int
    layer: int


def verdicts_of(machine: Machine, done: StepResult) -> list[Verdict]:
    return [_verdict(machine, done, row, line) for row, line in enumerate(lines(done.verdicts))]


def _verdict(machine: Machine, done: StepResult, row: int, line: Line) -> Verdict:
    cell = machine.text.cells.get((line.from_state, line.event), ("", ""))
    reason = sentence(machine.program, machine.text, line)
    values = values_of(machine.text, done.verdicts, row)
    said = (VERDICTS[line.verdict], reason, line.from_state, line.to_state)
    return Verdict(line.actor, line.layer, line.event, *said, cell, values, line.other)


def actions_of(machine: Machine, done: StepResult) -> list[Action]:
    return [
        Action(actor, *machine.text.actions[row], other, layer)
        for actor, layer, row, other in done.actions.tolist()
    ]


def stepped(
    program: Program,
    state: MachineState,
    tick: int,
    inputs: Inputs,
    around: Measurements,
    effects: MachineEffects | None = None,
) -> StepResult:
    """One tick; `state` is left as it is."""
    after = state.copy()
    effects = effects_for(program, len(state.state)) if effects is None else effects
    machine, room = (packed(program, PROGRAM), packed(after, STATE)), packed(effects, EFFECTS)
    done = step_machines(*machine, DT, tick, inputs, packed(around, SURROUNDINGS), room)
    return result_of(after, done.values)


class Ticking:
    """An actor of a machine."""

    def __init__(
        self, table: str, ticks: dict[str, float], more: str = "", markers: Markers | None = None
    ) -> None:
        self.begin(machine_of(table, ticks, more, markers))

    @classmethod
    def of(cls, text: str, ticks: dict[str, float], markers: Markers | None = None) -> "Ticking":
        """An actor of the machine that a whole file says; `ticks` are the durations of its motions."""
        actor = cls.__new__(cls)
        actor.begin(built(text, ticks, markers))
        return actor

    def begin(self, machine: Machine) -> None:
        self.machine = machine
        self.program = machine.program
        self.memory = fresh(machine.program, 1)
        self.around = Measurements.none(1)
        self.tick = 0
        self.last: StepResult | None = None
        self.said: list[str] = []
        self.verdicts: list[Verdict] = []
        self.done: list[Action] = []
        self.actions: list[str] = []

    def step(self, *inputs: str) -> str:
        """The state after one more tick."""
        return self.give(inputs_of(self.machine, *inputs))

    def give(self, inputs: Inputs) -> str:
        """The same with inputs of any kind."""
        self.tick += 1
        self.effects = effects_for(self.program, 1)
        self.last = stepped(self.program, self.memory, self.tick, inputs, self.around, self.effects)
        self.memory = self.last.state
        self.verdicts = verdicts_of(self.machine, self.last)
        self.done = actions_of(self.machine, self.last)
        self.said = [f"{self.machine.events[one.event]} {one.verdict}" for one in self.verdicts]
        self.actions += [one.name for one in self.done]
        return self.state

    def set(self, **parameters: float) -> None:
        """Parameters, from the next tick on."""
        values = self.memory.parameters.copy()
        for name, value in parameters.items():
            values[0, [one.name for one in self.machine.parameters].index(name)] = value
        self.memory = self.memory._replace(parameters=values)

    def measure(self, speed: float = 0.0, turning: float = 0.0, height: float = 0.0) -> None:
        """What was shown at the tick before, from now on."""
        self.around = self.around._replace(measured=np.array([[speed], [turning], [height]]))

    def change(self, name: str, values: Mapping[int, float]) -> None:
        """Another program: some rows of one of its arrays."""
        array = getattr(self.program, name).copy()
        for row, value in values.items():
            array[row] = value
        array.flags.writeable = False
        self.program = self.program._replace(**{name: array})

    def run(self, count: int) -> str:
        """The state after so many more ticks."""
        for _ in range(count):
            self.step()
        return self.state

    def path(self, count: int) -> list[tuple[int, str]]:
        """(tick, state) of each change in so many more ticks."""
        found, before = [], self.state
        for _ in range(count):
            if self.step() != before:
                found.append((self.tick, self.state))
            before = self.state
        return found

    @property
    def state(self) -> str:
        return self.states[0]

    @property
    def states(self) -> list[str]:
        """The state of each layer."""
        return [self.machine.states[state] for state in self.memory.state[0]]

    @property
    def time_in_ticks(self) -> float:
        return round(float(self.memory.time[0, 0]) * RATE, 6)

    @property
    def waiting(self) -> list[str]:
        return [
            self.machine.events[event] for event in self.memory.waiting_event[0, 0].tolist() if event >= 0
        ]

    @property
    def reasons(self) -> list[str]:
        return [one.reason for one in self.verdicts]
