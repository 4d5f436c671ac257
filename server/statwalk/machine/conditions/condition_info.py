"""Describes a condition: the names that it asks for, or why it cannot be read."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from statwalk.machine.conditions.variables import variables_of
from statwalk.maths.formula.parser import parse
from statwalk.maths.formula.tokens import ConditionError


@dataclass(frozen=True)
class ConditionInfo:
    """The facts about a condition that need no actor."""

    names: tuple[str, ...] = ()
    refused: str = ""
    """why it cannot be read; empty if it can"""
    constant: bool | None = None
    """its constant value, if it asks for no variable"""


def condition_info(text: str, parameters: Iterable[str]) -> ConditionInfo:
    """Returns the facts about a condition of a machine with these parameters."""
    variables = variables_of(parameters)
    try:
        formula = parse(text, variables)
    except ConditionError as error:
        return ConditionInfo(refused=str(error))
    constant = None if formula.variables else bool(formula.evaluate(np.zeros((len(variables), 1)))[0])
    return ConditionInfo(formula.variables, constant=constant)
