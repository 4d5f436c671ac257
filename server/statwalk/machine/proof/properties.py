"""Sentences about a table: `A only after B`, `never A -> B`, `A leads to B within T`, `from A, EVENT reaches B within T`.

A and B are states of the base, or outer ones, which stand for all that is within them.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from functools import cached_property

from statwalk.machine.authored.definition import END, MachineDefinition, PropertyDefinition, nearest
from statwalk.machine.authored.expand import enclosing
from statwalk.machine.checking.findings import Finding, Severity
from statwalk.machine.checking.firing import Motions
from statwalk.machine.checking.reach import Graph, reached, way
from statwalk.machine.proof.lengths import TICKS_PER_SECOND
from statwalk.machine.proof.moments import NOBODY
from statwalk.machine.proof.timed import Question, Timed, timed

ONLY_AFTER = re.compile(r"(?P<first>\S+) only after (?P<second>\S+)")
NEVER = re.compile(r"never (?P<first>\S+) -> (?P<second>\S+)")
WITHIN = r"within (?P<count>[0-9]{1,6}(?:\.[0-9]{1,6})?) ?(?P<unit>s|ms)"
LEADS = re.compile(rf"(?P<first>\S+) leads to (?P<second>\S+) {WITHIN}")
REACHES = re.compile(rf"from (?P<first>[^\s,]+),? (?P<event>\S+) reaches (?P<second>\S+) {WITHIN}")
FORMS = "`A only after B`, `never A -> B`, `A leads to B within 2 s` or `from A, EVENT reaches B within 2 s`"
States = Collection[str]
MOST_PROPERTIES = 256


def answers(definition: MachineDefinition, graph: Graph, motions: Motions) -> list[Finding]:
    """The answers to all properties of a machine; `graph` is that of its base."""
    asked = Asked(definition, graph, motions)
    found = [asked.answer(said) for said in definition.properties[:MOST_PROPERTIES]]
    rest = definition.properties[MOST_PROPERTIES:]
    return found + [finding(said, "warning", f"undecided: only the first {MOST_PROPERTIES} are looked at") for said in rest]


class Asked:
    """A machine whose properties are asked for."""

    def __init__(self, definition: MachineDefinition, graph: Graph, motions: Motions) -> None:
        self.definition, self.graph, self.motions = definition, graph, motions

    @cached_property
    def timed(self) -> Timed | str:
        """What answers those with a time."""
        return timed(self.definition, self.motions)

    def answer(self, said: PropertyDefinition) -> Finding:
        """proved, refuted (with a shortest counterexample) or undecided (with the reason)."""
        text = said.text.strip()
        match = next((match for form in (ONLY_AFTER, NEVER, LEADS, REACHES) if (match := form.fullmatch(text))), None)
        if match is None:
            return finding(said, "error", f"undecided: a property reads {FORMS}")
        unknown = self.unknown(match)
        if unknown:
            return finding(said, "error", f"undecided: {unknown}")
        if match.re in (LEADS, REACHES):
            return self.within(said, match)
        first, second = self.states_of(match["first"]), self.states_of(match["second"])
        counterexample = (only_after if match.re is ONLY_AFTER else never)(self.definition.initial, self.graph, first, second)
        return finding(said, "error", f"refuted: {counterexample}") if counterexample else finding(said, "info", "proved")

    def unknown(self, match: re.Match[str]) -> str:
        """Which name of a property does not exist; empty where all do."""
        states = (*self.definition.states, *self.definition.outers)
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
        """The state of that name, or all that are within the outer state of that name."""
        inner = tuple(state for state in self.definition.states if name in enclosing(self.definition, state))
        return inner or (name,)

    def within(self, said: PropertyDefinition, match: re.Match[str]) -> Finding:
        """The answer to a property with a time."""
        if isinstance(self.timed, str):
            return finding(said, "warning", self.timed)
        machine = self.timed.machine
        first, second = (tuple(machine.states.index(one) for one in self.states_of(match[name])) for name in ("first", "second"))
        event = machine.columns[match["event"]] if match.re is REACHES else NOBODY
        ticks = float(match["count"]) * (TICKS_PER_SECOND if match["unit"] == "s" else TICKS_PER_SECOND / 1000)
        answer = self.timed.answer(Question(first, second, event, int(ticks + 1e-6)))
        if isinstance(answer, str):
            return finding(said, "info" if answer.startswith("proved") else "warning", answer)
        return finding(said, "error", answer.message, answer.replay)


def finding(said: PropertyDefinition, severity: Severity, message: str, replay: tuple[tuple[int, str], ...] = ()) -> Finding:
    """The answer to a property."""
    return Finding("property", severity, f"{said.text}: {message}", said.line, replay=replay)


def only_after(initial: str, graph: Graph, goals: States, gates: States) -> str:
    """A way to a goal that never was in a gate; empty where the gates dominate the goals (lie on all ways), or there is no way."""
    shut = [gate for gate in gates if gate not in goals]
    return "" if len(shut) < len(gates) else way(reached(graph, initial, without=shut), goals)


def never(initial: str, graph: Graph, here: States, there: States) -> str:
    """A way to `here` and on to `there` in one step; empty where there is none."""
    before = reached(graph, initial)
    for state in (one for one in before if one in here):
        for event, targets in graph[state].items():
            target = next((one for one in targets if one in there), None)
            if target is not None:
                return f"{way(before, (state,))} -{event}-> {target}"
    return ""
