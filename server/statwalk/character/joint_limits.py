"""The limits of a role's joints: those of its character, and those of its machine, which replace them."""

from __future__ import annotations

from statwalk.character.character import Character
from statwalk.errors import UnknownNameError
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.maths.clamp_table import JointLimit
from statwalk.rig.joint_types import freedoms


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


def check_handles(character: Character, definition: MachineDefinition) -> None:
    """Checks that the handles of parameters are at degrees of freedom of joints with limits.

    :raises MachineError: when a joint has no limits, or no such degree of freedom; with the line.
    """
    limits = {character.skeleton.names[row]: limit for row, limit in limits_of(character, definition).items()}
    for parameter in definition.parameters.values():
        joint, freedom = parameter.joint, parameter.freedom
        if not joint:
            continue
        if joint not in limits:
            error = UnknownNameError("joint with limits", joint, limits)
            raise definition.refuse(f"handle: {error}", parameter.line)
        if parameter.event and parameter.event not in definition.events:
            error = UnknownNameError("event", parameter.event, definition.events)
            raise definition.refuse(f"handle: {error}", parameter.line)
        names = [free.name for free in freedoms(limits[joint])]
        if freedom not in names:
            error = UnknownNameError(f"degree of freedom of {joint}", freedom, names)
            raise definition.refuse(f"handle: {error}", parameter.line)
