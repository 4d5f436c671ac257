"""Candidates for remedies, single changes that may make an event fire: proposed from the table and the
conditions, tried in `whynot`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property
from typing import NamedTuple

import numpy as np

from statwalk.machine import travel
from statwalk.machine.compile.alternatives import BLANK, MIXED, NOW
from statwalk.machine.compile.machine import Machine
from statwalk.machine.definition.machine_definition import END
from statwalk.machine.runtime.seen import seen as seen_by
from statwalk.maths.arrays import Bools, Floats
from statwalk.maths.formula.postfix import Formula
from statwalk.stage.effects.authored_cells import cells_of
from statwalk.stage.explain.counterfactual import Budget, Change
from statwalk.stage.explain.other_ticks import moments
from statwalk.stage.explain.past_states import PastStates
from statwalk.stage.explain.thresholds import nearest_true
from statwalk.stage.stage import Stage
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.frame import Verdict
from statwalk.stage.steps.measurements import surroundings
from statwalk.stage.steps.memory import Memory

MOST_STATES = 2
RELEASE, SET, MOMENT, HOLD, STATE, BUFFER, CELL = 0.5, 1.0, 1.0, 1.2, 2.0, 3.0, 4.0
"""cost of a remedy, in seconds of waiting: a change that a player can make at once is cheaper than a change
that an author has to make
"""


TOUCHED = {"enter": "came to touch", "stay": "went on touching", "leave": "ceased to touch"}


class Candidate(NamedTuple):
    """A change that may help; `ticks`: for how many ticks the event must be watched, as far as this
    is known.
    """

    cost: float
    change: Change
    ticks: int = 0


@dataclass(frozen=True)
class Question:
    """Why did `event` not fire in the tick that `past` leads to?

    `cast`, `row`: the actor in the tick before; `verdict`: the verdict on the event, or the verdict it would
    have got.
    """

    past: PastStates
    event: str
    cast: Cast
    row: int
    verdict: Verdict

    @property
    def stage(self) -> Stage:
        """The stage of the question."""
        return self.past.stage

    @property
    def tick(self) -> int:
        """The tick of the question."""
        return self.past.tick

    @property
    def machine(self) -> Machine:
        """The actor's machine."""
        return self.cast.role.machine

    @cached_property
    def place(self) -> tuple[int, int]:
        """State and event, as rows of the table, of the cell in which the event was looked up."""
        rows = self.machine.rows(self.verdict.layer)
        state = next(row for row in rows if self.machine.states[row] == self.verdict.from_state)
        return state, self.machine.events.index(self.event)


def candidates(question: Question, budget: Budget) -> Iterator[Candidate]:
    """Yields all changes that are worth a trial."""
    later: int | None = None
    for tick in moments(question.past, question.event, budget):
        seconds = abs(tick - question.tick) / question.stage.rate
        yield Candidate(MOMENT + seconds, {"kind": "moment", "tick": tick})
        later = tick if tick > question.tick else later
    yield from _cell(question)
    if question.event == END:
        return
    if question.cast.machine.held[question.row, question.place[1]]:
        yield Candidate(RELEASE, {"kind": "release", "event": question.event})
    if later is not None:
        ticks = later - question.tick + 1
        seconds = ticks / question.stage.rate
        yield Candidate(HOLD + seconds, {"kind": "hold", "event": question.event}, ticks)
        if question.machine.target[question.place] in (BLANK, MIXED):
            change = {"kind": "buffer", "event": question.event, "seconds": round(seconds, 3)}
            yield Candidate(BUFFER + seconds, change, ticks)
    yield from _values(question)
    yield from sensed(question)
    yield from _elsewhere(question)


def _values(question: Question) -> Iterator[Candidate]:
    """Parameters at which a condition of the cell is true, each changed alone."""
    for alternative in question.machine.alternatives.get(question.place, ()):
        if alternative.condition is not None:
            yield from _by_parameters(question, alternative.condition, dict(question.verdict.values))


def sensed(question: Question) -> Iterator[Candidate]:
    """Yields values of parameters at which a sense raises the event, each changed alone."""
    for sense in question.machine.senses:
        if sense.event == question.place[1]:
            yield from _by_parameters(question, sense.when, _measured(question))


