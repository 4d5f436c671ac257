"""Conditions as text, checked when the file is read."""

from __future__ import annotations

from statwalk.files.yamltext import Node
from statwalk.machine.conditions.parser import parse
from statwalk.machine.conditions.words import ConditionError


def condition(node: Node, variables: tuple[str, ...]) -> str:
    """The text of a condition over `variables`; raises MachineError where it cannot be read."""
    if not node.text():
        raise node.refuse("a condition is wanted here, as in stamina > 10")
    try:
        parse(node.text(), variables)
    except ConditionError as error:
        raise node.refuse(f"the condition {node.text()[:60]!r}: {error}") from None
    return node.text()
