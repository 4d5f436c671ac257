"""Sentences about a table: `A only after B`, `never A -> B`, `A leads to B within T`, `from A, EVENT reaches
B within T`.

A and B are states of the base, or composite ones, which stand for all that is within them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from functools import cached_property

from statwalk.machine.compile.compile_machine import build
from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.resolve_defaults import enclosing
from statwalk.machine.compile.resolved_table import Motions, ResolvedTable
from statwalk.machine.definition.machine_definition import END, MachineDefinition, PropertyDefinition, nearest
from statwalk.machine.lint.findings import Finding, Severity
from statwalk.machine.lint.reach import Graph, reached, way
from statwalk.machine.model_checker.counterexample import Refuted
from statwalk.machine.model_checker.lengths import TICKS_PER_SECOND
from statwalk.machine.model_checker.played import Play
from statwalk.machine.model_checker.search_at_pace import TimedQuestion
from statwalk.machine.model_checker.state_space import NOTHING
from statwalk.machine.model_checker.timed import Timed, timed
from statwalk.machine.model_checker.work import Checkpoint, Work

ONLY_AFTER = re.compile(r"(?P<first>\S+) only after (?P<second>\S+)")
NEVER = re.compile(r"never (?P<first>\S+) -> (?P<second>\S+)")
WITHIN = r"within (?P<count>[0-9]{1,6}(?:\.[0-9]{1,6})?) ?(?P<unit>s|ms)"
LEADS = re.compile(rf"(?P<first>\S+) leads to (?P<second>\S+) {WITHIN}")
REACHES = re.compile(rf"from (?P<first>[^\s,]+),? (?P<event>\S+) reaches (?P<second>\S+) {WITHIN}")
FORMS = "`A only after B`, `never A -> B`, `A leads to B within 2 s` or `from A, EVENT reaches B within 2 s`"
States = Collection[str]
MOST_PROPERTIES = 256


def answers(
    definition: MachineDefinition,
    graph: Graph,
    motions: Motions,
    tables: Sequence[ResolvedTable],
    machine: Machine | None,
    checkpoint: Checkpoint,
    play: Play | None,
) -> list[Finding]:
    """Returns the answers to all properties of a machine.

    `graph` is that of its base; `machine` where it was compiled before; `checkpoint` is called for each
    property and between searches; `play` plays what refutes them on a stage.
    """
    checker = PropertyChecker(
        definition,
        graph,
        lambda: machine or build(definition, motions or {}, tables),
        motions,
        Work(checkpoint=checkpoint),
        play,
    )
    found = [checker.answer(question) for question in definition.properties[:MOST_PROPERTIES]]
    rest = definition.properties[MOST_PROPERTIES:]
    return found + [
        _finding(question, "warning", f"undecided: only the first {MOST_PROPERTIES} are looked at")
        for question in rest
    ]


class PropertyChecker:
    """A machine whose properties are asked for."""

    def __init__(
        self,
        definition: MachineDefinition,
        graph: Graph,
        compiled: Callable[[], Machine],
        motions: Motions,
        work: Work,
        play: Play | None,
    ) -> None:
        self.definition, self.graph, self.compiled, self.motions = definition, graph, compiled, motions
        self.work, self.play = work, play

    @cached_property
    def timed(self) -> Timed | str:
        """Answers the properties that name a time."""
        return timed(self.compiled, self.motions, self.work, self.play)

    def answer(self, question: PropertyDefinition) -> Finding:
        """proved, refuted (with a shortest counterexample), undecided or not understood (with the reason)."""
        self.work.checkpoint()
        text = question.text.strip()
        match = next(
            (match for form in (ONLY_AFTER, NEVER, LEADS, REACHES) if (match := form.fullmatch(text))), None
        )
        if match is None:
            return _finding(question, "error", f"not understood: a property reads {FORMS}")
        unknown = self.unknown(match)
        if unknown:
            return _finding(question, "error", f"not understood: {unknown}")
        if match.re in (LEADS, REACHES):
            return self.within(question, match)
        first, second = self.states_of(match["first"]), self.states_of(match["second"])
        way = (_only_after if match.re is ONLY_AFTER else _never)(
            self.definition.initial, self.graph, first, second
        )
        return self._untimed(question, match, way) if way else _finding(question, "info", "proved")

    def unknown(self, match: re.Match[str]) -> str:
        """Which name of a property does not exist; empty where all do."""
        states = (*self.definition.states, *self.definition.composites)
        for name in (match["first"], match["second"]):
            if name not in states:
                return f"no state is called {name!r}{nearest(name, states)}"
        event = match.groupdict().get("event")
        if event == END:
            return "END comes from the motion; the event of a property is one that comes from outside"
        if event is not None and event not in self.definition.events:
            return f"no event is called {event!r}{nearest(event, self.definition.events)}"
        return ""

    def states_of(self, name: str) -> tuple[str, ...]:
        """Returns the state called `name`, or all inner states of the composite state called `name`."""
        inner = tuple(state for state in self.definition.states if name in enclosing(self.definition, state))
        return inner or (name,)

    def _untimed(self, question: PropertyDefinition, match: re.Match[str], way: str) -> Finding:
        """The answer where the graph refutes a property by a `way`: a run of the actor, if the motions leave
        time for one.
        """
        if isinstance(self.timed, str):
            return _finding(question, "error", f"refuted: {way}")
        first, second = (self.rows(match[name]) for name in ("first", "second"))
        answer = (self.timed.only_after if match.re is ONLY_AFTER else self.timed.never)(first, second)
        return _answered(question, answer)

    def rows(self, name: str) -> tuple[int, ...]:
        """The rows of the states of that name."""
        assert not isinstance(self.timed, str)
        return tuple(self.timed.machine.states.index(one) for one in self.states_of(name))

    def within(self, question: PropertyDefinition, match: re.Match[str]) -> Finding:
        """The answer to a property with a time."""
        if isinstance(self.timed, str):
            return _finding(question, "warning", self.timed)
        machine = self.timed.machine
        first, second = (self.rows(match[name]) for name in ("first", "second"))
        event = machine.columns[match["event"]] if match.re is REACHES else NOTHING
        ticks = float(match["count"]) * (
            TICKS_PER_SECOND if match["unit"] == "s" else TICKS_PER_SECOND / 1000
        )
        answer = self.timed.answer(TimedQuestion(first, second, event, int(ticks + 1e-6)))
        return _answered(question, answer)


def _answered(question: PropertyDefinition, answer: str | Refuted) -> Finding:
    if isinstance(answer, str):
        return _finding(question, "info" if answer.startswith("proved") else "warning", answer)
    found = _finding(question, "error", answer.message)
    return replace(found, replay=answer.replay, ticks=answer.ticks)


def _finding(question: PropertyDefinition, severity: Severity, message: str) -> Finding:
    """The answer to a property."""
    return Finding("property", severity, f"{question.text}: {message}", question.line)


def _only_after(initial: str, graph: Graph, goals: States, gates: States) -> str:
    """A way to a goal that never was in a gate; empty where the gates dominate the goals (lie on all ways),
    or there is no way.
    """
    shut = [gate for gate in gates if gate not in goals]
    return "" if len(shut) < len(gates) else way(reached(graph, initial, without=shut), goals)


def _never(initial: str, graph: Graph, here: States, there: States) -> str:
    """A way to `here` and on to `there` in one step; empty where there is none."""
    before = reached(graph, initial)
    for state in (one for one in before if one in here):
        for event, targets in graph[state].items():
            target = next((one for one in targets if one in there), None)
            if target is not None:
                return f"{way(before, (state,))} -{event}-> {target}"
    return ""
