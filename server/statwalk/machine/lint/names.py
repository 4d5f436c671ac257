"""Finds unknown and unused names that all layers share: events, parameters, conditions, markers, colliders,
motions.
"""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.errors import abridged
from statwalk.machine.compile.resolved_table import Motions
from statwalk.machine.conditions.condition_info import condition_info
from statwalk.machine.conditions.variables import ENTRY
from statwalk.machine.definition.expression_definition import ExpressionMotion
from statwalk.machine.definition.machine_definition import (
    BlendDefinition,
    MachineDefinition,
    StateDefinition,
    nearest,
)
from statwalk.machine.definition.sense_definition import TouchDefinition
from statwalk.machine.lint.findings import Finding
from statwalk.machine.lint.lint_context import LintContext

Contexts = tuple[LintContext, ...]


def unused_events(definition: MachineDefinition, contexts: Contexts) -> Iterator[Finding]:
    """Finds events that no cell of any layer answers."""
    answered = {event for context in contexts for (_, event), cell in context.cells.items() if not cell.off}
    for name, event in definition.events.items():
        if name in answered:
            continue
        if name in definition.senses:
            line = definition.senses[name].line
            yield Finding(
                "unused sense", "warning", f"no cell answers {name}, which is sensed", line, None, name
            )
        else:
            yield Finding("unused event", "warning", f"no cell answers {name}", event.line, None, name)


def raised_on_nobody(definition: MachineDefinition, contexts: Contexts) -> Iterator[Finding]:
    """Finds events that actions raise on other actors and this machine almost has; an event with no similar
    name may belong to another machine.
    """
    actions = {cell.action: cell.line for context in contexts for cell in context.definition.cells.values()}
    actions |= {
        alternative.action: alternative.line
        for context in contexts
        for cell in context.definition.cells.values()
        for alternative in cell.alternatives
    }
    for action, line in actions.items():
        if (
            action
            and action.name == "raise"
            and action.arguments
            and action.arguments[0] not in definition.events
        ):
            hint = nearest(str(action.arguments[0]), definition.events)
            if hint:
                yield Finding(
                    "unknown event", "warning", f"{action} raises what is no event here{hint}", line
                )


def conditions(definition: MachineDefinition, contexts: Contexts) -> Iterator[Finding]:
    """Finds conditions that cannot be read, and conditions that are always true or always false."""
    for text, line, place in _conditions_of(definition, contexts):
        info = condition_info(text, definition.parameters)
        if info.refused:
            yield Finding("condition", "error", f"{place}: {text[:80]!r}: {info.refused}", line)
        elif info.constant is not None:
            yield Finding(
                "condition",
                "warning",
                f"{place}: {text[:80]!r} is always {str(info.constant).lower()}",
                line,
            )


def _conditions_of(definition: MachineDefinition, contexts: Contexts) -> Iterator[tuple[str, int, str]]:
    """Text, line and place of each condition of cells and senses."""
    for context in contexts:
        for (row, column), cell in context.definition.cells.items():
            yield from (
                (alternative.condition, alternative.line, f"{row}/{column}")
                for alternative in cell.alternatives
                if alternative.condition
            )
    for name, sense in definition.senses.items():
        if not isinstance(sense, TouchDefinition):
            yield from (
                (text, sense.line, f"the sense {name}") for text in (sense.when, sense.release) if text
            )


def parameters(definition: MachineDefinition, contexts: Contexts) -> Iterator[Finding]:
    """Finds parameters that the machine uses but does not define, and parameters that it defines but does not
    use.
    """
    parameter_names, used = tuple(definition.parameters), set[str]()
    for text, _, _ in _conditions_of(definition, contexts):
        used.update(condition_info(text, definition.parameters).names)
    for name, line, state, user in _parameter_uses(definition, contexts):
        used.add(name)
        if name not in parameter_names:
            yield Finding(
                "unknown parameter",
                "error",
                f"{user} is {name!r}, which is no parameter{nearest(name, parameter_names)}",
                line,
                state,
            )
    if definition.flock:
        used.update(definition.flock.sets.values())
    used.update(name for solver in definition.solvers.values() for name in solver.parameters)
    used.update(_names_in_expressions(definition, contexts))
    used |= {definition.parameters[name].vector for name in used if name in definition.parameters}
    seen = set[str]()
    for name, parameter in definition.parameters.items():
        whole = parameter.vector or name
        if name not in used and whole not in used | seen:
            seen.add(whole)
            yield Finding("unused parameter", "warning", f"the parameter {whole} is unused", parameter.line)


