"""The expressions of a machine and of its character (EX1): joints, morph targets and channels by their
numbers.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.character.length_lines import Refuse, with_lengths
from statwalk.errors import UnknownNameError
from statwalk.machine.compile.compile_machine import Machine
from statwalk.machine.definition.expression_definition import (
    CHANNELS,
    CLOCKS,
    LENGTH,
    WEIGHT,
    ExpressionMotion,
    channel_of_name,
)
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.maths.formula.assignments import Assignment, CircleError, in_order
from statwalk.maths.formula.postfix import Formula
from statwalk.maths.simd.pose_layout import first_channels
from statwalk.skin.face_muscles import contractions_of
from statwalk.solve.expression_tables import (
    NO_SLOT,
    POWERS,
    ExpressionProgram,
    JointChannel,
    WeightChannel,
    expression_program,
)

OWN = "."
"""begins the name of a variable of the character's own expressions, which the machine's never meet"""


class ExpressionValues(NamedTuple):
    """What the lines of the machine and of its character set, by name."""

    variables: dict[str, float]
    """free variables; of two with one name the machine's"""
    channels: dict[str, float]
    """channels of joints: degrees, metres, scales; weights of morph targets"""


def expressions_of(
    character: Character, definition: MachineDefinition, machine: Machine
) -> ExpressionProgram:
    """Returns the program of the expressions of a machine, its character and its states' motions.

    The character's run with the machine's, in the order of their dependencies.

    :raises MachineError: when an expression names a joint or a morph target that the character does not have,
        sets a channel that the character sets itself, or forms a circle with the character's; with the line.
    """
    states = [state for table in definition.tables().values() for state in table.states.values()]
    groups = [with_lengths(character, _with_own(character, definition), definition.refuse)]
    group_of_state: list[int] = []
    for state in states:
        if isinstance(state.motion, ExpressionMotion):
            groups.append(with_lengths(character, state.motion.assignments, definition.refuse))
        group_of_state.append(len(groups) - 1 if isinstance(state.motion, ExpressionMotion) else 0)
    parameters = [parameter.name for parameter in machine.parameters]
    every = [assignment for assignments in groups for assignment in assignments]
    channels = channels_of(character, every, definition.refuse, parameters)
    return expression_program(groups, group_of_state, channels, parameters, _contractions(character))


def _contractions(character: Character) -> list[list[int]]:
    """The channels of a pose of each muscle: contraction, square, cube, NO_SLOT none."""
    joints = len(character.skeleton)
    columns = np.array(contractions_of(character.muscles, character.targets), np.int64).reshape(-1, POWERS)
    channels = first_channels("weights", columns, joints)
    rows: list[list[int]] = np.where(columns < 0, NO_SLOT, channels).tolist()
    return rows


def channels_of(
    character: Character, assignments: Iterable[Assignment], refuse: Refuse, parameters: Sequence[str] = ()
) -> dict[str, JointChannel | WeightChannel]:
    """Returns the channels that assignments (after `with_lengths`) read and set, by name.

    :raises StatwalkError: what `refuse` returns, when there is no joint or morph target of a name.
    """
    return {
        name: _channel(character, assignment, name, refuse)
        for assignment in assignments
        for name in _channel_names(assignment)
        if name not in parameters
    }


def check_channels(character: Character, assignments: Sequence[Assignment], refuse: Refuse) -> None:
    """Refuses lines of a character whose channels it does not have.

    :raises StatwalkError: what `refuse` returns, when there is no joint or morph target of a name.
    """
    channels_of(character, with_lengths(character, assignments, refuse), refuse)


def values_by_name(program: ExpressionProgram, values: Sequence[float]) -> ExpressionValues:
    """Returns the values (F,) of a program's slots by the names that set them."""
    named = dict(zip(program.slots, values, strict=True))
    own = {name.removeprefix(OWN): value for name, value in named.items() if name.startswith(OWN)}
    others = {name: value for name, value in named.items() if not name.startswith(OWN)}
    channels = {name: value for name, value in others.items() if channel_of_name(name)}
    return ExpressionValues(
        own | {name: value for name, value in others.items() if name not in channels}, channels
    )


def _with_own(character: Character, definition: MachineDefinition) -> tuple[Assignment, ...]:
    """The machine's assignments and the character's, sorted."""
    if not character.expressions:
        return definition.expressions
    own = {line.target: line for line in map(_apart, character.expressions)}
    for line in definition.expressions:
        if line.target in own:
            raise definition.refuse(
                f"expressions: {line.target} is set by the character's own expressions (line "
                f"{own[line.target].line} of its file)",
                line.line,
            )
    machines = {line.target: line for line in definition.expressions}
    try:
        return in_order(machines | own)
    except CircleError as error:
        first = min(machines[name].line for name in error.names if name in machines)
        raise definition.refuse(f"expressions: with the character's own, {error.message}", first) from None


def _apart(line: Assignment) -> Assignment:
    """A line of the character, its free variables named apart from the machine's."""
    formula = line.formula
    scope = tuple(map(_own_name, formula.scope))
    steps = tuple(_own_name(step) if isinstance(step, str) else step for step in formula.steps)
    return replace(line, target=_own_name(line.target), formula=Formula(formula.text, scope, steps))


def _own_name(name: str) -> str:
    return name if channel_of_name(name) or name in CLOCKS else OWN + name


def _channel_names(assignment: Assignment) -> Iterator[str]:
    names = (assignment.target, *assignment.formula.scope)
    return (name for name in names if (channel_of_name(name) or ("", LENGTH))[1] != LENGTH)


def _channel(
    character: Character, assignment: Assignment, name: str, refuse: Refuse
) -> JointChannel | WeightChannel:
    owner, channel = channel_of_name(name) or ("", "")
    try:
        if channel == WEIGHT:
            columns = np.array(character.target(owner), np.int64)
            channels = first_channels("weights", columns, len(character.skeleton))
            return WeightChannel(tuple(channels.tolist()))
        return JointChannel(character.skeleton.index(owner), CHANNELS.index(channel))
    except UnknownNameError as error:
        raise refuse(f"expressions: {error}", assignment.line) from None
