"""How near the solvers of a machine file came to their targets, as the tick wrote it in their memory."""

from __future__ import annotations

from typing import NamedTuple

from statwalk.character.role import Role
from statwalk.maths.arrays import Floats
from statwalk.solve.reach_tables import DISTANCE, SHOWN


class ReachedTarget(NamedTuple):
    """What a solver did in this tick."""

    solver: str
    weight: float
    """0…1 that was shown; by state: eased"""
    distance: float
    """metres from the end to the target; look-at: from the line of sight, a direction is a target one
    metre away; 0 without weight
    """
    reached: bool
    """whether the distance is within the tolerance; never without weight"""


def reached_targets(role: Role, memory: Floats) -> list[tuple[ReachedTarget, ...]]:
    """Returns, for each row of solver memory (n, K), what each solver did, in the order of the file."""
    solvers, names = role.solvers, tuple(role.definition.solvers)
    columns = solvers.reach.memory
    tolerances = [solver.tolerance for solver in role.definition.solvers.values()]
    weights = memory[:, columns + SHOWN].tolist()
    distances = memory[:, columns + DISTANCE].tolist()
    return [
        tuple(
            ReachedTarget(name, weight, distance, weight > 0 and distance <= tolerance)
            for name, weight, distance, tolerance in zip(names, *row, tolerances, strict=True)
        )
        for row in zip(weights, distances, strict=True)
    ]