def sense_of(question: Question) -> str:
    """Returns why the sense or the touch that raises the event did not raise it; empty if none raises it."""
    for touch in question.machine.touches:
        if touch.event == question.place[1]:
            return f"no {touch.other} {TOUCHED[touch.on]} its {touch.own} in the tick before"
    for row, sense in enumerate(question.machine.senses):
        if sense.event == question.place[1]:
            measured = _measured(question)
            values = ", ".join(f"{name} {measured[name]:g}" for name in sense.when.variables)
            is_on = question.cast.machine.sensing[question.row, row]
            return (
                f"{sense.when.text} has been sensed already, and was not released"
                if is_on
                else f"{sense.when.text} is not true: {values}"
            )
    return ""


def _by_parameters(question: Question, condition: Formula, seen: Mapping[str, float]) -> Iterator[Candidate]:
    """The parameters that a condition reads, each alone at a value at which the condition is true."""
    names = [parameter.name for parameter in question.machine.parameters]
    for name in condition.variables:
        if name in names and name in seen:
            yield from _value(question, condition, names.index(name), seen)


def _measured(question: Question) -> dict[str, float]:
    """All variables of conditions, as senses read them in the tick of the question."""
    dt = 1 / question.stage.rate
    around = surroundings(
        question.cast, Memory(question.cast.role, len(question.cast.ids)), dt, question.stage.seed
    )
    values = seen_by(question.machine.program, question.cast.machine, around.values, dt, question.row)
    return dict(zip(question.machine.variables, values.tolist(), strict=True))


def _value(
    question: Question, condition: Formula, number: int, seen: Mapping[str, float]
) -> Iterator[Candidate]:
    """The value of one parameter nearest to the present value at which the condition is true."""
    parameter, variables = question.machine.parameters[number], question.machine.variables
    values = np.array([seen.get(name, 0.0) for name in variables])

    def is_true(tried: Floats) -> Bools:
        rows = np.repeat(values[:, None], len(tried), 1)
        rows[number] = tried
        return np.asarray(condition.evaluate(rows) != 0)

    value = nearest_true(is_true, seen[parameter.name], parameter.minimum, parameter.maximum)
    if value is not None and value != seen[parameter.name]:
        early = question.tick - (
            int(np.ceil(parameter.smooth * question.stage.rate)) + 1 if parameter.smooth else 0
        )
        share = min(abs(value - seen[parameter.name]) / (parameter.maximum - parameter.minimum), 1.0)
        yield Candidate(
            SET + share, {"kind": "set", "parameter": parameter.name, "value": value, "tick": max(early, 1)}
        )


def _elsewhere(question: Question) -> Iterator[Candidate]:
    """Reachable states of the base layer in which the event fires at once."""
    machine, (state, column) = question.machine, question.place
    if question.verdict.layer:
        return
    plans = [
        (plan.seconds, row, plan)
        for row in machine.rows(0)
        if row != state
        and (machine.target[row, column] >= 0 or machine.target[row, column] == MIXED)
        and machine.when[row, column] == NOW
        if (plan := travel.plan(machine, state, row)) is not None
    ]
    for seconds, row, plan in sorted(plans, key=lambda ranked: ranked[:2])[:MOST_STATES]:
        steps = [step._asdict() for step in plan.steps]
        change = {"kind": "state", "state": machine.states[row], "steps": steps}
        yield Candidate(STATE + seconds, change, int(seconds * question.stage.rate))


def _cell(question: Question) -> Iterator[Candidate]:
    """A cell that fires at once."""
    role, verdict = question.cast.role, question.verdict
    cells = cells_of(role)
    states = [question.machine.states[row] for row in question.machine.rows(verdict.layer)]
    counts = Counter(
        choice.to
        for (layer, _, event), cell in cells.items()
        if (layer, event) == (verdict.layer, question.event)
        for choice in cell.choices
    )
    cell = cells.get((verdict.layer, verdict.from_state, question.event))
    written = [choice.to for choice in cell.alternatives] + [cell.to] if cell else []
    guessed = [near for name in written for near in get_close_matches(name, states, n=1)]
    for to in (
        *guessed,
        *(name for name, _ in counts.most_common()),
        question.machine.states[question.machine.initials[verdict.layer]],
    ):
        if to in states:
            restart = to == verdict.from_state
            place = {"layer": verdict.layer, "state": verdict.from_state, "event": question.event}
            yield Candidate(
                CELL,
                {
                    "kind": "cell",
                    **place,
                    "to": to,
                    "restart": restart,
                    "text": f"{to}{'!' if restart else ''}",
                },
            )
            return
