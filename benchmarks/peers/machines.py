"""The machine of benchmarks/machine.py in `transitions` and `python-statemachine`.

Both libraries have states, events and guards. Their users write clocks of motions, END, buffers and blends:
this file has them as short as possible.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from statemachine import State, StateChart
from transitions import Machine

DT = 1 / 60
DURATIONS = {"STAT": 2.0, "STWK": 0.5, "WALK": 1.0, "CSTP": 0.5, "JUMP": 0.66}
LOOPS = {"STAT", "WALK"}
BUFFER, BLEND = 0.3, 0.2
TABLE = (
    ("FORWARD", "STAT", "STWK"),
    ("STOP", "STWK", "CSTP"),
    ("STOP", "WALK", "CSTP"),
    ("JUMP", "WALK", "JUMP"),
    ("FORWARD", "CSTP", "STWK"),
    ("END", "STWK", "WALK"),
    ("END", "CSTP", "STAT"),
    ("END", "JUMP", "WALK"),
)


class Body:
    """A character's clocks; `fire` sends an event to its machine, and returns whether the machine took it."""

    def __init__(self) -> None:
        self.stamina, self.time, self.blend = 20.0, 0.0, 0.0
        self.pending, self.left = "", 0.0

    def rested(self) -> bool:
        """Returns the guard of JUMP."""
        return self.stamina > 10

    def send_or_keep(self, event: str) -> None:
        """Sends an event; an event that the machine does not take is pending for its buffer."""
        if self.fire(event):
            self.time, self.blend = 0.0, BLEND
        else:
            self.pending, self.left = event, BUFFER

    def tick(self, event: str) -> None:
        """Advances the motion, the blend and the buffer by a tick, and sends the event and END."""
        state = self.name()
        self.time += DT
        if self.blend > 0:
            self.blend -= DT
        if self.pending:
            self.left -= DT
            if self.left <= 0:
                self.pending = ""
        if event:
            self.send_or_keep(event)
        if self.time >= DURATIONS[state]:
            self.end(state)

    def end(self, state: str) -> None:
        """Sends END, then the pending event."""
        if state in LOOPS:
            self.time -= DURATIONS[state]
        elif self.fire("END"):
            self.time, self.blend = 0.0, BLEND
            if self.pending and self.fire(self.pending):
                self.pending, self.time = "", 0.0


class WithTransitions(Body):
    """A character with `transitions`: triggers on a model."""

    state: str

    def fire(self, event: str) -> bool:
        """Sends an event; returns whether the machine took it."""
        return bool(self.trigger(event))  # type: ignore[attr-defined]

    def name(self) -> str:
        """Returns the name of the state."""
        return self.state


def transitions(count: int) -> list[Any]:
    """Returns `count` characters of one Machine."""
    bodies = [WithTransitions() for _ in range(count)]
    machine = Machine(
        model=bodies,
        states=list(DURATIONS),
        initial="STAT",
        auto_transitions=False,
        ignore_invalid_triggers=True,
    )
    for event, source, target in TABLE:
        machine.add_transition(event, source, target, conditions="rested" if event == "JUMP" else None)
    return bodies


class Chart(StateChart):
    """The machine in `python-statemachine`: a class."""

    allow_event_without_transition = True
    STAT = State(initial=True)
    STWK, WALK, CSTP, JUMPS = State(), State(), State(), State()
    FORWARD = STAT.to(STWK) | CSTP.to(STWK)
    STOP = STWK.to(CSTP) | WALK.to(CSTP)
    JUMP = WALK.to(JUMPS, cond="rested")
    END = STWK.to(WALK) | CSTP.to(STAT) | JUMPS.to(WALK)


class WithStatemachine(Body):
    """A character with a `Chart`."""

    def __init__(self) -> None:
        super().__init__()
        self.chart = Chart(self)

    def fire(self, event: str) -> bool:
        """Sends an event; returns whether the machine took it."""
        before = self.chart.configuration_values
        self.chart.send(event)
        return bool(self.chart.configuration_values != before)

    def name(self) -> str:
        """Returns the name of the state."""
        return str(next(iter(self.chart.configuration_values))).replace("JUMPS", "JUMP")


def statemachines(count: int) -> list[Any]:
    """Returns `count` characters, each with its own chart."""
    return [WithStatemachine() for _ in range(count)]


def ticks(bodies: Sequence[Body], events: Sequence[Sequence[str]]) -> Callable[[], None]:
    """Returns a job that runs the ticks of `events`: in each tick one event (empty: none) for
    each character.
    """

    def job() -> None:
        for row in events:
            for body, event in zip(bodies, row, strict=True):
                body.tick(event)

    return job
