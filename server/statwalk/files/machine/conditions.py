"""Conditions as text, checked when the file is read."""

from __future__ import annotations

from statwalk.files.yamltext import Node


def condition(node: Node, variables: tuple[str, ...]) -> str:  # noqa: ARG001
    """The text of a condition over `variables`; raises MachineError where there is none."""
    if not node.text():
        raise node.refuse("a condition is wanted here, as in stamina > 10")
    return node.text()
