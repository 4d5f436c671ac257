"""Single changes that may make an event fire: proposed here from the table and the conditions, tried elsewhere."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from statwalk.machine import travel
from statwalk.machine.authored.definition import END
from statwalk.machine.built.runform import Machine
from statwalk.machine.built.runparts import BLANK, MIXED, NOW
from statwalk.machine.conditions.program import Program
from statwalk.machine.ticking.asking import Answers
from statwalk.machine.ticking.smoothing import smooth
from statwalk.maths.arrays import Bools, Floats
from statwalk.stage.cast import Cast
from statwalk.stage.explaining.cells import cells_of
from statwalk.stage.explaining.moments import moments
from statwalk.stage.explaining.thresholds import nearest_true
from statwalk.stage.explaining.trying import Change
from statwalk.stage.frame import Verdict
from statwalk.stage.moving.surroundings import surroundings
from statwalk.stage.stage import Stage

MOST_STATES = 2
RELEASE, SET, MOMENT, HOLD, STATE, BUFFER, CELL = 0.5, 1.0, 1.0, 1.2, 2.0, 3.0, 4.0
"""what a remedy costs, in seconds of waiting: what a player can do at once is cheaper than what an author has to change"""


class Candidate(NamedTuple):
    """A change that may help."""

    cost: float
    change: Change


@dataclass(frozen=True)
class Question:
    """Why did `event` not fire in `tick`? `cast`, `row`: the actor in the tick before; `verdict`: what became, or would have, of it."""

    stage: Stage
    actor: int
    event: str
    tick: int
    cast: Cast
    row: int
    verdict: Verdict

    @property
    def machine(self) -> Machine:
        """The actor's."""
        return self.cast.role.machine

    @cached_property
    def place(self) -> tuple[int, int]:
        """State and event, as rows of the table, where the event was looked up."""
        rows = self.machine.rows(self.verdict.layer)
        here = next(row for row in rows if self.machine.states[row] == self.verdict.from_state)
        return here, self.machine.events.index(self.event)


def candidates(question: Question) -> Iterator[Candidate]:
    """All changes that are worth a trial."""
    later: int | None = None
    for tick in moments(question.stage, question.actor, question.event, question.tick):
        seconds = abs(tick - question.tick) / question.stage.rate
        yield Candidate(MOMENT + seconds, {"kind": "moment", "tick": tick})
        later = tick if tick > question.tick else later
    yield from _cell(question)
    if question.event == END:
        return
    if question.cast.machine.held[question.row, question.place[1]]:
        yield Candidate(RELEASE, {"kind": "release", "event": question.event})
    if later is not None:
        seconds = (later - question.tick + 1) / question.stage.rate
        yield Candidate(HOLD + seconds, {"kind": "hold", "event": question.event})
        if question.machine.target[question.place] in (BLANK, MIXED):
            yield Candidate(BUFFER + seconds, {"kind": "buffer", "event": question.event, "seconds": round(seconds, 3)})
    yield from _values(question)
    yield from sensed(question)
    yield from _elsewhere(question)


def _values(question: Question) -> Iterator[Candidate]:
    """Parameters at which a condition of the cell is true, each alone."""
    for one in question.machine.outcomes.get(question.place, ()):
        if one.condition is not None:
            yield from _by_parameters(question, one.condition, dict(question.verdict.values))


def sensed(question: Question) -> Iterator[Candidate]:
    """Parameters at which a sense raises the event, each alone."""
    for one in question.machine.senses:
        if one.event == question.place[1]:
            yield from _by_parameters(question, one.when, _measured(question))


def sense_of(question: Question) -> str:
    """Why the sense or the touch that raises the event has not done so; empty where none raises it."""
    for touch in question.machine.touches:
        if touch.event == question.place[1]:
            return f"no {touch.other} {TOUCHED[touch.on]} its {touch.own} in the tick before"
    for row, one in enumerate(question.machine.senses):
        if one.event == question.place[1]:
            seen = _measured(question)
            values = ", ".join(f"{name} {seen[name]:g}" for name in one.when.variables)
            is_on = question.cast.machine.sensing[question.row, row]
            return f"{one.said} has been sensed already, and was not released" if is_on else f"{one.said} is not true: {values}"
    return ""


def _by_parameters(question: Question, condition: Program, seen: Mapping[str, float]) -> Iterator[Candidate]:
    """The parameters that a condition asks for, each alone at a value at which it is true."""
    names = [one.name for one in question.machine.parameters]
    for name in condition.variables:
        if name in names and name in seen:
            yield from _value(question, condition, names.index(name), seen)


