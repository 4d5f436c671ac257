"""The weights of a machine's solvers in each state: numbers, parameters, or channels of the pose, which clips
key and expressions set.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import UnknownNameError
from statwalk.machine.compile.machine import Machine
from statwalk.machine.definition.expression_definition import WEIGHT, channel_of_name
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.machine.definition.solver_definition import SolverDefinition
from statwalk.machine.settings import parameter_indices
from statwalk.maths.simd.pose_layout import first_channels

PATHS = {"trans": "translation", "scale": "scale"}


class SolverWeight(NamedTuple):
    """One of the three; -1: no parameter, no channel."""

    number: float = 0.0
    parameter: int = -1
    channel: int = -1
    """of a pose in a `PoseBuffer`"""


def solver_weights(
    character: Character, machine: Machine, definition: MachineDefinition, name: str
) -> list[SolverWeight]:
    """Returns the weight of the solver `name` in each state of all layers: 0 in states above the base; in an
    inner state the weight of the composite state around it.

    :raises MachineError: when the character has no joint or morph target of a channel's name; with the line.
    """
    solver = definition.solvers[name]

    def resolved(written: float | str) -> SolverWeight:
        if not isinstance(written, str):
            return SolverWeight(written)
        if channel := channel_of_name(written):
            try:
                return SolverWeight(channel=_channel(character, *channel))
            except UnknownNameError as error:
                raise definition.refuse(f"solvers: {name}: weight: {error}", solver.line) from None
        return SolverWeight(parameter=parameter_indices(machine, written)[0])

    weights = _by_state(machine, definition, solver)
    return [resolved(written) for written in weights]


def _channel(character: Character, owner: str, channel: str) -> int:
    joints = len(character.skeleton)
    if channel == WEIGHT:
        targets = np.array(character.target(owner), np.int64)
        return int(first_channels("weights", targets, joints)[0])
    kind, _, axis = channel.partition("_")
    first = first_channels(PATHS[kind], np.array([character.skeleton.index(owner)], np.int64), joints)
    return int(first[0]) + "xyz".index(axis)


def _by_state(machine: Machine, definition: MachineDefinition, solver: SolverDefinition) -> list[float | str]:
    if not isinstance(solver.weight, Mapping):
        return [solver.weight] * len(machine.states)
    found: list[float | str] = []
    for row in machine.rows(0):
        name, written = machine.states[row], definition.states[machine.states[row]]
        outer = written.composite
        while name not in solver.weight and outer:
            name, outer = outer, definition.composites[outer].composite
        found.append(solver.weight.get(name, 0.0))
    return found + [0.0] * (len(machine.states) - len(found))
