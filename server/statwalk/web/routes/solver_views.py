"""The solvers and the hanging chains of a machine file as the API shows them."""

from __future__ import annotations

from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.web.schemas.machine import ChainView, SolverView


def solver_views(definition: MachineDefinition) -> list[SolverView]:
    """Returns the solvers of a machine, in the order in which they work."""
    return [
        SolverView(
            name=name,
            solver=solver.solver,
            start=solver.chain[0],
            end=solver.chain[-1],
            anchor=solver.anchor or solver.chain[0],
            target=solver.target,
            pole=solver.pole if isinstance(solver.pole, str) else None,
            space=solver.space,
            weight=solver.weight if isinstance(solver.weight, float | str) else dict(solver.weight),
            grab=solver.grab,
        )
        for name, solver in definition.solvers.items()
    ]


def chain_views(definition: MachineDefinition) -> list[ChainView]:
    """Returns the hanging chains of a machine."""
    return [
        ChainView(
            name=name,
            start=chain.joints[0],
            end=chain.joints[-1],
            anchors=list(chain.anchors or chain.joints[:1]),
        )
        for name, chain in definition.chains.items()
    ]
