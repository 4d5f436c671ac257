"""The graph of a table: which states can follow which, by cells that can fire."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection, Iterable, Mapping

from statwalk.machine.authored.definition import END, MachineDefinition
from statwalk.machine.authored.expand import Cell, landings
from statwalk.machine.checking.firing import Marks, certain, possible, why_never

Cells = Mapping[tuple[str, str], Cell]
"""(state, event) -> the cell that counts"""
Graph = Mapping[str, Mapping[str, tuple[str, ...]]]
"""state -> event -> the states that it may lead to; only cells that can fire, stays among them"""


def graph_of(definition: MachineDefinition, cells: Cells, marks: Marks) -> Graph:
    """All that can happen in each state of a table. Conditions, senses and weights are free, and events come at any time."""
    found: dict[str, dict[str, tuple[str, ...]]] = {state: {} for state in definition.states}
    for (state, event), cell in cells.items():
        if not why_never(definition, cell, state, event, marks):
            targets = tuple(dict.fromkeys(there for choice in possible(cell) for there in landings(definition, choice)))
            if targets:
                found[state][event] = targets
    return found


def reached(graph: Graph, start: str, without: Iterable[str] = ()) -> dict[str, tuple[str, str] | None]:
    """The states that can be reached from `start` (which counts), each with the (state, event) before it on a shortest way."""
    shut = set(without)
    if start in shut:
        return {}
    before: dict[str, tuple[str, str] | None] = {start: None}
    queue = deque([start])
    while queue:
        state = queue.popleft()
        for event, targets in graph[state].items():
            for target in targets:
                if target not in before and target not in shut:
                    before[target] = (state, event)
                    queue.append(target)
    return before


def way(before: Mapping[str, tuple[str, str] | None], goals: Collection[str]) -> str:
    """`STAT -LEFT-> TLFT`: how the first of some states that can be reached is reached; empty where none can."""
    state = next((one for one in before if one in goals), None)
    if state is None:
        return ""
    steps: list[str] = []
    while (last := before[state]) is not None:
        steps.append(f" -{last[1]}-> {state}")
        state = last[0]
    return state + "".join(reversed(steps))


def cycle(edges: Mapping[str, str]) -> list[str]:
    """A cycle of a graph in which each state has at most one successor; empty where there is none."""
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
    """The state that is sure to follow when a motion ends and nobody touches anything, if any; idle counts where END is blank."""
    found = {state: cells.get((state, END)) or cells.get((state, definition.idle or END)) for state in definition.states}
    sure = {state: certain(cell) for state, cell in found.items() if cell}
    return {state: choice.to for state, choice in sure.items() if choice and choice.to in definition.states}
