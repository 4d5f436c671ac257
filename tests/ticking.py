"""One machine, tick by tick: durations are in ticks, inputs are `EVENT` (a press), `+EVENT` (it goes down) and `-EVENT` (it comes up)."""

from collections.abc import Mapping

import numpy as np
from statwalk.files.machinefile import read_machine
from statwalk.machine.built.build import Machine, MotionFacts, build
from statwalk.machine.ticking.state import fresh
from statwalk.machine.ticking.step import HOLD, PRESS, RELEASE, Inputs, StepResult, Surroundings, step

RATE = 60
DT = 1 / RATE
KINDS = {"+": HOLD, "-": RELEASE}
Markers = Mapping[str, Mapping[str, float]]
"""motion -> marker -> ticks from its start"""


def text_of(table: str, ticks: dict[str, float], more: str = "") -> str:
    """A machine file: a state for each key of `ticks`, which loops where the name is in lower case; the first is the initial one."""
    states = "".join(f"  {name}: {{motion: {name}, loop: {str(name.islower()).lower()}}}\n" for name in ticks)
    rows = "".join(f"  {line}\n" for line in table.strip().splitlines())
    return f"character: c.glb\ninitial: {next(iter(ticks))}\nstates:\n{states}table: |\n{rows}{more}"


def machine_of(table: str, ticks: dict[str, float], more: str = "", markers: Markers | None = None) -> Machine:
    return built(text_of(table, ticks, more), ticks, markers)


def built(text: str, ticks: dict[str, float], markers: Markers | None = None) -> Machine:
    """The machine of a file; `ticks` are the durations of the motions."""
    facts = {
        name: MotionFacts(count / RATE, None, tuple((mark, at / RATE) for mark, at in (markers or {}).get(name, {}).items()))
        for name, count in ticks.items()
    }
    return build(read_machine(text), facts)


def inputs_of(machine: Machine, *texts: str, actor: int = 0) -> Inputs:
    """The inputs of one actor."""
    events = [machine.events.index(text.lstrip("+-")) for text in texts]
    kinds = [KINDS.get(text[0], PRESS) for text in texts]
    return Inputs(np.full(len(texts), actor), np.array(events, np.int64), np.array(kinds, np.int64))


class Ticking:
    """An actor of a machine."""

    def __init__(self, table: str, ticks: dict[str, float], more: str = "", markers: Markers | None = None) -> None:
        self.begin(machine_of(table, ticks, more, markers))

    @classmethod
    def of(cls, text: str, ticks: dict[str, float], markers: Markers | None = None) -> "Ticking":
        """An actor of the machine that a whole file says; `ticks` are the durations of its motions."""
        actor = cls.__new__(cls)
        actor.begin(built(text, ticks, markers))
        return actor

    def begin(self, machine: Machine) -> None:
        self.machine = machine
        self.memory = fresh(machine, 1)
        self.around = Surroundings.none(1, len(machine.layers))
        self.tick = 0
        self.last: StepResult | None = None
        self.said: list[str] = []
        self.actions: list[str] = []

    def step(self, *inputs: str) -> str:
        """The state after one more tick."""
        return self.give(inputs_of(self.machine, *inputs))

    def give(self, inputs: Inputs) -> str:
        """The same with inputs of any kind."""
        self.tick += 1
        self.last = step(self.machine, self.memory, DT, self.tick, inputs, self.around)
        self.memory = self.last.state
        self.said = [f"{self.machine.events[one.event]} {one.verdict}" for one in self.last.verdicts]
        self.actions += [one.name for one in self.last.actions]
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
        return [self.machine.events[event] for event in self.memory.waiting_event[0, 0].tolist() if event >= 0]

    @property
    def reasons(self) -> list[str]:
        assert self.last is not None
        return [one.reason for one in self.last.verdicts]