def _measured(question: Question) -> dict[str, float]:
    """All that conditions may ask for, as senses see it in the tick in question."""
    dt = 1 / question.stage.rate
    state = smooth(question.machine, question.cast.machine, dt)
    measured = surroundings(question.cast, dt, question.stage.seed).measured
    answers = Answers(question.machine, state, measured, dt, 0, np.array([question.row]))
    return dict(zip(question.machine.variables, answers.values[:, 0].tolist(), strict=True))


def _value(question: Question, condition: Program, number: int, seen: Mapping[str, float]) -> Iterator[Candidate]:
    """The value of one parameter nearest to the present one at which the condition is true."""
    one, variables = question.machine.parameters[number], question.machine.variables
    values = np.array([seen.get(name, 0.0) for name in variables])

    def is_true(tried: Floats) -> Bools:
        rows = np.repeat(values[:, None], len(tried), 1)
        rows[number] = tried
        return np.asarray(condition.evaluate(rows) != 0)

    value = nearest_true(is_true, seen[one.name], one.minimum, one.maximum)
    if value is not None and value != seen[one.name]:
        early = question.tick - (int(np.ceil(one.smooth * question.stage.rate)) + 1 if one.smooth else 0)
        share = min(abs(value - seen[one.name]) / (one.maximum - one.minimum), 1.0)
        yield Candidate(SET + share, {"kind": "set", "parameter": one.name, "value": value, "tick": max(early, 1)})


def _elsewhere(question: Question) -> Iterator[Candidate]:
    """States of the base in which the event fires at once, and that can be reached."""
    machine, (here, column) = question.machine, question.place
    if question.verdict.layer:
        return
    plans = [
        (plan.seconds, row, plan)
        for row in machine.rows(0)
        if row != here and (machine.target[row, column] >= 0 or machine.target[row, column] == MIXED) and machine.when[row, column] == NOW
        if (plan := travel.plan(machine, here, row)) is not None
    ]
    for seconds, row, plan in sorted(plans, key=lambda one: one[:2])[:MOST_STATES]:
        steps = [step._asdict() for step in plan.steps]
        yield Candidate(STATE + seconds, {"kind": "state", "state": machine.states[row], "steps": steps})


def _cell(question: Question) -> Iterator[Candidate]:
    """A cell that fires at once."""
    role, verdict = question.cast.role, question.verdict
    cells = cells_of(role)
    states = [question.machine.states[row] for row in question.machine.rows(verdict.layer)]
    known = Counter(
        choice.to
        for (layer, _, event), cell in cells.items()
        if (layer, event) == (verdict.layer, question.event)
        for choice in cell.choices
    )
    cell = cells.get((verdict.layer, verdict.from_state, question.event))
    written = [choice.to for choice in cell.alternatives] + [cell.to] if cell else []
    guessed = [near for name in written for near in get_close_matches(name, states, n=1)]
    for to in (*guessed, *(name for name, _ in known.most_common()), question.machine.states[question.machine.initials[verdict.layer]]):
        if to in states:
            restart = to == verdict.from_state
            place = {"layer": verdict.layer, "state": verdict.from_state, "event": question.event}
            yield Candidate(CELL, {"kind": "cell", **place, "to": to, "restart": restart, "text": f"{to}{'!' if restart else ''}"})
            return


def text_of(question: Question, change: Change, fires: int) -> str:
    """A remedy in words."""
    words: dict[str, Any] = {**change, "tick": change.get("tick", question.tick), "fires": fires, "name": question.event}
    seconds = (fires - question.tick) / question.stage.rate
    words["when"] = f"{abs(seconds):.2f} s {'later' if seconds > 0 else 'earlier'}"
    words["now"] = dict(question.verdict.values).get(change.get("parameter", ""), 0.0)
    words["way"] = ", ".join("wait for the end" if one["event"] == END else one["event"] for one in change.get("steps", ()))
    return WORDS[change["kind"]].format(**words)


TOUCHED = {"enter": "came to touch", "stay": "went on touching", "leave": "ceased to touch"}
WORDS = {
    "send": "send {name} in tick {tick}",
    "release": "release {name} first, which is held",
    "set": "{parameter} at {value:g}, not at {now:g}",
    "moment": "{name} in tick {fires}, {when}",
    "hold": "hold {name} down: it fires in tick {fires}, {when}",
    "state": "in {state}, by way of: {way}; {name} then fires in tick {fires}",
    "buffer": "let {name} wait for {seconds:g} s: it fires in tick {fires}, {when}",
    "cell": "{state}/{event}: {text}",
}
