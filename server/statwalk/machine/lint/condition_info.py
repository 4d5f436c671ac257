"""Describes a condition: the names that it asks for, or why it cannot be read."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from statwalk.machine.compile.alternatives import MEASURED
from statwalk.machine.definition.machine_definition import MachineDefinition
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


def condition_info(definition: MachineDefinition, text: str) -> ConditionInfo:
    """Returns the facts about a condition of a machine."""
    variable_names = tuple(dict.fromkeys((*definition.parameters, *MEASURED)))
    try:
        program = parse(text, variable_names)
    except ConditionError as error:
        return ConditionInfo(refused=str(error))
    constant = None if program.variables else bool(program.evaluate(np.zeros((len(variable_names), 1)))[0])
    return ConditionInfo(program.variables, constant=constant)
