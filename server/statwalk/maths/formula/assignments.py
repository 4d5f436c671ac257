"""Assignments, `gear_b.rotate_z = -(10/8) * gear_a.rotate_z`, one in a line: read, checked, and sorted so
that each stands after the assignments that it reads (EX1; FAQ Q24).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter

from statwalk.maths.formula.parser import RESERVED, parse
from statwalk.maths.formula.postfix import Formula
from statwalk.maths.formula.tokens import DOTTED, ConditionError, as_written, words_of

MOST_ASSIGNMENTS = 1024


class AssignmentError(Exception):
    """An error in the line `line` (counted as the caller counts) of some assignments."""

    def __init__(self, message: str, line: int) -> None:
        super().__init__(message)
        self.message, self.line = message, line


class CircleError(AssignmentError):
    """Assignments that depend on each other in a circle; `names`: what they set."""

    def __init__(self, names: Sequence[str], line: int) -> None:
        super().__init__(
            f"these expressions form a circle, each reads the next: {' -> '.join(reversed(names))}", line
        )
        self.names = tuple(names)


@dataclass(frozen=True)
class Assignment:
    """One line: the name that it sets, and the formula of the value."""

    target: str
    formula: Formula
    line: int
    follows: bool = False
    """whether the line is made from another line, and stands in no file"""

    @property
    def text(self) -> str:
        """Returns the line as it is written, without spaces at its ends and without comment."""
        return f"{as_written(self.target)} = {self.formula.text}"


def read_assignments(
    lines: Sequence[tuple[int, str]], check: Callable[[str, frozenset[str]], str]
) -> tuple[Assignment, ...]:
    """Returns the assignments of numbered lines, sorted by dependency; empty lines and `# comments` count
    for nothing.

    `check` returns what is wrong with a name that is read, given the names that are set: empty, nothing.

    :raises AssignmentError: when a line is no assignment, a name is unknown or set twice, or names depend on
        each other in a circle.
    """
    parts = [part for line, text in lines for part in _parts(line, text)]
    if len(parts) > MOST_ASSIGNMENTS:
        raise AssignmentError(
            f"there are {len(parts):,} expressions; at most {MOST_ASSIGNMENTS:,} are allowed", parts[-1][0]
        )
    targets = _targets(parts)
    names_set = frozenset(targets)
    assignments = {
        target: Assignment(target, _formula(line, text, names_set, check), line)
        for target, (line, text) in targets.items()
    }
    return in_order(assignments)


def _parts(line: int, text: str) -> Iterator[tuple[int, str, str]]:
    code = text.split("#")[0].strip()
    if not code:
        return
    target, sign, value = code.partition("=")
    if not sign:
        raise AssignmentError(f"{code[:60]!r} is no expression; write NAME = FORMULA", line)
    yield line, target.strip(), value


def _targets(parts: Sequence[tuple[int, str, str]]) -> dict[str, tuple[int, str]]:
    """The line and formula of each name that is set."""
    targets: dict[str, tuple[int, str]] = {}
    for line, text, value in parts:
        name = _name(text, line)
        if name in targets:
            raise AssignmentError(f"{name} is already set in line {targets[name][0]}", line)
        targets[name] = line, value
    return targets


def _name(text: str, line: int) -> str:
    """The name on the left side of a line."""
    try:
        words = words_of(text, DOTTED)
    except ConditionError as error:
        raise AssignmentError(f"the left side {text[:60]!r}: {error}", line) from None
    if len(words) != 2 or words[0].kind != "name":
        raise AssignmentError(f"the left side must be one name, not {text[:60]!r}", line)
    if words[0].text in RESERVED:
        raise AssignmentError(f"{words[0].text} is built in; nothing can set it", line)
    return words[0].text


def _formula(
    line: int, text: str, names_set: frozenset[str], check: Callable[[str, frozenset[str]], str]
) -> Formula:
    try:
        words = words_of(text, DOTTED)
        names = dict.fromkeys(
            word.text for word in words if word.kind == "name" and word.text not in RESERVED
        )
        formula = parse(text, tuple(names), DOTTED)
    except ConditionError as error:
        raise AssignmentError(f"the formula {text.strip()[:60]!r}: {error}", line) from None
    for name in formula.variables:
        if problem := check(name, names_set):
            raise AssignmentError(problem, line)
    return formula


def in_order(assignments: Mapping[str, Assignment]) -> tuple[Assignment, ...]:
    """Sorts assignments: each stands after the assignments whose targets it reads. Keys are the targets.

    :raises CircleError: when names depend on each other in a circle.
    """
    reads = {
        target: [name for name in assignment.formula.variables if name in assignments]
        for target, assignment in assignments.items()
    }
    try:
        return tuple(assignments[target] for target in TopologicalSorter(reads).static_order())
    except CycleError as error:
        circle = error.args[1]
        line = min(assignments[name].line for name in circle)
        raise CircleError(circle, line) from None
