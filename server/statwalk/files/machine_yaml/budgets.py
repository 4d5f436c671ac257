"""Reads `budgets` of a machine file: `{slide: 0.015, sink: 0.005, jump: 1.2, joint: 2.4, arrived: 0.8}`."""

from __future__ import annotations

from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.budgets_definition import FIGURES, BudgetDefinition

LARGEST = 1e6


def budgets(node: Node | None) -> dict[str, BudgetDefinition]:
    """Reads the budgets; none if the file has none.

    :raises MachineError: when a figure does not exist, or its budget is no number from 0 on.
    """
    if node is None or node.value == "":
        return {}
    entries = node.entries(*FIGURES)
    return {name: BudgetDefinition(entry.number(0, LARGEST), entry.line) for name, entry in entries.items()}
