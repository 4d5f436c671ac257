"""Reads the expressions of a machine file (EX1): lines of text, or a list of lines."""

from __future__ import annotations

from collections.abc import Mapping

from statwalk.errors import nearest
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.expression_definition import (
    CHANNELS,
    CLOCKS,
    FRAME,
    TIME,
    ExpressionMotion,
    channel_of_name,
)
from statwalk.machine.definition.parameter_definition import ParameterDefinition
from statwalk.maths.formula.assignments import Assignment, AssignmentError, read_assignments

Parameters = Mapping[str, ParameterDefinition]


def expressions(node: Node | None, parameters: Parameters) -> tuple[Assignment, ...]:
    """Reads `gear_b.rotate_z = -(10/8) * gear_a.rotate_z`, sorted by dependency.

    :raises MachineError: when a line is no expression, or sets what cannot be set; names form a circle; or a
        name is unknown, which for a joint is said when the character is known.
    """
    return () if node is None or node.value == "" else _read(node, parameters, CLOCKS)


def motion_of_expressions(node: Node, parameters: Parameters) -> ExpressionMotion:
    """Reads `{expressions: …}`, a state's motion; its clock is `time`, seconds into the motion.

    :raises MachineError: as `expressions`; or when no channel is set.
    """
    return ExpressionMotion(_read(node, parameters, (TIME,)), node.line)


def _read(node: Node, parameters: Parameters, clocks: tuple[str, ...]) -> tuple[Assignment, ...]:
    def check(name: str, names_set: frozenset[str]) -> str:
        return _problem(name, names_set, parameters, clocks)

    try:
        assignments = read_assignments(_lines(node), check)
        for assignment in assignments:
            _check_target(assignment, parameters)
    except AssignmentError as error:
        raise node.refuse(error.message, error.line) from None
    return assignments


def _lines(node: Node) -> list[tuple[int, str]]:
    if node.is_text:
        return list(enumerate(node.text().split("\n"), node.first_line))
    return [(item.line, item.text()) for item in node.items()]


def _problem(name: str, names_set: frozenset[str], parameters: Parameters, clocks: tuple[str, ...]) -> str:
    """What is wrong with a name that a formula reads; empty: nothing."""
    if name in parameters or name in names_set or name in clocks or channel_of_name(name):
        return ""
    if name == FRAME:
        return f"{FRAME} is for the machine's `expressions`; the clock of a state's motion is {TIME}"
    if "." in name:
        channel = name.rpartition(".")[2]
        return (
            f"{name[:60]!r} has no channel {channel[:40]!r}{nearest(channel, CHANNELS) or '.'} There are: "
            + ", ".join(CHANNELS)
        )
    names = (*parameters, *names_set, *clocks)
    return f"no variable is called {name[:40]!r}{nearest(name, names) or '.'} There are: {', '.join(names)}"


def _check_target(assignment: Assignment, parameters: Parameters) -> None:
    """Refuses a left side that is neither a channel nor a new variable."""
    name = assignment.target
    if name in CLOCKS:
        raise AssignmentError(f"{name} is built in; nothing can set it", assignment.line)
    if name in parameters:
        raise AssignmentError(
            f"{name} is a parameter, which is set from outside; choose another name", assignment.line
        )
    if "." in name and channel_of_name(name) is None:
        problem = _problem(name, frozenset(), {}, ())
        raise AssignmentError(problem, assignment.line)