def _names_in_expressions(definition: MachineDefinition, contexts: Contexts) -> Iterator[str]:
    motions = [state.motion for context in contexts for state in context.definition.states.values()]
    driven = [motion.assignments for motion in motions if isinstance(motion, ExpressionMotion)]
    for lines in (definition.expressions, *driven):
        yield from (name for line in lines for name in line.formula.scope)


def _parameter_uses(
    definition: MachineDefinition, contexts: Contexts
) -> Iterator[tuple[str, int, str | None, str]]:
    """Name, line, state and user of each parameter that a speed, a blend or a layer's weight names."""
    for context in contexts:
        for state, written in context.definition.states.items():
            if isinstance(written.speed, str):
                yield written.speed, written.line, state, f"the speed of {state}"
            if isinstance(written.motion, BlendDefinition):
                yield from (
                    (over, written.motion.line, state, f"what {state} is blended over")
                    for over in written.motion.over
                    if over not in ENTRY
                )
    for name, layer in definition.layers.items():
        if isinstance(layer.weight, str):
            yield layer.weight, layer.line, None, f"the weight of the layer {name}"


def colliders(definition: MachineDefinition) -> Iterator[Finding]:
    """Finds touches of a collider that the machine does not have."""
    for name, sense in definition.senses.items():
        if isinstance(sense, TouchDefinition) and sense.own not in definition.colliders:
            hint = nearest(sense.own, definition.colliders)
            yield Finding(
                "unknown collider",
                "error",
                f"{name} touches with {sense.own!r}, which is no collider{hint}",
                sense.line,
                None,
                name,
            )


def markers(definition: MachineDefinition, contexts: Contexts, motions: Motions) -> Iterator[Finding]:
    """Finds markers that cells wait for but no motion has, and markers that the file defines but no cell
    waits for.
    """
    marker_names = {name for context in contexts for names in context.markers.values() for name in names}
    wanted = {
        cell.when.marker: ((row, column), cell.line)
        for context in contexts
        for (row, column), cell in context.definition.cells.items()
        if cell.when and cell.when.kind == "marker"
    }
    for name, ((row, column), line) in wanted.items():
        if motions is not None and name not in marker_names:
            message = (
                f"{row}/{column} waits for the marker {name}, which no motion "
                f"has{nearest(name, sorted(marker_names))}"
            )
            yield Finding("unknown marker", "error", message, line, row, column)
    if not _in_step(contexts):
        yield from _unheard_markers(contexts, wanted.keys() | definition.events.keys())


def _unheard_markers(contexts: Contexts, heard: set[str]) -> Iterator[Finding]:
    """Markers of states that no cell waits for, and that no column is named after."""
    for context in contexts:
        for state, written in context.definition.states.items():
            for name in written.markers:
                if name not in heard:
                    yield Finding(
                        "unused marker",
                        "warning",
                        f"the marker {name} of {state} is unused",
                        written.line,
                        state,
                    )


def _in_step(contexts: Contexts) -> bool:
    """Whether motions are matched at markers: markers are then in use even if no cell waits for them."""
    choices = [choice for context in contexts for cell in context.cells.values() for choice in cell.choices]
    states = [state for context in contexts for state in context.definition.states.values()]
    return any(choice.enter == "match" for choice in choices) or any(
        isinstance(state.motion, BlendDefinition) for state in states
    )


def unknown_motions(contexts: Contexts, motions: Motions) -> Iterator[Finding]:
    """Finds states whose motion the character does not have."""
    for context in contexts:
        for name, state in context.definition.states.items():
            yield from context.placed(_missing_clips(name, state, motions))


def _missing_clips(name: str, state: StateDefinition, motions: Motions) -> Iterator[Finding]:
    for clip in state.clips:
        if motions is not None and clip not in motions:
            yield Finding(
                "unknown motion",
                "error",
                f"{name} has no motion {clip!r}{nearest(clip, tuple(motions))}",
                state.line,
                name,
            )


def unused_motions(contexts: Contexts, motions: Motions) -> Iterator[Finding]:
    """Finds motions of the character that no state uses; all in one finding, since they may be many."""
    used = {
        clip for context in contexts for state in context.definition.states.values() for clip in state.clips
    }
    if unused := tuple(name for name in motions or () if name not in used):
        yield Finding("unused motion", "warning", f"motions that no state uses: {abridged(unused)}")
