"""The limits of a role's joints: those of its character, and those of its machine, which replace them."""

from __future__ import annotations

from statwalk.character.character import Character
from statwalk.errors import UnknownNameError
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.maths.clamp_table import JointLimit


def limits_of(character: Character, definition: MachineDefinition) -> dict[int, JointLimit]:
    """Returns the limits by joint.

    :raises MachineError: when the machine limits a joint that the character does not have.
    """
    for name, limit in definition.limits.items():
        if name not in character.skeleton.names:
            message = str(UnknownNameError("joint", name, character.skeleton.names))
            raise definition.refuse(f"limits: {message}", limit.line)
    by_name = {**character.limits, **{name: limit for name, (limit, _line) in definition.limits.items()}}
    return {character.skeleton.index(name): limit for name, limit in by_name.items()}
