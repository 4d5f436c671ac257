"""One actor's turn in a tick: the events that reach it, in order, and what becomes of each (rules 1 to 5 of "One tick")."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from statwalk.machine.built.runparts import AT_END, AT_MARKER, BLANK, MIXED, NOW, OFF, UNDEFINED
from statwalk.machine.ticking.moments import in_window
from statwalk.machine.ticking.queueing import MOST_CHANGES
from statwalk.machine.ticking.record import Waiting
from statwalk.machine.ticking.state import ENDED, FOREVER, MOMENT, NEW, OWED, RUNNING
from statwalk.machine.ticking.taking import Taking

PRESS, HOLD, RELEASE, TOUCH, RAISED, TRAVEL = range(6)
"""kinds of inputs: a tap, a key that goes down, a key that comes up, a touch, raised by another actor, a state to travel to"""


@dataclass(slots=True)
class Turn(Taking):
    """An actor (and layer) whose tick is worked out."""

    def run(self, sensed: Iterable[int], inputs: Iterable[tuple[int, int, int]]) -> None:
        """All events of the tick: the waiting ones, markers, senses (rows), inputs (event, kind, other), END."""
        if self.at_end:
            self.wait_again()
        for waiting in tuple(self.queue):
            if waiting in self.queue:  # a change of state may have ended its waiting
                self.meet(waiting.event, waiting, waiting.other)
        if self.crossed:
            self.meet_markers()
        for row in sensed:
            self.note = f"sensed: {self.machine.senses[row].said}"
            self.receive(self.machine.senses[row].event, PRESS, -1)
        self.note = ""
        for event, kind, other in inputs:
            self.receive(event, kind, other)
        if self.at_end:
            self.end()
        if self.layer == 0 and self.goal == self.state:
            self.goal = -1

    def meet_markers(self) -> None:
        """Markers are events of the columns of their names; where the cell says nothing they mean nothing, and do not wait."""
        for name in self.crossed:
            event = self.machine.columns.get(name, -1)
            if event >= 0 and self.crossed and self.machine.targets[self.state][event] not in (BLANK, OFF):
                self.meet(event, self.waiting_for(event), -1, fleeting=True)

    def waiting_for(self, event: int) -> Waiting | None:
        """The event of that name that waits."""
        return next((one for one in self.queue if one.event == event), None)

    def receive(self, event: int, kind: int, other: int) -> None:
        """An event from outside of the motion."""
        if kind == TRAVEL:
            self.goal = event
            return
        concerned = self.machine.receivers[self.layer][event]
        waiting = self.waiting_for(event)
        if kind == RELEASE:
            self.release(event, waiting)
        elif event == self.machine.end or (kind == HOLD and self.held[event]):
            if concerned:
                self.verdict(event, "dropped", "it is held already" if self.held[event] else "only a motion raises END")
        else:
            if kind == HOLD:
                self.held[event], self.keys_moved = max(self.held) + 1, True
            if waiting:
                waiting.until, waiting.held, waiting.other = NEW, False, other  # a newer one of the same name renews it, in its place
            if concerned:
                self.meet(event, waiting, other)

    def release(self, event: int, waiting: Waiting | None) -> None:
        """The key is up: what waits only because it was held is dropped; a press of its own goes on waiting."""
        self.held[event], self.keys_moved = 0, True
        if waiting and waiting.held:
            self.drop(event, waiting, "it was released")

    def meet(self, event: int, waiting: Waiting | None, other: int, fleeting: bool = False) -> None:
        """Rule 2: an event is looked up in the state that the ones before it have led to. `fleeting`: it does not wait in a blank cell."""
        target = self.machine.targets[self.state][event]
        self.asked = ()
        if self.changes == MOST_CHANGES:
            self.put_off(event, waiting, other)
        elif target == BLANK:
            self.meet_blank(event, waiting, other)
        elif target in (OFF, UNDEFINED):
            self.drop(event, waiting, "the cell is -" if target == OFF else f"{self.undefined(event)} is no state", other)
        elif not self.is_now(event):
            at_end = self.machine.whens[self.state][event] == AT_END
            self.wait(event, waiting, FOREVER if at_end else MOMENT, f"the cell says: {self.moment(event)}", other)
        else:
            self.fire(event, waiting, other, fleeting)

    def fire(self, event: int, waiting: Waiting | None, other: int, fleeting: bool) -> None:
        """The moment has come: the cell leads somewhere, unless nothing in it is true."""
        one = self.choose(event)
        if one is None and fleeting:
            self.drop(event, waiting, self.because)
        elif one is None:
            self.meet_blank(event, waiting, other, self.because)
        elif one.target == UNDEFINED:
            self.drop(event, waiting, f"{one.to} is no state", other)
        else:
            self.forget(waiting)
            self.take(event, one, self.reached(event), other)

    def meet_blank(self, event: int, waiting: Waiting | None, other: int, why: str = "the cell is blank") -> None:
        """Rule 3: in a blank cell an event waits for its buffer, through changes of state."""
        buffer = float(self.machine.buffer[event])
        begun = waiting is not None and waiting.until not in (NEW, FOREVER, MOMENT)
        until = waiting.until if waiting and begun else self.tick + math.ceil(buffer / self.dt - 1e-4)
        if self.tick < until:
            self.wait(event, waiting, until, f"{why}; it waits for {buffer:g} s", other)
        else:
            self.drop(event, waiting, f"{why}, and {buffer:g} s are over" if begun else why, other)

    def is_now(self, event: int) -> bool:
        """Whether the moment that the cell names has come."""
        when = self.machine.whens[self.state][event]
        if when == NOW:
            return True
        if when == AT_END:
            return not self.at_end and self.ended == ENDED
        moment = self.machine.moments[self.state, event]
        if when == AT_MARKER:
            return moment.marker in self.crossed
        self.personal = True
        return in_window(moment, float(self.machine.duration[self.state]), self.passed, self.time, self.wraps)

    def moment(self, event: int) -> str:
        """The moment that the cell names, in words."""
        moment = self.machine.moments.get((self.state, event))
        return "at end" if moment is None else f"at {moment}" if moment.kind == "marker" else str(moment)

    def reached(self, event: int) -> str:
        """Why the moment has come, in words; empty where the cell says `now`."""
        when = self.machine.whens[self.state][event]
        return "" if when == NOW else "the motion has ended" if when == AT_END else f"{self.moment(event).removeprefix('at ')} has come"

    def end(self) -> None:
        """Rule 4: what waited for the end, else the END column, else the idle event, else the last pose holds or the loop goes on."""
        stayed, self.ending = False, True
        for waiting in [one for one in self.queue if one.until == FOREVER]:
            one = self.choose(waiting.event)
            if one is None or one.target == UNDEFINED:
                self.fire(waiting.event, waiting, waiting.other, False)
                continue
            self.forget(waiting)
            if self.take(waiting.event, one, "at the end of the motion", waiting.other, silent=self.owed and waiting.held):
                return
            stayed = True
        if stayed:
            # The END column had no say. Of a motion that does not loop nothing is left, and END comes again in each tick until it has.
            self.ended = RUNNING if self.machine.loop[self.state] else OWED
        else:
            self.end_column()

    def end_column(self) -> None:
        """Nothing has waited: the END column, else the idle event."""
        machine, row = self.machine, self.machine.targets[self.state]
        self.asked = ()
        if row[machine.end] == UNDEFINED:
            self.drop(machine.end, None, f"{self.undefined(machine.end)} is no state")
            return
        if self.answered(machine.end, "") or row[machine.end] == OFF or machine.idle < 0:
            return
        self.answered(machine.idle, "nothing else happened at the end of the motion")

    def answered(self, event: int, reason: str) -> bool:
        """Whether the cell of END, or of the idle event in its place, has fired."""
        target = self.machine.targets[self.state][event]
        one = self.choose(event) if target >= 0 or target == MIXED else None
        if one is not None and one.target != UNDEFINED:
            self.take(event, one, reason)
            return True
        if target == MIXED:
            self.drop(event, None, f"{one.to} is no state" if one else self.because)
        return False

    def undefined(self, event: int) -> str:
        """What the table names here and is no state."""
        return self.machine.undefined[self.state, event]
