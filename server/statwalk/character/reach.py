"""The solvers of a machine file on a character: names become joints, chains and tables."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.character.chain_of_names import chain_joints, ends_at, sensitivities
from statwalk.character.character import Character
from statwalk.character.motions import masks_of
from statwalk.character.solver_memory import SolverMemory
from statwalk.character.solver_weights import solver_weights
from statwalk.errors import ContentError, UnknownNameError
from statwalk.machine.compile.link import REACHED
from statwalk.machine.compile.machine import Machine
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.machine.definition.solver_definition import SolverDefinition
from statwalk.machine.settings import parameter_indices
from statwalk.maths import vector
from statwalk.maths.columns import locked
from statwalk.motion.layers import Mask
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.model_buffer import JointList
from statwalk.solve.chains import (
    DEFAULT_ITERATIONS,
    FORCE_IN_A_TICK,
    NO_POLE,
    POLE_DIRECTION,
    POLE_POINT,
    Chain,
)
from statwalk.solve.reach_tables import FAR, OF_SOLVER, ReachTables

WHOLE_TURN = 180.0
FORCE_TRAVEL = 0.3
Vector = str | tuple[float, ...] | None
"""a parameter, or the numbers of a vector; None: neither"""


def reach_names(definition: MachineDefinition, chains: Sequence[Chain]) -> dict[str, tuple[float, ...]]:
    """Returns the numbers of a new actor in the solvers' memory, by the names of the solvers there."""
    return {
        _memory_name(name): (0.0,) * OF_SOLVER + (0.0, 0.0, 0.0, 1.0) * _carried(chain)
        for name, chain in zip(definition.solvers, chains, strict=True)
    }


def reach_chains(character: Character, machine: Machine, definition: MachineDefinition) -> list[Chain]:
    """Returns the chain of each solver of a machine file.

    :raises MachineError: when the character has no such joints, or they are no chain; with the line.
    """
    chains = []
    for name, written in definition.solvers.items():
        try:
            chains.append(_chain(character, machine, written))
        except (ContentError, UnknownNameError) as error:
            raise definition.refuse(f"solvers: {name}: {error}", written.line) from None
    return chains


def _chain(character: Character, machine: Machine, written: SolverDefinition) -> Chain:
    skeleton = character.skeleton
    joints, middle = chain_joints(skeleton, written.chain, written.solver)
    x, y, z = vector.unit(np.array(written.forward, np.float64)).tolist()
    is_moored = bool(written.anchor) and ends_at(skeleton, joints, written.anchor)
    return Chain(
        solver=written.solver,
        joints=joints,
        sensitivity=sensitivities(skeleton, written.chain, joints, written.solver, written.sensitivity),
        middle=middle,
        softening=written.softening,
        tolerance=written.tolerance * (FAR if _is_direction(machine, written) else 1.0),
        iterations=written.iterations or _iterations_in_a_tick(written.solver),
        pole_kind=_pole_kind(machine, written),
        forward=(x, y, z),
        turns_end=written.rotation is not None,
        is_moored=is_moored,
        is_carried=written.solver == "force",
    )


def _iterations_in_a_tick(solver: str) -> int:
    return FORCE_IN_A_TICK if solver == "force" else DEFAULT_ITERATIONS[solver]


def _carried(chain: Chain) -> int:
    return len(chain.joints) - 1 if chain.is_carried else 0


def _pole_kind(machine: Machine, written: SolverDefinition) -> int:
    if written.pole is None:
        return NO_POLE
    if isinstance(written.pole, str):
        return POLE_POINT if _kind(machine, written.pole) == "point" else POLE_DIRECTION
    return POLE_DIRECTION


def _is_direction(machine: Machine, written: SolverDefinition) -> bool:
    return _kind(machine, written.target) == "direction"


def _kind(machine: Machine, parameter: str) -> str:
    return machine.parameters[parameter_indices(machine, parameter)[0]].kind


