"""Conditions as text, checked when the file is read."""

from __future__ import annotations

from statwalk.files.yaml.yaml_text import Node
from statwalk.maths.formula.parser import parse
from statwalk.maths.formula.tokens import ConditionError


def condition(node: Node, variables: tuple[str, ...]) -> str:
    """Returns the text of a condition over `variables`.

    :raises MachineError: when the condition is empty or cannot be read.
    """
    if not node.text():
        raise node.refuse("a condition is needed here, as in stamina > 10")
    try:
        parse(node.text(), variables)
    except ConditionError as error:
        raise node.refuse(f"the condition {node.text()[:60]!r}: {error}") from None
    return node.text()
