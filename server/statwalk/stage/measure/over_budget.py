"""Findings about figures over the budgets of a machine file."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.machine.lint.findings import Finding
from statwalk.stage.measure.figures import Figure, worded
from statwalk.stage.measure.measure import Measured


def over_budget(definition: MachineDefinition, measured: Iterable[Measured]) -> Iterator[Finding]:
    """Yields a warning for every figure over its budget, with the cell, the phase and the joint; on
    uneven ground also with the place.
    """
    for part in measured:
        for name, budget in definition.budgets.items():
            figure = part.figures.get(name)
            if figure is not None and figure.worst > budget.most:
                limit = worded(name, budget.most)
                place = f", from {figure.place.words}" if definition.ground else ""
                message = f"{part.name}: {name} {sentence(name, figure)}{place}; the budget is {limit}"
                yield Finding(
                    "budget", "warning", message, part.line, part.state, part.event or None, part.layer
                )


def sentence(name: str, figure: Figure) -> str:
    """Returns the worst of a figure, and where it is: `826 mm at phase 0.3`."""
    interrupted = f", then {figure.then} after {figure.ticks} ticks" if figure.then else ""
    joint = f" of {figure.joint}" if figure.joint else ""
    return f"{worded(name, figure.worst)}{joint} at phase {figure.phase:g}{interrupted}"