def reach_tables(
    character: Character,
    machine: Machine,
    definition: MachineDefinition,
    chains: Sequence[Chain],
    memory: SolverMemory,
    first_chain: int,
) -> ReachTables:
    """Returns the tables of the solvers with these chains; `first_chain`: the number of the first."""
    solvers = list(definition.solvers.values())
    rest = world_from_local(character.skeleton, character.bind_pose).astype(np.float64)
    is_direction = [_is_direction(machine, solver) for solver in solvers]
    is_measured = [
        is_far or _is_measured(definition, solver)
        for is_far, solver in zip(is_direction, solvers, strict=True)
    ]
    measured = [chain for chain, wanted in zip(chains, is_measured, strict=True) if wanted]
    ends = {joint for chain in measured for joint in (chain.joints[0], chain.joints[-1])}
    joints = JointList.of(character.skeleton, sorted(ends))
    poles = [solver.pole for solver in solvers]
    rotations = [solver.rotation for solver in solvers]
    masks = masks_of(character, definition)
    weights = [solver_weights(character, machine, definition, name) for name in definition.solvers]

    def by_state(rows: list[list[float]], dtype: type[np.generic]) -> NDArray[Any]:
        return np.array(rows, dtype).reshape(len(solvers), len(machine.states))

    return locked(
        ReachTables(
            first_chain=np.array([first_chain], np.int32),
            target=_rows([parameter_indices(machine, each.target) for each in solvers], 3).astype(np.int32),
            in_stage=np.array([solver.space == "stage" for solver in solvers], bool),
            is_direction=np.array(is_direction, bool),
            pole=_written(poles, (0, 0, 0)),
            pole_parameter=_parameters(machine, poles, 3),
            rotation=_written(rotations, (0, 0, 0, 1)),
            rotation_parameter=_parameters(machine, rotations, 4),
            weight_parameter=by_state([[each.parameter for each in row] for row in weights], np.int32),
            weight_channel=by_state([[each.channel for each in row] for row in weights], np.int32),
            weight=by_state([[each.number for each in row] for row in weights], np.float64),
            eagerness=np.array([_eagerness(solver) for solver in solvers], np.float64),
            travel=np.array(
                [-1.0 if (way := _travel(each)) is None else _rate(way) for each in solvers], np.float64
            ),
            cone=np.array([_cone(each) for each in solvers], np.float64).reshape(-1, 2),
            is_measured=np.array(is_measured, bool),
            length=np.array([_length(rest, chain) for chain in chains], np.float64),
            joints=joints.joints,
            parents=joints.parents,
            start=_places(joints, [chain.joints[-1 if chain.is_moored else 0] for chain in chains]),
            end=_places(joints, [chain.joints[0 if chain.is_moored else -1] for chain in chains]),
            covers=np.array([[_moves(mask, chain) for mask in masks] for chain in chains], bool).reshape(
                len(chains), len(masks)
            ),
            memory=np.array([memory.first(_memory_name(name)) for name in definition.solvers], np.int32),
            turned=np.array([_carried(chain) for chain in chains], np.int32),
        )
    )


def _memory_name(solver: str) -> str:
    return f"solver {solver}"


def _rows(rows: Sequence[Sequence[float]], width: int) -> NDArray[np.float64]:
    return np.array(rows, np.float64).reshape(-1, width)


def _written(values: Sequence[Vector], none: tuple[float, ...]) -> NDArray[np.float64]:
    """The numbers of vectors that the file gives; `none` where it names a parameter, or has nothing."""
    return _rows([value if isinstance(value, tuple) else none for value in values], len(none))


def _parameters(machine: Machine, values: Sequence[Vector], width: int) -> NDArray[np.int32]:
    """The parameters of vectors that the file names; -1 where it names none."""
    none = (-1,) * width
    indices = [parameter_indices(machine, name) if isinstance(name, str) else none for name in values]
    return _rows(indices, width).astype(np.int32)


def _is_measured(definition: MachineDefinition, solver: SolverDefinition) -> bool:
    if solver.solver == "look-at":
        return solver.cone_deg < WHOLE_TURN
    return _travel(solver) is not None or bool(definition.chains)


def _travel(solver: SolverDefinition) -> float | None:
    """The seconds in which the end travels; None: it is there immediately."""
    if solver.travel is None and solver.solver == "force":
        return FORCE_TRAVEL
    return solver.travel


def _rate(seconds: float) -> float:
    return REACHED / seconds if seconds > 0 else 0.0


def _cone(solver: SolverDefinition) -> tuple[float, float]:
    angle = math.radians(solver.cone_deg)
    return (-1.0, 0.0) if solver.cone_deg >= WHOLE_TURN else (math.cos(angle), math.sin(angle))


def _eagerness(solver: SolverDefinition) -> float:
    return _rate(solver.ease) if isinstance(solver.weight, Mapping) else 0.0


def _length(rest: NDArray[np.float64], chain: Chain) -> float:
    points = rest[list(chain.joints), :, 3]
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def _places(joints: JointList, wanted: Sequence[int]) -> NDArray[np.int32]:
    """Indices in the list; of joints that it does not have, 0."""
    rows = np.array(wanted, np.int64)
    return np.where(np.isin(rows, joints.joints), joints.joints.searchsorted(rows), 0).astype(np.int32)


def _moves(mask: Mask, chain: Chain) -> bool:
    return bool(np.isin(mask.joints, chain.joints).any())
