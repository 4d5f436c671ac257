"""What is wrong with a table, and what can be proved of it, without running it (SM3)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from statwalk.machine.build import MotionFacts
from statwalk.machine.celldefinition import CellDefinition
from statwalk.machine.definition import ANY, END, MachineDefinition, nearest
from statwalk.machine.expand import Cell, expand
from statwalk.machine.findings import Finding
from statwalk.machine.properties import answer
from statwalk.machine.reach import Graph, by_end, cycle, graph_of, reached, way

Cells = Mapping[tuple[str, str], Cell]


def verify(definition: MachineDefinition, motions: Mapping[str, MotionFacts] | None = None) -> list[Finding]:
    """All findings, by the kind of fault; with `motions` (by name) those about motions and time as well. Nothing is raised.

    Errors make the machine something else than its author meant; warnings may be meant; info says what was proved.
    """
    cells = expand(definition)
    graph = graph_of(definition, cells)
    found = [*undefined_states(definition), *unreachable(definition, graph), *without_exit(definition, graph)]
    found += [*unused_events(definition, cells), *shadowed(definition, cells), *swinging(definition, cells), *parameters(definition)]
    if motions is not None:
        found += [*unknown_motions(definition, motions), *unused_motions(definition, motions), *timeless(definition, cells, motions)]
    return found + [answer(definition, graph, said) for said in definition.properties]


def undefined_states(definition: MachineDefinition) -> Iterator[Finding]:
    """Cells that name what is no state: one finding a name, with all the cells that say it."""
    places: dict[str, list[tuple[tuple[str, str], CellDefinition]]] = {}
    for place, cell in definition.cells.items():
        if not cell.off and cell.to not in definition.states:
            places.setdefault(cell.to, []).append((place, cell))
    for name, where in places.items():
        (state, event), first = where[0]
        said = ", ".join(f"{row}/{column} (line {cell.line})" for (row, column), cell in where)
        hint = nearest(name, tuple(definition.states))
        yield Finding("undefined state", "error", f"{name} is no state{hint or ';'} It stands in {said}", first.line, state, event)


def unreachable(definition: MachineDefinition, graph: Graph) -> Iterator[Finding]:
    """States that no events lead to."""
    before = reached(graph, definition.initial)
    for name, state in definition.states.items():
        if name not in before:
            yield Finding("unreachable state", "warning", f"{name} cannot be reached from {definition.initial}", state.line, name)


def without_exit(definition: MachineDefinition, graph: Graph) -> Iterator[Finding]:
    """States that can be reached and never left, unless the machine has no other."""
    before = reached(graph, definition.initial)
    for name, state in definition.states.items():
        if name in before and len(definition.states) > 1 and set(graph[name].values()) <= {name}:
            yield Finding("no exit", "warning", f"{name} cannot be left ({way(before, name)})", state.line, name)


def unused_events(definition: MachineDefinition, cells: Cells) -> Iterator[Finding]:
    """Events that no cell answers."""
    answered = {event for (_, event), cell in cells.items() if not cell.off}
    for name, event in definition.events.items():
        if name not in answered:
            yield Finding("unused event", "warning", f"no cell answers {name}", event.line, None, name)


def shadowed(definition: MachineDefinition, cells: Cells) -> Iterator[Finding]:
    """Defaults that never count, since every cell that they are for says something itself."""
    counted = {cell.written for cell in cells.values()}
    for (row, column), cell in definition.cells.items():
        if ANY in (row, column) and (row, column) not in counted:
            yield Finding("cell never fires", "warning", f"{row}/{column} never counts: other cells come before it", cell.line, row, column)


def swinging(definition: MachineDefinition, cells: Cells) -> Iterator[Finding]:
    """Cycles that take no time: an input which, held down, changes the state in every tick."""
    for event in definition.events:
        moves = {
            state: cell.to
            for (state, column), cell in cells.items()
            if column == event and cell.when.kind == "now" and not cell.off and cell.to in definition.states and cell.to != state
        }
        states = cycle(moves)
        if states:
            chain = " -> ".join((*states, states[0]))
            line = cells[states[0], event].line
            yield Finding(
                "cycle without time", "warning", f"{event} held down changes the state in every tick: {chain}", line, states[0], event
            )


def parameters(definition: MachineDefinition) -> Iterator[Finding]:
    """Parameters that states ask for and the machine has not, and those that nobody asks for."""
    known = tuple(definition.parameters)
    asked = {state.speed for state in definition.states.values()}
    for name, state in definition.states.items():
        if isinstance(state.speed, str) and state.speed not in known:
            message = f"the speed of {name} is {state.speed!r}, which is no parameter{nearest(state.speed, known)}"
            yield Finding("unknown parameter", "error", message, state.line, name)
    for name, parameter in definition.parameters.items():
        if name not in asked:
            yield Finding("unused parameter", "warning", f"nobody uses the parameter {name}", parameter.line)


def unknown_motions(definition: MachineDefinition, motions: Mapping[str, MotionFacts]) -> Iterator[Finding]:
    """States whose motion the character has not."""
    for name, state in definition.states.items():
        for clip in state.clips:
            if clip not in motions:
                message = f"{name} has no motion {clip!r}{nearest(clip, tuple(motions))}"
                yield Finding("unknown motion", "error", message, state.line, name)


def unused_motions(definition: MachineDefinition, motions: Mapping[str, MotionFacts]) -> Iterator[Finding]:
    """Motions of the character that no state uses."""
    used = {clip for state in definition.states.values() for clip in state.clips}
    for name in motions:
        if name not in used:
            yield Finding("unused motion", "warning", f"no state uses the motion {name!r}")


def timeless(definition: MachineDefinition, cells: Cells, motions: Mapping[str, MotionFacts]) -> Iterator[Finding]:
    """Cycles of END through motions that take no time: the state changes in every tick."""
    at_once = {name for name, facts in motions.items() if facts.duration <= 0}
    still = {name for name, state in definition.states.items() if at_once.issuperset(state.clips)}
    following = by_end(definition, cells)
    states = cycle({state: target for state, target in following.items() if state in still and target in still and target != state})
    if states:
        chain = " -> ".join((*states, states[0]))
        line = definition.states[states[0]].line
        yield Finding(
            "cycle without time",
            "warning",
            f"{END} changes the state in every tick, the motions take no time: {chain}",
            line,
            states[0],
            END,
        )
