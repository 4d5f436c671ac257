"""Faults of states: names that are none, states that cannot be reached or left, cycles that take no time."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.machine.authored.definition import END, nearest
from statwalk.machine.checking.findings import Finding
from statwalk.machine.checking.firing import certain
from statwalk.machine.checking.reach import by_end, cycle, reached, way
from statwalk.machine.checking.sheet import Sheet


def undefined_states(sheet: Sheet) -> Iterator[Finding]:
    """Cells that name what is no state: one finding a name, with all the cells that say it."""
    definition = sheet.definition
    places: dict[str, dict[tuple[str, str], int]] = {}
    for place, cell in definition.cells.items():
        for outcome in () if cell.off else cell.alternatives or (cell,):
            if outcome.to not in definition.states and outcome.to not in definition.outers:
                places.setdefault(outcome.to, {}).setdefault(place, outcome.line)
    for name, where in places.items():
        (state, event), line = next(iter(where.items()))
        said = ", ".join(f"{row}/{column} (line {one})" for (row, column), one in where.items())
        hint = nearest(name, (*definition.states, *definition.outers))
        yield Finding("undefined state", "error", f"{name} is no state{hint or ';'} It stands in {said}", line, state, event)


def unreachable(sheet: Sheet) -> Iterator[Finding]:
    """States that no events lead to."""
    definition = sheet.definition
    before = reached(sheet.graph, definition.initial)
    for name, state in definition.states.items():
        if name not in before:
            yield Finding("unreachable state", "warning", f"{name} cannot be reached from {definition.initial}", state.line, name)


def without_exit(sheet: Sheet) -> Iterator[Finding]:
    """States that can be reached and never left, unless the table has no other."""
    states = sheet.definition.states
    before = reached(sheet.graph, sheet.definition.initial)
    for name, state in states.items():
        following = {target for targets in sheet.graph[name].values() for target in targets}
        if name in before and len(states) > 1 and following <= {name}:
            yield Finding("no exit", "warning", f"{name} cannot be left ({way(before, (name,))})", state.line, name)


def endless(sheet: Sheet) -> Iterator[Finding]:
    """Outer states whose END has a cell and never comes, since no inner state marked `final` can be reached."""
    definition = sheet.definition
    before = reached(sheet.graph, definition.initial)
    for (row, event), cell in definition.cells.items():
        if event == END and row in definition.outers:
            finals = [state for (state, _), one in sheet.cells.items() if one.written == (row, END)]
            if not any(state in before for state in finals):
                why = f"{', '.join(finals)} cannot be reached" if finals else "none of its states is marked `final`"
                yield Finding("cell never fires", "warning", f"{row} never ends: {why}", cell.line, row, END)


def swinging(sheet: Sheet) -> Iterator[Finding]:
    """Cycles that take no time: an input which, held down, changes the state in every tick."""
    moves: dict[str, dict[str, str]] = {event: {} for event in sheet.definition.events}
    for (state, event), cell in sheet.cells.items():
        outcome = certain(cell) if event != END and cell.when.kind == "now" else None
        if outcome and outcome.to in sheet.definition.states and outcome.to != state:
            moves[event][state] = outcome.to
    for event, edges in moves.items():
        states = cycle(edges)
        if states:
            chain = " -> ".join((*states, states[0]))
            message, line = f"{event} held down changes the state in every tick: {chain}", sheet.cells[states[0], event].line
            yield Finding("cycle without time", "warning", message, line, states[0], event)


def timeless(sheet: Sheet) -> Iterator[Finding]:
    """Cycles of END through motions that take no time: the state changes in every tick."""
    definition = sheet.definition
    at_once = {name for name, facts in (sheet.motions or {}).items() if facts.duration <= 0}
    still = {name for name, state in definition.states.items() if state.clips and at_once.issuperset(state.clips)}
    following = by_end(definition, sheet.cells)
    states = cycle({state: target for state, target in following.items() if state in still and target in still and target != state})
    if states:
        chain = " -> ".join((*states, states[0]))
        message = f"{END} changes the state in every tick, the motions take no time: {chain}"
        yield Finding("cycle without time", "warning", message, definition.states[states[0]].line, states[0], END)
