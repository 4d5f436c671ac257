"""The hanging chains of a machine file on a character: names become joints and tables (SK4)."""

from __future__ import annotations

from collections.abc import Sequence

from statwalk.character.chain_of_names import chain_joints, ends_at, sensitivities
from statwalk.character.character import Character
from statwalk.errors import ContentError, UnknownNameError
from statwalk.machine.definition.chain_definition import ChainDefinition
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.solve.chains import Chain
from statwalk.solve.hanging import Hanging, kept

SOLVER, TOLERANCE = "fabrik", 1e-6


def hanging_memory(chains: Sequence[Chain], definition: MachineDefinition) -> dict[str, tuple[float, ...]]:
    """Returns the numbers of a new actor in the solvers' memory, by the names of the chains there."""
    return {
        memory_name(name): kept(len(chain.joints))
        for name, chain in zip(definition.chains, chains, strict=True)
    }


def memory_name(chain: str) -> str:
    """Returns the name of a hanging chain in the solvers' memory."""
    return f"chain {chain}"


def hanging_chains(character: Character, definition: MachineDefinition) -> list[Chain]:
    """Returns the joints of each hanging chain of a machine file.

    :raises MachineError: when the character has no such joints, or they are no chain; with the line.
    """
    chains = []
    for name, written in definition.chains.items():
        try:
            joints, _ = chain_joints(character.skeleton, written.joints, SOLVER)
            turns = sensitivities(character.skeleton, written.joints, joints, SOLVER, {})
        except (ContentError, UnknownNameError) as error:
            raise definition.refuse(f"chains: {name}: {error}", written.line) from None
        chains.append(Chain(SOLVER, joints, turns, tolerance=TOLERANCE))
    return chains


def hanging_of(
    character: Character, definition: MachineDefinition, chains: Sequence[Chain], reaching: Sequence[Chain]
) -> list[Hanging]:
    """Returns what the machine file says about its hanging chains; `reaching`: the chains of its solvers. A
    solver that brings the last joint of a hanging chain to a target holds it while it has weight.

    :raises MachineError: when an anchor is neither the first nor the last joint of its chain.
    """
    return [
        _hanging(character, definition, name, written, chain, reaching)
        for (name, written), chain in zip(definition.chains.items(), chains, strict=True)
    ]


def _hanging(
    character: Character,
    definition: MachineDefinition,
    name: str,
    written: ChainDefinition,
    chain: Chain,
    reaching: Sequence[Chain],
) -> Hanging:
    try:
        last = [ends_at(character.skeleton, chain.joints, anchor) for anchor in written.anchors]
    except (ContentError, UnknownNameError) as error:
        raise definition.refuse(f"chains: {name}: {error}", written.line) from None
    end = chain.joints[-1]
    return Hanging(
        joints=len(chain.joints),
        gravity=written.gravity,
        half_life=written.half_life,
        mass=written.mass,
        holds=(not last or False in last, True in last),
        holders=tuple(
            k for k, solver in enumerate(reaching) if solver.joints[-1] == end and not solver.is_moored
        ),
    )
