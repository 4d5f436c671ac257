"""What a cell does when it fires: an outcome is chosen, its action comes out, a motion starts (rules 5 and 6 of "One tick")."""

from __future__ import annotations

import math
from dataclasses import dataclass

from statwalk.machine.built.runparts import MATCH, MIXED, Outcome
from statwalk.machine.conditions.program import Program
from statwalk.machine.ticking.chance import chance
from statwalk.machine.ticking.queueing import Queueing
from statwalk.machine.ticking.record import Action, Change
from statwalk.machine.ticking.state import BEGINNING, RUNNING
from statwalk.maths.phases import match


@dataclass(slots=True)
class Taking(Queueing):
    """An actor whose cells fire."""

    def choose(self, event: int) -> Outcome | None:
        """The outcome of the cell of this state: the first that is true, or the one that is drawn; None where nothing is true."""
        several = self.machine.outcomes[self.state, event]
        self.asked, self.because = (), ""
        if self.machine.targets[self.state][event] != MIXED:
            return several[0]
        if several[0].weight is not None:
            return self.draw(event, several)
        for number, one in enumerate(several, 1):
            if one.condition is None or self.ask(one.condition):
                self.explain(several[:number], f"since {one.said}" if one.said else "")
                return one
        self.explain(several, "nothing in the cell is true")
        return None

    def ask(self, condition: Program) -> bool:
        """What a condition says."""
        answer = self.answers.is_true(condition, self.index)
        self.questions.append((condition, answer))
        return answer

    def explain(self, tried: tuple[Outcome, ...], because: str) -> None:
        """Keeps, for the verdict, what the conditions of the outcomes tried have seen."""
        conditions = [one.condition for one in tried if one.condition is not None]
        self.asked = self.answers.asked(conditions, self.index) if conditions else ()
        self.because = because or ("since nothing before it is true" if conditions else "")

    def draw(self, event: int, several: tuple[Outcome, ...]) -> Outcome:
        """One of several by weight."""
        total = sum(one.weight or 0.0 for one in several)
        place = total * chance(self.key, self.tick, self.layer, event, self.draws)
        self.draws += 1
        self.personal = True
        chosen = several[-1]
        for one in several:
            place -= one.weight or 0.0
            if place < 0:
                chosen = one
                break
        self.because = f"drawn, {chosen.weight:g} of {total:g}"
        return chosen

    def take(self, event: int, one: Outcome, reason: str, other: int = -1, silent: bool = False) -> bool:
        """The cell fires; whether a motion has started. `silent`: the same stay as in the tick before."""
        target = one.target if one.resume < 0 or self.last[one.resume] < 0 else self.last[one.resume]
        starts = target != self.state or one.restart
        arrives = "arrived, the journey is over" if target == self.goal and self.layer == 0 else ""
        if not silent:
            said = "; ".join(filter(None, (reason, self.because, arrives)))
            self.verdict(event, "taken", said or ("" if starts else "stays"), target if starts else -1, other)
            if one.action >= 0:
                action = self.machine.actions[one.action]
                self.record.actions.append(Action(self.tick, self.actor, action.name, action.arguments, other, self.layer))
        if starts:
            self.change(event, target, one)
        return starts

    def change(self, event: int, target: int, one: Outcome) -> None:
        """Rule 5: END and markers of the old motion are cleared, and the new motion starts in this tick."""
        here = self.state
        start = self.start_of(target, one)
        self.changes += 1
        self.carried = self.ending
        self.state, self.ended, self.at_end, self.crossed, self.wraps = target, RUNNING, False, (), 0
        self.time, self.passed = start, start + BEGINNING
        self.record.changes.append(
            Change(self.actor, self.layer, here, target, event, one.action, one.blend, target == here, self.time, one.curve)
        )
        if target != here:
            self.entered = True
            self.remember(here, target)
            self.leave(here)

    def start_of(self, target: int, one: Outcome) -> float:
        """Seconds into the new motion at which it is entered; the end of a loop is its beginning."""
        machine, duration = self.machine, float(self.machine.duration[target])
        if one.enter == 0 or not math.isfinite(duration):
            return 0.0
        start = (self.matched(target) if one.enter == MATCH else one.enter) * duration
        return math.fmod(start, duration) if machine.loop[target] and duration > 0 else start

    def matched(self, target: int) -> float:
        """The phase of a motion that goes with that of the present one."""
        machine = self.machine
        self.personal = True
        whole = float(machine.duration[self.state])
        phase = self.time / whole if whole > 0 else 0.0
        loop = bool(machine.loop[self.state] and machine.loop[target])
        return float(match(machine.markers[self.state], machine.markers[target], phase, loop))

    def remember(self, old: int, new: int) -> None:
        """Outer states that are left keep in mind from where."""
        for history, (was, is_now) in enumerate(zip(self.machine.inside[old], self.machine.inside[new], strict=True)):
            if was and not is_now:
                self.last[history] = old
