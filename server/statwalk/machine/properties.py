"""Sentences about a table, proved or refuted on its graph: `A only after B`, `never A -> B`."""

from __future__ import annotations

import re

from statwalk.machine.definition import MachineDefinition, PropertyDefinition, nearest
from statwalk.machine.findings import Finding, Severity
from statwalk.machine.reach import Graph, reached, way

ONLY_AFTER = re.compile(r"(\S+) only after (\S+)")
NEVER = re.compile(r"never (\S+) -> (\S+)")
NOT_YET = re.compile(r"\S+ leads to \S+ within .+|from \S+,? \S+ reaches \S+ within .+")


def answer(definition: MachineDefinition, graph: Graph, said: PropertyDefinition) -> Finding:
    """proved, refuted (with a shortest counterexample) or undecided (with the reason)."""
    for form, prove in ((ONLY_AFTER, only_after), (NEVER, never)):
        match = form.fullmatch(said.text.strip())
        if match:
            first, second = match[1], match[2]
            unknown = next((name for name in (first, second) if name not in definition.states), None)
            if unknown is not None:
                hint = nearest(unknown, tuple(definition.states))
                return finding(said, "error", f"undecided: no state is called {unknown!r}{hint}")
            counterexample = prove(definition.initial, graph, first, second)
            return finding(said, "error", f"refuted: {counterexample}") if counterexample else finding(said, "info", "proved")
    if NOT_YET.fullmatch(said.text.strip()):
        return finding(said, "warning", "undecided: properties with a time are not supported yet")
    return finding(said, "error", "undecided: a property reads `A only after B` or `never A -> B`")


def finding(said: PropertyDefinition, severity: Severity, message: str) -> Finding:
    """The answer to a property."""
    return Finding("property", severity, f"{said.text}: {message}", said.line)


def only_after(initial: str, graph: Graph, goal: str, gate: str) -> str:
    """A way to `goal` that never was in `gate`; empty where `gate` dominates `goal` (lies on all ways), or there is no way."""
    before = reached(graph, initial, without=(gate,) if gate != goal else ())
    return way(before, goal) if goal in before and gate != goal else ""


def never(initial: str, graph: Graph, here: str, there: str) -> str:
    """A way to `here` and on to `there` in one step; empty where there is none."""
    before = reached(graph, initial)
    event = next((event for event, target in graph[here].items() if target == there), None)
    return f"{way(before, here)} -{event}-> {there}" if event and here in before else ""
