"""Finds faults of states: unknown names, states that cannot be reached or left, cycles that take no time."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.machine.definition.machine_definition import END, nearest
from statwalk.machine.lint.findings import Finding
from statwalk.machine.lint.firing import certain
from statwalk.machine.lint.lint_context import LintContext
from statwalk.machine.lint.reach import by_end, cycle, reached, way


def undefined_states(context: LintContext) -> Iterator[Finding]:
    """Finds cells that name an unknown state: one finding for each name, with all its cells."""
    definition = context.definition
    places: dict[str, dict[tuple[str, str], int]] = {}
    for place, cell in definition.cells.items():
        for alternative in () if cell.off else cell.alternatives or (cell,):
            if alternative.to not in definition.states and alternative.to not in definition.composites:
                places.setdefault(alternative.to, {}).setdefault(place, alternative.line)
    for name, lines in places.items():
        (state, event), line = next(iter(lines.items()))
        listed = ", ".join(f"{row}/{column} (line {number})" for (row, column), number in lines.items())
        hint = nearest(name, (*definition.states, *definition.composites))
        yield Finding(
            "undefined state",
            "error",
            f"{name} is no state{hint or '.'} It stands in {listed}",
            line,
            state,
            event,
        )


def unreachable(context: LintContext) -> Iterator[Finding]:
    """Finds states that no events lead to."""
    definition = context.definition
    before = reached(context.graph, definition.initial)
    for name, state in definition.states.items():
        if name not in before:
            yield Finding(
                "unreachable state",
                "warning",
                f"{name} cannot be reached from {definition.initial}",
                state.line,
                name,
            )


def without_exit(context: LintContext) -> Iterator[Finding]:
    """Finds states that can be reached and never left, unless the table has no other state."""
    states = context.definition.states
    before = reached(context.graph, context.definition.initial)
    for name, state in states.items():
        following = {target for targets in context.graph[name].values() for target in targets}
        if name in before and len(states) > 1 and following <= {name}:
            yield Finding(
                "no exit", "warning", f"{name} cannot be left ({way(before, (name,))})", state.line, name
            )


def endless(context: LintContext) -> Iterator[Finding]:
    """Finds composite states whose END has a cell but never comes, as no inner state marked `final` can be
    reached.
    """
    definition = context.definition
    before = reached(context.graph, definition.initial)
    for (row, event), cell in definition.cells.items():
        if event == END and row in definition.composites:
            finals = [state for (state, _), full in context.cells.items() if full.written == (row, END)]
            if not any(state in before for state in finals):
                why = (
                    f"{', '.join(finals)} cannot be reached"
                    if finals
                    else "none of its states is marked `final`"
                )
                yield Finding("cell never fires", "warning", f"{row} never ends: {why}", cell.line, row, END)


def swinging(context: LintContext) -> Iterator[Finding]:
    """Finds cycles that take no time: an input that changes the state in every tick while it is held down."""
    moves: dict[str, dict[str, str]] = {event: {} for event in context.definition.events}
    for (state, event), cell in context.cells.items():
        alternative = certain(cell) if event != END and cell.when.kind == "now" else None
        if alternative and alternative.to in context.definition.states and alternative.to != state:
            moves[event][state] = alternative.to
    for event, edges in moves.items():
        states = cycle(edges)
        if states:
            chain = " -> ".join((*states, states[0]))
            message, line = (
                f"{event} held down changes the state in every tick: {chain}",
                context.cells[states[0], event].line,
            )
            yield Finding("cycle without time", "warning", message, line, states[0], event)


def timeless(context: LintContext) -> Iterator[Finding]:
    """Finds cycles of END through motions that take no time: the state changes in every tick."""
    definition = context.definition
    at_once = {name for name, facts in (context.motions or {}).items() if facts.duration <= 0}
    still = {
        name for name, state in definition.states.items() if state.clips and at_once.issuperset(state.clips)
    }
    following = by_end(definition, context.cells)
    states = cycle(
        {
            state: target
            for state, target in following.items()
            if state in still and target in still and target != state
        }
    )
    if states:
        chain = " -> ".join((*states, states[0]))
        message = f"{END} changes the state in every tick, the motions take no time: {chain}"
        yield Finding(
            "cycle without time", "warning", message, definition.states[states[0]].line, states[0], END
        )
