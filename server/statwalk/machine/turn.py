"""One actor's turn in a tick: the events that reach it, in order, and what becomes of each (rules 1 to 5 of "One tick")."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from statwalk.machine.record import Action, Change, Record, Verdict, Waiting
from statwalk.machine.runform import AT_END, BLANK, OFF, UNDEFINED, Machine
from statwalk.machine.state import ENDED, FOREVER, MOST_WAITING, NEW, OWED, RUNNING

PRESS, HOLD, RELEASE, TOUCH, RAISED, TRAVEL = range(6)
"""kinds of inputs: a tap, a key that goes down, a key that comes up, a touch, raised by another actor, a state to travel to"""
MOST_CHANGES = 8


@dataclass
class Turn:
    """An actor (and layer) while its tick is worked out. Seconds and ticks; `held` as in MachineState."""

    machine: Machine
    record: Record
    tick: int
    dt: float
    actor: int
    layer: int
    state: int
    time: float
    ended: int
    """RUNNING, ENDED or OWED"""
    at_end: bool
    """END came in this tick and has not been answered"""
    owed: bool
    """this END is one that a stay has put off"""
    carry: float
    """seconds of this tick that were left after END"""
    queue: list[Waiting]
    held: list[int]
    parameters: list[float]
    changes: int = 0
    ending: bool = False
    """END is being answered: the motion that follows takes over `carry`"""

    def run(self, inputs: Iterable[tuple[int, int]]) -> None:
        """All events of the tick: the waiting ones, the inputs (event, kind), END."""
        if self.at_end:
            self.wait_again()
        for waiting in tuple(self.queue):
            if waiting in self.queue:  # a change of state may have ended its waiting
                self.meet(waiting.event, waiting)
        for event, kind in inputs:
            self.receive(event, kind)
        if self.at_end:
            self.end()

    def receive(self, event: int, kind: int) -> None:
        """An input from outside."""
        waiting = next((one for one in self.queue if one.event == event), None)
        if kind == RELEASE:
            self.release(event, waiting)
            return
        if event == self.machine.end or (kind == HOLD and self.held[event]):
            self.verdict(event, "dropped", "it is held already" if self.held[event] else "only a motion raises END")
            return
        if kind == HOLD:
            self.held[event] = max(self.held) + 1
        if waiting:
            waiting.until, waiting.held = NEW, False  # a newer one of the same name renews it, in its place
        self.meet(event, waiting)

    def release(self, event: int, waiting: Waiting | None) -> None:
        """The key is up: what waits only because it was held is dropped; a press of its own goes on waiting."""
        self.held[event] = 0
        if waiting and waiting.held:
            self.drop(event, waiting, "it was released")

    def meet(self, event: int, waiting: Waiting | None) -> None:
        """Rule 2: an event is looked up in the state that the ones before it have led to."""
        target = self.machine.targets[self.state][event]
        if self.changes == MOST_CHANGES:
            self.put_off(event, waiting)
        elif target == BLANK:
            self.meet_blank(event, waiting)
        elif target < 0:
            self.drop(event, waiting, "the cell is -" if target == OFF else f"{self.undefined(event)} is no state")
        elif self.machine.whens[self.state][event] == AT_END and (self.at_end or self.ended != ENDED):
            self.wait(event, waiting, FOREVER, "the cell says: at end")
        else:
            self.forget(waiting)
            self.take(event, "the motion has ended" if self.machine.whens[self.state][event] == AT_END else "")

    def meet_blank(self, event: int, waiting: Waiting | None) -> None:
        """Rule 3: in a blank cell an event waits for its buffer, through changes of state."""
        buffer = float(self.machine.buffer[event])
        begun = waiting is not None and waiting.until not in (NEW, FOREVER)
        until = waiting.until if waiting and begun else self.tick + math.ceil(buffer / self.dt - 1e-4)
        if self.tick < until:
            self.wait(event, waiting, until, f"the cell is blank; it waits for {buffer:g} s")
        else:
            self.drop(event, waiting, f"the cell is blank, and {buffer:g} s are over" if begun else "the cell is blank")

    def wait(self, event: int, waiting: Waiting | None, until: int, reason: str) -> None:
        """The event stays in its place in the queue, or goes to the end of it."""
        if waiting is None:
            self.queue.append(Waiting(event, until))
            self.make_room()
        elif waiting.until == until:
            return  # nothing new: that verdict was given before
        else:
            waiting.until = until
            if self.owed and waiting.held:
                return  # nor is this
        self.verdict(event, "waits", reason)

    def put_off(self, event: int, waiting: Waiting | None) -> None:
        """Rule 5: what is left over after 8 changes comes first in the next tick."""
        if waiting is None:
            self.queue.append(Waiting(event, NEW))
            self.make_room()
        self.verdict(event, "waits", f"{MOST_CHANGES} changes were made in this tick")

    def make_room(self) -> None:
        """At most 16 wait."""
        if len(self.queue) > MOST_WAITING:
            self.drop(self.queue[0].event, self.queue[0], f"more than {MOST_WAITING} were waiting, and it was the oldest")

    def drop(self, event: int, waiting: Waiting | None, reason: str) -> None:
        """The event is gone."""
        self.forget(waiting)
        self.verdict(event, "dropped", reason)

    def forget(self, waiting: Waiting | None) -> None:
        """It waits no longer."""
        if waiting is not None:
            self.queue.remove(waiting)

    def take(self, event: int, reason: str, silent: bool = False) -> bool:
        """The cell fires; whether a motion has started. `silent`: the same stay as in the tick before."""
        machine, here = self.machine, self.state
        target, restart = machine.targets[here][event], bool(machine.restart[here, event])
        action = int(machine.action[here, event])
        starts = target != here or restart
        if not silent:
            self.verdict(event, "taken", reason or ("" if starts else "stays"), target if starts else -1)
            if action >= 0:
                self.record.actions.append(Action(self.tick, self.actor, machine.actions[action].name, machine.actions[action].arguments))
        if starts:
            self.change(event, target, action)
        return starts

    def change(self, event: int, target: int, action: int) -> None:
        """Rule 5: the old motion's END is cleared, and the new motion starts in this tick."""
        here, machine = self.state, self.machine
        self.changes += 1
        self.state, self.ended, self.at_end = target, RUNNING, False
        self.time = self.entering(target) if self.ending else 0.0
        self.record.changes.append(
            Change(
                self.actor,
                self.layer,
                here,
                target,
                event,
                action,
                float(machine.blend[here, event]),
                target == here,
                self.time,
                int(machine.curve[here, event]),
            )
        )
        if target != here:
            self.leave(here)

    def entering(self, state: int) -> float:
        """Seconds into a motion that takes over the time left after END."""
        machine = self.machine
        row, duration = int(machine.speed_parameter[state]), float(machine.duration[state])
        time = self.carry * (self.parameters[row] if row >= 0 else float(machine.speed[state]))
        if machine.loop[state]:
            return math.fmod(time, duration) if duration > 0 else 0.0
        return min(time, duration)

    def leave(self, old: int) -> None:
        """What waited for a moment of the old motion waits no more; what is held counts as waiting again."""
        for waiting in tuple(self.queue):
            if waiting.until == FOREVER:
                self.queue.remove(waiting)
                if not self.held[waiting.event]:
                    reason = f"{self.machine.states[old]} was left before its end"
                    self.record.verdicts.append(Verdict(self.tick, self.actor, self.layer, waiting.event, "dropped", reason, old, -1))
        self.wait_again()

    def wait_again(self) -> None:
        """Inputs that are held wait again, by the order in which they went down; they are looked up with the waiting ones."""
        waiting = {one.event for one in self.queue}
        down = [event for event, order in enumerate(self.held) if order and event not in waiting]
        for event in sorted(down, key=self.held.__getitem__):
            self.queue.append(Waiting(event, NEW, held=True))
            self.make_room()

    def end(self) -> None:
        """Rule 4: what waited for the end, else the END column, else the idle event, else the last pose holds or the loop goes on."""
        machine, stayed, self.ending = self.machine, False, True
        target = machine.targets[self.state][machine.end]
        for waiting in [one for one in self.queue if one.until == FOREVER]:
            self.forget(waiting)
            if self.take(waiting.event, "at the end of the motion", silent=self.owed and waiting.held):
                return
            stayed = True
        if stayed:
            # The END column had no say. Of a motion that does not loop nothing is left, and END comes again in each tick until it has.
            self.ended = RUNNING if machine.loop[self.state] else OWED
        elif target >= 0:
            self.take(machine.end, "")
        elif target == UNDEFINED:
            self.drop(machine.end, None, f"{self.undefined(machine.end)} is no state")
        elif target == BLANK and machine.idle >= 0 and machine.targets[self.state][machine.idle] >= 0:
            self.take(machine.idle, "nothing else happened at the end of the motion")

    def undefined(self, event: int) -> str:
        """What the table names here and is no state."""
        return self.machine.undefined[self.state, event]

    def verdict(self, event: int, verdict: str, reason: str, to_state: int = -1) -> None:
        """Records what became of an event."""
        self.record.verdicts.append(Verdict(self.tick, self.actor, self.layer, event, verdict, reason, self.state, to_state))
