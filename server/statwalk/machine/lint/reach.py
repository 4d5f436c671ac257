"""The graph of a table: the states that can follow each other through cells that can fire."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection, Iterable, Mapping

from statwalk.machine.compile.resolve_defaults import Cell, landings
from statwalk.machine.compile.resolved_table import Markers
from statwalk.machine.definition.machine_definition import END, MachineDefinition
from statwalk.machine.lint.firing import certain, possible, why_never

Cells = Mapping[tuple[str, str], Cell]
"""(state, event) -> the cell that counts"""
Graph = Mapping[str, Mapping[str, tuple[str, ...]]]
"""state -> event -> the states that it may lead to, itself included; only for cells that can fire"""


def graph_of(definition: MachineDefinition, cells: Cells, markers: Markers) -> Graph:
    """Returns the graph of a table.

    Conditions, senses and weights are free, and events come at any time.
    """
    graph: dict[str, dict[str, tuple[str, ...]]] = {state: {} for state in definition.states}
    for (state, event), cell in cells.items():
        if not why_never(definition, cell, state, event, markers):
            targets = tuple(
                dict.fromkeys(target for choice in possible(cell) for target in landings(definition, choice))
            )
            if targets:
                graph[state][event] = targets
    return graph


def reached(graph: Graph, start: str, without: Iterable[str] = ()) -> dict[str, tuple[str, str] | None]:
    """Returns the states that can be reached from `start` (itself included), each with the (state, event)
    before it on a shortest path.
    """
    excluded = set(without)
    if start in excluded:
        return {}
    before: dict[str, tuple[str, str] | None] = {start: None}
    queue = deque([start])
    while queue:
        state = queue.popleft()
        for event, targets in graph[state].items():
            for target in targets:
                if target not in before and target not in excluded:
                    before[target] = (state, event)
                    queue.append(target)
    return before


def way(before: Mapping[str, tuple[str, str] | None], goals: Collection[str]) -> str:
    """Returns a shortest path as text, `STAT -LEFT-> TLFT`, to the first of some goals that can be reached;
    empty if none can.
    """
    state = next((goal for goal in before if goal in goals), None)
    if state is None:
        return ""
    steps: list[str] = []
    while (last := before[state]) is not None:
        steps.append(f" -{last[1]}-> {state}")
        state = last[0]
    return state + "".join(reversed(steps))


def cycle(edges: Mapping[str, str]) -> list[str]:
    """Returns a cycle of a graph in which each state has at most one successor; empty if it has no cycle."""
    done: set[str] = set()
    for start in edges:
        path: list[str] = []
        state: str | None = start
        while state is not None and state not in done and state not in path:
            path.append(state)
            state = edges.get(state)
        if state in path:
            return path[path.index(state) :]
        done |= set(path)
    return []


def by_end(definition: MachineDefinition, cells: Cells) -> dict[str, str]:
    """Returns the state that certainly follows each state when its motion ends without any input; the idle
    event counts if END is blank.
    """
    cells_at_end = {
        state: cells.get((state, END)) or cells.get((state, definition.idle or END))
        for state in definition.states
    }
    sure = {state: certain(cell) for state, cell in cells_at_end.items() if cell}
    return {state: choice.to for state, choice in sure.items() if choice and choice.to in definition.states}
