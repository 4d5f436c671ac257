"""One tick of an actor with all that it can lead to: rules 0 to 5 of "One tick", for one layer, with conditions and weights free.

It says what `turn.Turn` says, for all outcomes at once; tests hold the two against each other.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

from statwalk.machine.built.runform import Machine
from statwalk.machine.built.runparts import AT_END, AT_MARKER, BLANK, MATCH, MIXED, NOW, OFF, UNDEFINED, Outcome
from statwalk.machine.proof.lengths import TICKS_PER_SECOND, Lengths
from statwalk.machine.proof.moments import EARLIER, FOR_END, FOR_MOMENT, NOBODY, Node, Now, choices, landings
from statwalk.machine.ticking.moments import crossed, in_window
from statwalk.machine.ticking.state import BEGINNING, ENDED, OWED, RUNNING
from statwalk.maths.phases import match


class Ticks:
    """A machine whose motions last so many ticks. `patient`: events wait in blank cells for their buffers."""

    def __init__(self, machine: Machine, lengths: Lengths, patient: bool) -> None:
        self.machine, self.lengths = machine, lengths
        self.buffers = [math.ceil(one * TICKS_PER_SECOND - 1e-4) if patient else 0 for one in machine.buffer.tolist()]

    def after(self, node: Node, press: int = NOBODY) -> list[Now]:
        """What a tick in which `press` comes (or nothing) can lead to."""
        return self.finished(self.begun(node), press)

    def begun(self, node: Node) -> list[Now]:
        """The first part of a tick: the motion advances, what waits is looked up, and markers."""
        first = self.advance(node)
        some = [first]
        for event, _ in node.queue:
            some = each(some, lambda one, event=event: self.meet(one, event) if one.left(event) is not None else [one])
        for name in first.crossed:
            some = each(some, lambda one, name=name: self.meet_marker(one, name))
        return some

    def finished(self, some: list[Now], press: int) -> list[Now]:
        """The second part: `press` comes (or nothing), and END."""
        if press != NOBODY:
            some = each(some, lambda one: self.receive(one, press))
        return [after for one in some for after in (self.end(one) if one.at_end else (one,))]

    def advance(self, node: Node) -> Now:
        """Rule 0: the motion advances."""
        state, length, moves = node.state, self.lengths.ticks[node.state], self.lengths.moves[node.state]
        loop, time = bool(self.machine.loop[state]), node.time + moves
        over = moves and time >= length
        wraps = int(over and loop)
        at_end = over and (loop or node.ended != ENDED)
        time = 0 if wraps else min(time, length)
        passed = float(node.time) if node.begun == EARLIER else node.begun + BEGINNING
        marks = crossed(self.machine.markers[state], length, passed, time, wraps) if moves and self.machine.markers[state] else ()
        ended = node.ended if not over else RUNNING if loop else ENDED
        queue = tuple((event, left - 1 if left > 0 else left) for event, left in node.queue)
        rest = node.time + 1 - length if at_end and not loop else 0
        return Now(state, time, passed, wraps, marks, ended, at_end, queue, rest)

    def receive(self, one: Now, event: int) -> list[Now]:
        """An event from outside; it renews one of the same name that waits."""
        return self.meet(one.wait(event, FOR_MOMENT) if one.left(event) is not None else one, event)

    def meet_marker(self, one: Now, name: str) -> list[Now]:
        """A marker is an event of the column of its name; where the cell says nothing it means nothing."""
        event = self.machine.columns.get(name, NOBODY)
        if event == NOBODY or not one.crossed or self.machine.targets[one.state][event] in (BLANK, OFF):
            return [one]
        return self.meet(one, event, fleeting=True)

    def meet(self, one: Now, event: int, fleeting: bool = False) -> list[Now]:
        """Rule 2: an event is looked up."""
        target = self.machine.targets[one.state][event]
        if target == BLANK:
            return self.meet_blank(one, event)
        if target in (OFF, UNDEFINED):
            return [one.forget(event)]
        if not self.is_now(one, event):
            return [one.wait(event, FOR_END if self.machine.whens[one.state][event] == AT_END else FOR_MOMENT)]
        outcomes, nothing = choices(self.machine, one.state, event)
        found = each(outcomes, lambda outcome: self.take(one.forget(event), outcome, event))
        if nothing:
            found += [one.forget(event)] if fleeting else self.meet_blank(one, event)
        return found

    def meet_blank(self, one: Now, event: int) -> list[Now]:
        """Rule 3: it waits for its buffer."""
        left = one.left(event)
        if left is None or left < 0:
            left = self.buffers[event]
        return [one.wait(event, left) if left else one.forget(event)]

    def is_now(self, one: Now, event: int) -> bool:
        """Whether the moment that the cell names has come."""
        when = self.machine.whens[one.state][event]
        if when == NOW:
            return True
        if when == AT_END:
            return not one.at_end and one.ended == ENDED
        moment = self.machine.moments[one.state, event]
        if when == AT_MARKER:
            return moment.marker in one.crossed
        return in_window(moment, self.lengths.ticks[one.state], one.passed, one.time, one.wraps)

    def take(self, one: Now, outcome: Outcome, event: int) -> list[Now]:
        """An outcome comes about: a motion starts, or the state stays."""
        if outcome.target == UNDEFINED:
            return [one]
        targets = landings(self.machine, outcome)
        return [self.change(one, target, outcome, event) if target != one.state or outcome.restart else one for target in targets]

    def change(self, one: Now, state: int, outcome: Outcome, event: int) -> Now:
        """Rule 5: what waited for a moment of the old motion waits no more."""
        queue = one.queue if state == one.state else tuple(waiting for waiting in one.queue if waiting[1] >= 0)
        begun = self.entered(one, state, outcome)
        reached, length = begun + one.rest * one.ending, self.lengths.ticks[state]
        reached = reached % length if self.machine.loop[state] else min(reached, length)
        return Now(state, reached, begun + BEGINNING, 0, (), RUNNING, False, queue, begun=begun, changes=(*one.changes, (event, state)))

    def entered(self, one: Now, state: int, outcome: Outcome) -> int:
        """Ticks into the new motion at which it begins."""
        machine, length = self.machine, self.lengths.ticks[state]
        phase = outcome.enter
        if phase == MATCH:
            loop = bool(machine.loop[one.state] and machine.loop[state])
            phase = float(match(machine.markers[one.state], machine.markers[state], one.time / self.lengths.ticks[one.state], loop))
        time = int(phase * length + 1e-4)
        return time % length if machine.loop[state] else time

    def end(self, one: Now) -> list[Now]:
        """Rule 4: what waited for the end, else the END column, else the idle event."""
        return self.end_of([event for event, left in one.queue if left == FOR_END], one._replace(ending=True), False)

    def end_of(self, waited: list[int], one: Now, stayed: bool) -> list[Now]:
        """The same for those that have waited for it and are left; `stayed`: one of them was taken, so END has no say."""
        if not waited:
            return [self.put_off(one)] if stayed else self.end_column(one)
        event, *others = waited
        outcomes, nothing = choices(self.machine, one.state, event)
        found: list[Now] = []
        for outcome in outcomes:
            for taken in self.take(one.forget(event), outcome, event):
                is_stay = stayed or outcome.target != UNDEFINED
                found += self.end_of(others, taken, is_stay) if taken.at_end else [taken]
        if nothing:
            found += each(self.meet_blank(one, event), lambda rest: self.end_of(others, rest, stayed))
        return found

    def put_off(self, one: Now) -> Now:
        """A stay at the end: of a motion that does not loop, END comes again in the next tick."""
        return one._replace(ended=RUNNING if self.machine.loop[one.state] else OWED)

    def end_column(self, one: Now) -> list[Now]:
        """Nothing has waited."""
        machine = self.machine
        target, idle = machine.targets[one.state][machine.end], machine.idle
        if target == UNDEFINED:
            return [one]
        silent = (lambda left: [left]) if target == OFF or idle < 0 else (lambda left: self.answer(left, idle, lambda rest: [rest]))
        return self.answer(one, machine.end, silent)

    def answer(self, one: Now, event: int, otherwise: Callable[[Now], list[Now]]) -> list[Now]:
        """What the cell of END, or of the idle event in its place, leads to; `otherwise` where it leads nowhere."""
        target = self.machine.targets[one.state][event]
        if target < 0 and target != MIXED:
            return otherwise(one)
        outcomes, nothing = choices(self.machine, one.state, event)
        found = each(outcomes, lambda outcome: otherwise(one) if outcome.target == UNDEFINED else self.take(one, outcome, event))
        return found + (otherwise(one) if nothing else [])


def each(some: Iterable[object], lead: Callable[..., list[Now]]) -> list[Now]:
    """All that each of some leads to."""
    return [after for one in some for after in lead(one)]
