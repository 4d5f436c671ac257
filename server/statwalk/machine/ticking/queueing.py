"""An actor (and layer) while its tick is worked out, and the events that wait for it (rule 3 of "One tick")."""

from __future__ import annotations

from dataclasses import dataclass, field

from statwalk.machine.built.runform import Machine
from statwalk.machine.built.runparts import AT_MARKER
from statwalk.machine.conditions.program import Program
from statwalk.machine.ticking.asking import Answers, Asked
from statwalk.machine.ticking.record import Record, Verdict, Waiting
from statwalk.machine.ticking.state import FOREVER, MOMENT, MOST_WAITING, NEW

MOST_CHANGES = 8


@dataclass(slots=True)
class Queueing:
    """Where the actor is in its tick. Seconds and ticks; `held`, `last`, `goal` as in MachineState."""

    machine: Machine
    record: Record
    answers: Answers
    tick: int
    dt: float
    actor: int
    layer: int
    index: int
    """the actor's place in `answers`"""
    key: int
    """of its chance"""
    state: int
    time: float
    passed: float
    """seconds into the motion at the tick before; a little less than where it began, if it began in this tick"""
    wraps: int
    crossed: tuple[str, ...]
    """markers of the motion that this tick has crossed, in the order of time"""
    ended: int
    """RUNNING, ENDED or OWED"""
    at_end: bool
    """END came in this tick and has not been answered"""
    owed: bool
    """this END is one that a stay has put off"""
    queue: list[Waiting]
    held: list[int]
    last: list[int]
    goal: int
    changes: int = 0
    entered: bool = False
    """the state is another one than at the tick before, or again the same after another"""
    ending: bool = False
    """END is being answered: the motion that follows takes over the time that is left"""
    carried: bool = False
    """what was left of the tick after END has still to come on top"""
    draws: int = 0
    """how often chance has decided"""
    questions: list[tuple[Program, bool]] = field(default_factory=list)
    """the conditions that were asked, and their answers"""
    keys_moved: bool = False
    """`held` has changed"""
    personal: bool = False
    """it went by the actor's own phase or chance"""
    asked: Asked = ()
    """what the conditions of the cell looked up last have seen"""
    because: str = ""
    """why that cell led where it did, or nowhere"""
    note: str = ""
    """what is said of the event at hand beside: which sense raised it"""

    def wait(self, event: int, waiting: Waiting | None, until: int, reason: str, other: int = -1) -> None:
        """The event stays in its place in the queue, or goes to the end of it."""
        if waiting is None:
            self.queue.append(Waiting(event, until, other=other))
            self.make_room()
        elif waiting.until == until:
            return  # nothing new: that verdict was given before
        else:
            waiting.until = until
            if self.owed and waiting.held:
                return  # nor is this
        self.verdict(event, "waits", reason, other=other)

    def put_off(self, event: int, waiting: Waiting | None, other: int) -> None:
        """Rule 5: what is left over after 8 changes comes first in the next tick."""
        if waiting is None:
            self.queue.append(Waiting(event, NEW, other=other))
            self.make_room()
        self.verdict(event, "waits", f"{MOST_CHANGES} changes were made in this tick", other=other)

    def make_room(self) -> None:
        """At most 16 wait."""
        if len(self.queue) > MOST_WAITING:
            self.drop(self.queue[0].event, self.queue[0], f"more than {MOST_WAITING} were waiting, and it was the oldest")

    def drop(self, event: int, waiting: Waiting | None, reason: str, other: int = -1) -> None:
        """The event is gone."""
        self.forget(waiting)
        self.verdict(event, "dropped", reason, other=waiting.other if waiting else other)

    def forget(self, waiting: Waiting | None) -> None:
        """It waits no longer."""
        if waiting is not None:
            self.queue.remove(waiting)

    def leave(self, old: int) -> None:
        """What waited for a moment of the old motion waits no more; what is held counts as waiting again."""
        for waiting in tuple(self.queue):
            if waiting.until in (FOREVER, MOMENT):
                self.queue.remove(waiting)
                if not self.held[waiting.event]:
                    self.left_behind(old, waiting)
        self.wait_again()

    def left_behind(self, old: int, waiting: Waiting) -> None:
        """The verdict on what waited for a moment that the old state has not come to."""
        place, machine = (old, waiting.event), self.machine
        moment = machine.moments.get(place)
        what = "its end" if moment is None else f"its marker {moment.marker}" if machine.when[place] == AT_MARKER else f"its {moment}"
        reason, cell = f"{machine.states[old]} was left before {what}", machine.sources[place]
        self.record.verdicts.append(
            Verdict(self.tick, self.actor, self.layer, waiting.event, "dropped", reason, old, -1, cell, other=waiting.other)
        )

    def wait_again(self) -> None:
        """Inputs that are held wait again, by the order in which they went down; they are looked up with the waiting ones."""
        if not any(self.held):
            return
        waiting, concerned = {one.event for one in self.queue}, self.machine.receivers[self.layer]
        down = [event for event, order in enumerate(self.held) if order and event not in waiting and concerned[event]]
        for event in sorted(down, key=self.held.__getitem__):
            self.queue.append(Waiting(event, NEW, held=True))
            self.make_room()

    def verdict(self, event: int, verdict: str, reason: str, to_state: int = -1, other: int = -1) -> None:
        """Records what became of an event."""
        said = f"{self.note}; {reason}" if self.note and reason else self.note or reason
        cell = self.machine.sources.get((self.state, event), ("", ""))
        self.record.verdicts.append(
            Verdict(self.tick, self.actor, self.layer, event, verdict, said, self.state, to_state, cell, self.asked, other)
        )
