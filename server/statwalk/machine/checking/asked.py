"""What a condition asks for, or why it cannot be read."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from statwalk.machine.authored.definition import MachineDefinition
from statwalk.machine.built.runparts import MEASURED
from statwalk.machine.conditions.parser import parse
from statwalk.machine.conditions.words import ConditionError


@dataclass(frozen=True)
class Asked:
    """A condition as far as it is known without an actor."""

    names: tuple[str, ...] = ()
    refused: str = ""
    """why it cannot be read; empty where it can"""
    constant: bool | None = None
    """what it always is, where it asks for nothing"""


def asked_of(definition: MachineDefinition, text: str) -> Asked:
    """What a condition of a machine asks for."""
    known = tuple(dict.fromkeys((*definition.parameters, *MEASURED)))
    try:
        program = parse(text, known)
    except ConditionError as error:
        return Asked(refused=str(error))
    constant = None if program.variables else bool(program.evaluate(np.zeros((len(known), 1)))[0])
    return Asked(program.variables, constant=constant)
