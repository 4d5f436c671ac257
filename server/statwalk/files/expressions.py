"""Reads the expressions of a machine or character file (EX1): lines of text, or a list of lines."""

from __future__ import annotations

from collections.abc import Collection

from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.expression_definition import CLOCKS, TIME, ExpressionMotion
from statwalk.machine.definition.expression_lines import read_lines
from statwalk.maths.formula.assignments import Assignment, AssignmentError


def expressions(node: Node | None, parameters: Collection[str] = ()) -> tuple[Assignment, ...]:
    """Reads `gear_b.rotate_z = -(10/8) * gear_a.rotate_z`, sorted by dependency.

    :raises ContentError: when a line is no expression, or sets what cannot be set; names form a circle; or a
        name is unknown, which for a joint is said when the character is known.
    """
    return () if node is None or node.value == "" else _read(node, parameters, CLOCKS)


def motion_of_expressions(node: Node, parameters: Collection[str]) -> ExpressionMotion:
    """Reads `{expressions: …}`, a state's motion; its clock is `time`, seconds into the motion.

    :raises ContentError: as `expressions`; or when no channel is set.
    """
    return ExpressionMotion(_read(node, parameters, (TIME,)), node.line)


def _read(node: Node, parameters: Collection[str], clocks: tuple[str, ...]) -> tuple[Assignment, ...]:
    try:
        return read_lines(_lines(node), parameters, clocks)
    except AssignmentError as error:
        raise node.refuse(error.message, error.line) from None


def _lines(node: Node) -> list[tuple[int, str]]:
    if node.is_text:
        return list(enumerate(node.text().split("\n"), node.first_line))
    return [(item.line, item.text()) for item in node.items()]
