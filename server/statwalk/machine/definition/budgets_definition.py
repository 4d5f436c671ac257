"""The budgets of a machine: the largest figures that measuring its transitions may give."""

from __future__ import annotations

from dataclasses import dataclass

FIGURES = ("jump", "joint", "slide", "sink", "hover", "knee", "hand", "visible", "half", "arrived")
"""the figures that have a budget; `stage.measure.figures` says what they are"""


@dataclass(frozen=True)
class BudgetDefinition:
    """The largest value of a figure: metres, seconds, m/s², or times the motions' own."""

    most: float
    line: int
