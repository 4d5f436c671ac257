"""The expressions of a machine on a character (EX1): joints and channels by their numbers."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.character.character import Character
from statwalk.errors import UnknownNameError
from statwalk.machine.compile.compile_machine import Machine
from statwalk.machine.definition.expression_definition import (
    CHANNELS,
    ExpressionMotion,
    channel_of_name,
)
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.maths.formula.assignments import Assignment
from statwalk.solve.expression_tables import ExpressionProgram, JointChannel, expression_program


def expressions_of(
    character: Character, definition: MachineDefinition, machine: Machine
) -> ExpressionProgram:
    """Returns the program of a machine's expressions and of its states' motions.

    :raises MachineError: when an expression names a joint that the character does not have; with the line.
    """
    states = [state for table in definition.tables().values() for state in table.states.values()]
    groups: list[tuple[Assignment, ...]] = [definition.expressions]
    group_of_state: list[int] = []
    for state in states:
        if isinstance(state.motion, ExpressionMotion):
            groups.append(state.motion.assignments)
        group_of_state.append(len(groups) - 1 if isinstance(state.motion, ExpressionMotion) else 0)
    parameters = [parameter.name for parameter in machine.parameters]
    channels = {
        name: _channel(character, definition, assignment, name)
        for assignments in groups
        for assignment in assignments
        for name in _channel_names(assignment)
        if name not in parameters
    }
    return expression_program(groups, group_of_state, channels, parameters)


def _channel_names(assignment: Assignment) -> Iterator[str]:
    names = (assignment.target, *assignment.formula.scope)
    return (name for name in names if channel_of_name(name) is not None)


def _channel(
    character: Character, definition: MachineDefinition, assignment: Assignment, name: str
) -> JointChannel:
    joint, channel = channel_of_name(name) or ("", "")
    try:
        return JointChannel(character.skeleton.index(joint), CHANNELS.index(channel))
    except UnknownNameError as error:
        raise definition.refuse(f"expressions: {error}", assignment.line) from None
