"""Faults of names that all layers share: events, parameters, conditions, markers, colliders, motions; unknown ones and unused ones."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.machine.authored.definition import BlendDefinition, MachineDefinition, StateDefinition, TouchDefinition, nearest
from statwalk.machine.checking.asked import asked_of
from statwalk.machine.checking.findings import Finding
from statwalk.machine.checking.firing import Motions
from statwalk.machine.checking.sheet import Sheet

Sheets = tuple[Sheet, ...]


def unused_events(definition: MachineDefinition, sheets: Sheets) -> Iterator[Finding]:
    """Events that no cell of any layer answers."""
    answered = {event for sheet in sheets for (_, event), cell in sheet.cells.items() if not cell.off}
    for name, event in definition.events.items():
        if name in answered:
            continue
        if name in definition.senses:
            line = definition.senses[name].line
            yield Finding("unused sense", "warning", f"no cell answers {name}, which is sensed", line, None, name)
        else:
            yield Finding("unused event", "warning", f"no cell answers {name}", event.line, None, name)


def raised_on_nobody(definition: MachineDefinition, sheets: Sheets) -> Iterator[Finding]:
    """Events that are raised on others, and are none here: right only where another machine knows them."""
    actions = {cell.action: cell.line for sheet in sheets for cell in sheet.definition.cells.values()}
    actions |= {one.action: one.line for sheet in sheets for cell in sheet.definition.cells.values() for one in cell.alternatives}
    for action, line in actions.items():
        if action and action.name == "raise" and action.arguments and action.arguments[0] not in definition.events:
            hint = nearest(str(action.arguments[0]), definition.events)
            if hint:
                yield Finding("unknown event", "warning", f"{action} raises what is no event here{hint}", line)


def conditions(definition: MachineDefinition, sheets: Sheets) -> Iterator[Finding]:
    """Conditions that cannot be read, and those that are always true or always false."""
    for text, line, where in said_conditions(definition, sheets):
        asked = asked_of(definition, text)
        if asked.refused:
            yield Finding("condition", "error", f"{where}: {text[:80]!r}: {asked.refused}", line)
        elif asked.constant is not None:
            yield Finding("condition", "warning", f"{where}: {text[:80]!r} is always {str(asked.constant).lower()}", line)


def said_conditions(definition: MachineDefinition, sheets: Sheets) -> Iterator[tuple[str, int, str]]:
    """Text, line and place of each condition of cells and senses."""
    for sheet in sheets:
        for (row, column), cell in sheet.definition.cells.items():
            yield from ((one.condition, one.line, f"{row}/{column}") for one in cell.alternatives if one.condition)
    for name, sense in definition.senses.items():
        if not isinstance(sense, TouchDefinition):
            yield from ((text, sense.line, f"the sense {name}") for text in (sense.when, sense.release) if text)


def parameters(definition: MachineDefinition, sheets: Sheets) -> Iterator[Finding]:
    """Parameters that somebody asks for and the machine has not, and those that nobody asks for."""
    known, used = tuple(definition.parameters), set[str]()
    for text, _, _ in said_conditions(definition, sheets):
        used.update(asked_of(definition, text).names)
    for name, line, state, asker in asking(definition, sheets):
        used.add(name)
        if name not in known:
            yield Finding("unknown parameter", "error", f"{asker} is {name!r}, which is no parameter{nearest(name, known)}", line, state)
    if definition.flock:
        used.update(definition.flock.sets.values())
    for name, parameter in definition.parameters.items():
        if name not in used:
            yield Finding("unused parameter", "warning", f"nobody uses the parameter {name}", parameter.line)


def asking(definition: MachineDefinition, sheets: Sheets) -> Iterator[tuple[str, int, str | None, str]]:
    """Name, line, state and asker of each parameter that a speed, a blend or a layer's weight names."""
    for sheet in sheets:
        for state, one in sheet.definition.states.items():
            if isinstance(one.speed, str):
                yield one.speed, one.line, state, f"the speed of {state}"
            if isinstance(one.motion, BlendDefinition):
                yield from ((over, one.motion.line, state, f"what {state} is blended over") for over in one.motion.over)
    for name, layer in definition.layers.items():
        if isinstance(layer.weight, str):
            yield layer.weight, layer.line, None, f"the weight of the layer {name}"


def colliders(definition: MachineDefinition) -> Iterator[Finding]:
    """Touches of a collider that the machine has not."""
    for name, sense in definition.senses.items():
        if isinstance(sense, TouchDefinition) and sense.own not in definition.colliders:
            hint = nearest(sense.own, definition.colliders)
            yield Finding(
                "unknown collider", "error", f"{name} touches with {sense.own!r}, which is no collider{hint}", sense.line, None, name
            )


def markers(definition: MachineDefinition, sheets: Sheets, motions: Motions) -> Iterator[Finding]:
    """Markers that cells wait for and no motion has, and those that the file defines and nobody waits for."""
    known = {name for sheet in sheets for several in sheet.marks.values() for name in several}
    wanted = {
        cell.when.marker: ((row, column), cell.line)
        for sheet in sheets
        for (row, column), cell in sheet.definition.cells.items()
        if cell.when and cell.when.kind == "marker"
    }
    for name, ((row, column), line) in wanted.items():
        if motions is not None and name not in known:
            message = f"{row}/{column} waits for the marker {name}, which no motion has{nearest(name, sorted(known))}"
            yield Finding("unknown marker", "error", message, line, row, column)
    if not in_step(sheets):
        yield from unheard_markers(sheets, wanted.keys() | definition.events.keys())


def unheard_markers(sheets: Sheets, heard: set[str]) -> Iterator[Finding]:
    """Markers of states that nobody waits for, and that no column is named after."""
    for sheet in sheets:
        for state, one in sheet.definition.states.items():
            for name in one.markers:
                if name not in heard:
                    yield Finding("unused marker", "warning", f"nobody uses the marker {name} of {state}", one.line, state)


def in_step(sheets: Sheets) -> bool:
    """Whether markers are of use beside being waited for: motions are matched at them."""
    cells = [cell for sheet in sheets for one in sheet.cells.values() for cell in one.choices]
    states = [state for sheet in sheets for state in sheet.definition.states.values()]
    return any(cell.enter == "match" for cell in cells) or any(isinstance(state.motion, BlendDefinition) for state in states)


def unknown_motions(sheets: Sheets, motions: Motions) -> Iterator[Finding]:
    """States whose motion the character has not."""
    for sheet in sheets:
        for name, state in sheet.definition.states.items():
            yield from sheet.placed(missing(name, state, motions))


def missing(name: str, state: StateDefinition, motions: Motions) -> Iterator[Finding]:
    """The clips of a state that are none."""
    for clip in state.clips:
        if motions is not None and clip not in motions:
            yield Finding("unknown motion", "error", f"{name} has no motion {clip!r}{nearest(clip, tuple(motions))}", state.line, name)


def unused_motions(sheets: Sheets, motions: Motions) -> Iterator[Finding]:
    """Motions of the character that no state uses."""
    used = {clip for sheet in sheets for state in sheet.definition.states.values() for clip in state.clips}
    for name in motions or ():
        if name not in used:
            yield Finding("unused motion", "warning", f"no state uses the motion {name!r}")
