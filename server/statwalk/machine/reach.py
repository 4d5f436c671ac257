"""The graph of a table: which states can follow which, by cells that can fire."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping

from statwalk.machine.definition import END, MachineDefinition
from statwalk.machine.expand import Cell

Graph = Mapping[str, Mapping[str, str]]
"""state -> event -> next state; only cells that can fire, stays among them"""


def graph_of(definition: MachineDefinition, cells: Mapping[tuple[str, str], Cell]) -> Graph:
    """All that can happen in each state. Every motion ends sooner or later, so END and `at end` can always come."""
    found: dict[str, dict[str, str]] = {state: {} for state in definition.states}
    for (state, event), cell in cells.items():
        if not cell.off and cell.to in definition.states:
            found[state][event] = cell.to
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
        for event, target in graph[state].items():
            if target not in before and target not in shut:
                before[target] = (state, event)
                queue.append(target)
    return before


def way(before: Mapping[str, tuple[str, str] | None], goal: str) -> str:
    """`STAT -LEFT-> TLFT`: how a state is reached."""
    steps: list[str] = []
    state = goal
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


def by_end(definition: MachineDefinition, cells: Mapping[tuple[str, str], Cell]) -> dict[str, str]:
    """The state that follows when a motion ends and nobody touches anything, if any; idle counts where END is blank."""
    found = {state: cells.get((state, END)) or cells.get((state, definition.idle or END)) for state in definition.states}
    return {state: cell.to for state, cell in found.items() if cell and not cell.off and cell.to in definition.states}
