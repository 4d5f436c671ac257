"""The length of a joint in expressions (SK3, EX1): spelled out by the translations of its children.

    upper.length = 0.4      # where `fore` is 0.5 m along -Y of `upper`: fore.trans_y = upper.length * -1

The length is the distance to the first child that stands away from the joint at rest. Where a line sets the
length, the places of all children at rest are scaled by one factor.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import StatwalkError, UnknownNameError
from statwalk.machine.definition.expression_definition import LENGTH, channel_of_name
from statwalk.maths.arrays import Floats
from statwalk.maths.formula.assignments import Assignment, CircleError, in_order
from statwalk.maths.formula.operations import OPERATORS
from statwalk.maths.formula.parser import parse
from statwalk.maths.formula.postfix import Formula
from statwalk.maths.formula.tokens import DOTTED, as_written

Refuse = Callable[[str, int], StatwalkError]
"""makes the error about a line of a file"""
_ON_AXIS = 1e-6
"""a child's part of the length below which it does not stand along an axis"""


def with_lengths(
    character: Character, assignments: Sequence[Assignment], refuse: Refuse
) -> tuple[Assignment, ...]:
    """Returns the assignments, and with them lines for the translations of the children of each joint whose
    length they read or set; sorted by dependency.

    :raises StatwalkError: what `refuse` returns, when a joint is unknown or has no length, a line sets a
        channel that a length sets, or names form a circle.
    """
    lines = {line.target: line for line in assignments}
    lengths = _lengths(assignments)
    if not lengths:
        return tuple(assignments)
    for name, line in lengths.items():
        added = _set_children if name in lines else _measured
        for follower in added(character, name, line.line, refuse):
            if follower.target in lines:
                taken = lines[follower.target].line
                raise refuse(
                    f"expressions: {name} sets {follower.target}, which line {taken} sets too", line.line
                )
            lines[follower.target] = follower
    try:
        return in_order(lines)
    except CircleError as error:
        raise refuse(f"expressions: {error.message}", error.line) from None


def _lengths(assignments: Sequence[Assignment]) -> dict[str, Assignment]:
    """The lengths that the lines set or read; each with the line that sets it, or with one that reads it."""
    names = {name: line for line in assignments for name in (*line.formula.variables, line.target)}
    names |= {line.target: line for line in assignments}
    return {name: line for name, line in names.items() if (channel_of_name(name) or ("", ""))[1] == LENGTH}


def _set_children(character: Character, name: str, line: int, refuse: Refuse) -> Iterator[Assignment]:
    """The translations of the children, as parts of the length."""
    children, rest, first = _children(character, name, line, refuse)
    for child in children:
        for axis, part in zip("xyz", (rest[child] / np.linalg.norm(rest[first])).tolist(), strict=True):
            if abs(part) > _ON_AXIS:
                formula = Formula(f"{as_written(name)} * {part:g}", (name,), (name, part, OPERATORS["*"]))
                target = f"{character.skeleton.names[child]}.trans_{axis}"
                yield Assignment(target, formula, line, follows=True)


def _measured(character: Character, name: str, line: int, refuse: Refuse) -> Iterator[Assignment]:
    """The length that the motion gives."""
    *_, first = _children(character, name, line, refuse)
    scope = tuple(f"{character.skeleton.names[first]}.trans_{axis}" for axis in "xyz")
    squares = " + ".join(f"{as_written(channel)} * {as_written(channel)}" for channel in scope)
    yield Assignment(name, parse(f"sqrt({squares})", scope, DOTTED), line, follows=True)


def _children(character: Character, name: str, line: int, refuse: Refuse) -> tuple[list[int], Floats, int]:
    """The children of a joint, the places of all joints at rest, and the child that its length leads to."""
    owner = name.rpartition(".")[0]
    try:
        joint = character.skeleton.index(owner)
    except UnknownNameError as error:
        raise refuse(f"expressions: {error}", line) from None
    rest = np.asarray(character.bind_pose.translation, np.float64)
    children = np.flatnonzero(character.skeleton.parent == joint).tolist()
    away = [child for child in children if rest[child].any()]
    if not away:
        raise refuse(f"expressions: {owner} has no length: no joint stands at its end", line)
    return children, rest, away[0]
