"""Reads lines of expressions (EX1), and says what they may read and set."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from statwalk.errors import nearest
from statwalk.machine.definition.expression_definition import (
    CHANNELS,
    CLOCKS,
    FRAME,
    LENGTH,
    TIME,
    WEIGHT,
    channel_of_name,
)
from statwalk.maths.formula.assignments import Assignment, AssignmentError, read_assignments


def read_lines(
    lines: Sequence[tuple[int, str]], parameters: Collection[str], clocks: Collection[str] = CLOCKS
) -> tuple[Assignment, ...]:
    """Returns the assignments of numbered lines, sorted by dependency; whether the joints and morph targets
    exist is for the character to say.

    `parameters`: the names that are set from outside; `clocks`: the clocks that a line may read.

    :raises AssignmentError: when a line is no expression, or sets what cannot be set; names form a circle; or
        a name is unknown.
    """

    def check(name: str, names_set: frozenset[str]) -> str:
        return _problem(name, names_set, parameters, clocks)

    assignments = read_assignments(lines, check)
    for assignment in assignments:
        _check_target(assignment, parameters)
    return assignments


def _problem(
    name: str, names_set: frozenset[str], parameters: Collection[str], clocks: Collection[str]
) -> str:
    """What is wrong with a name that a formula reads; empty: nothing."""
    if name in parameters or name in names_set or name in clocks or channel_of_name(name):
        return ""
    if name == FRAME:
        return f"{FRAME} is for the machine's `expressions`; the clock of a state's motion is {TIME}"
    if "." in name:
        channel, known = name.rpartition(".")[2], (*CHANNELS, LENGTH, WEIGHT)
        return (
            f"{name[:60]!r} has no channel {channel[:40]!r}{nearest(channel, known) or '.'} "
            f"There are: {', '.join(known)}"
        )
    names = (*parameters, *names_set, *clocks)
    return f"no variable is called {name[:40]!r}{nearest(name, names) or '.'} There are: {', '.join(names)}"


def _check_target(assignment: Assignment, parameters: Collection[str]) -> None:
    """Refuses a left side that is neither a channel nor a new variable."""
    name = assignment.target
    if name in CLOCKS:
        raise AssignmentError(f"{name} is built in; nothing can set it", assignment.line)
    if name in parameters:
        raise AssignmentError(
            f"{name} is a parameter, which is set from outside; choose another name", assignment.line
        )
    if "." in name and channel_of_name(name) is None:
        problem = _problem(name, frozenset(), (), ())
        raise AssignmentError(problem, assignment.line)
