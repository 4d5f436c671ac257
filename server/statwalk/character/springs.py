"""The springs of a machine on a character: which joints swing, and where their bones end."""

from __future__ import annotations

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import UnknownNameError
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.maths import quat
from statwalk.motion.layers import below
from statwalk.solve.springs import Spring

_SHORTEST = 1e-6


def springs_on(character: Character, definition: MachineDefinition) -> dict[int, Spring]:
    """Returns the spring of each joint that has one, by its row, parents first; a later entry of the file
    takes joints from an earlier one.

    :raises MachineError: when the character has no such joint, or a bone has no length; with the line.
    """
    found: dict[int, Spring] = {}
    for name, written in definition.springs.items():
        try:
            joint = character.skeleton.index(name)
        except UnknownNameError as error:
            raise definition.refuse(f"springs: {error}", written.line) from None
        joints = np.flatnonzero(below(character.skeleton.parent, [joint])) if written.below else [joint]
        for row in map(int, joints):
            end = _end(character, row)
            if max(map(abs, end)) > _SHORTEST:
                found[row] = Spring(end, written.half_life, written.frequency, written.weight)
            elif row == joint:
                raise definition.refuse(
                    f"springs: the joint {name} has no bone that could swing", written.line
                )
    return {row: found[row] for row in sorted(found)}


def _end(character: Character, joint: int) -> tuple[float, float, float]:
    """The end of a joint's bone in its own frame: its first child, or as far on as it is from its parent."""
    children = np.flatnonzero(character.skeleton.parent == joint)
    rest = character.bind_pose
    if len(children):
        end = rest.translation[children[0]].astype(np.float64)
    else:
        back = quat.conjugate(rest.rotation[joint].astype(np.float64))
        end = quat.rotate(back, rest.translation[joint].astype(np.float64))
    x, y, z = end.tolist()
    return x, y, z
