"""One machine, tick by tick: durations are in ticks, inputs are `EVENT` (a press), `+EVENT` (it goes down) and `-EVENT` (it comes up)."""

import numpy as np
from statwalk.files.machinefile import read_machine
from statwalk.machine.build import Machine, MotionFacts, build
from statwalk.machine.state import fresh
from statwalk.machine.step import HOLD, PRESS, RELEASE, Inputs, StepResult, step

RATE = 60
DT = 1 / RATE
KINDS = {"+": HOLD, "-": RELEASE}


def text_of(table: str, ticks: dict[str, float], more: str = "") -> str:
    """A machine file: a state for each key of `ticks`, which loops where the name is in lower case; the first is the initial one."""
    states = "".join(f"  {name}: {{motion: {name}, loop: {str(name.islower()).lower()}}}\n" for name in ticks)
    rows = "".join(f"  {line}\n" for line in table.strip().splitlines())
    return f"character: c.glb\ninitial: {next(iter(ticks))}\nstates:\n{states}table: |\n{rows}{more}"


def machine_of(table: str, ticks: dict[str, float], more: str = "") -> Machine:
    return build(read_machine(text_of(table, ticks, more)), {name: MotionFacts(count / RATE) for name, count in ticks.items()})


def inputs_of(machine: Machine, *texts: str, actor: int = 0) -> Inputs:
    """The inputs of one actor."""
    events = [machine.events.index(text.lstrip("+-")) for text in texts]
    kinds = [KINDS.get(text[0], PRESS) for text in texts]
    return Inputs(np.full(len(texts), actor), np.array(events, np.int64), np.array(kinds, np.int64))


class Ticking:
    """An actor of a machine."""

    def __init__(self, table: str, ticks: dict[str, float], more: str = "") -> None:
        self.machine = machine_of(table, ticks, more)
        self.memory = fresh(self.machine, 1)
        self.tick = 0
        self.last: StepResult | None = None
        self.said: list[str] = []
        self.actions: list[str] = []

    def step(self, *inputs: str) -> str:
        """The state after one more tick."""
        self.tick += 1
        self.last = step(self.machine, self.memory, DT, self.tick, inputs_of(self.machine, *inputs))
        self.memory = self.last.state
        self.said = [f"{self.machine.events[one.event]} {one.verdict}" for one in self.last.verdicts]
        self.actions += [one.name for one in self.last.actions]
        return self.state

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
        return self.machine.states[int(self.memory.state[0, 0])]

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
