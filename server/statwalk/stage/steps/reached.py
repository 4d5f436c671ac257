"""How near the solvers of a machine file came to their targets, as the tick wrote it in their memory."""

from __future__ import annotations

from typing import NamedTuple

from statwalk.maths.arrays import Ints
from statwalk.solve.reach_tables import DISTANCE, SHOWN
from statwalk.stage.state.cast import Cast


class ReachedTarget(NamedTuple):
    """What a solver did in this tick."""

    solver: str
    weight: float
    """0…1 that was shown; by state: eased"""
    distance: float
    """metres from the end to the target; look-at: from the line of sight; 0 without weight"""
    reached: bool
    """whether the distance is within the tolerance; never without weight"""


def reached_targets(cast: Cast, rows: Ints) -> list[tuple[ReachedTarget, ...]]:
    """Returns, for each of some rows of a cast, what each solver did, in the order of the file."""
    solvers, names = cast.role.solvers, tuple(cast.role.definition.solvers)
    columns = solvers.reach.memory
    first = int(solvers.reach.first_chain[0])
    tolerances = solvers.chains.tolerance[first : first + len(names)].tolist()
    weights = cast.solver_memory[rows[:, None], columns + SHOWN].tolist()
    distances = cast.solver_memory[rows[:, None], columns + DISTANCE].tolist()
    return [
        tuple(
            ReachedTarget(name, weight, distance, weight > 0 and distance <= tolerance)
            for name, weight, distance, tolerance in zip(names, *row, tolerances, strict=True)
        )
        for row in zip(weights, distances, strict=True)
    ]
