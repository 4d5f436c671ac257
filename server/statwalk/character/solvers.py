"""The solvers of a role: which chains a tick solves, and what they keep from tick to tick."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.character.feet import Foot
from statwalk.character.hanging import hanging_chains, hanging_memory, hanging_of, memory_name
from statwalk.character.joint_limits import limits_of
from statwalk.character.leg_tables import foot_memory, has_leg, leg_chain, leg_tables
from statwalk.character.reach import reach_chains, reach_names, reach_tables
from statwalk.character.role_feet import contacts_in, feet_in
from statwalk.character.solver_memory import SolverMemory
from statwalk.character.springs import springs_on
from statwalk.machine.compile.machine import Machine
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.machine.settings import parameter_indices
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.clamp_table import ClampTable, clamp_table
from statwalk.motion.blend_space import Motion
from statwalk.solve.chains import Chains, chain_tables, limited_joints
from statwalk.solve.foot_tables import (
    DROP,
    DROP_RATE,
    FIT,
    LOWEST_X,
    LOWEST_Y,
    LOWEST_Z,
    OF_ACTOR,
    OF_FIT,
    OF_FOOT,
    OF_GROUND,
    TOOK,
    Y_RATE,
    FootTables,
    X,
    Y,
    Z,
)
from statwalk.solve.hanging import HangingTables, hanging_tables
from statwalk.solve.reach_tables import CARRIED, LAYER, OF_SOLVER, SHOWN, ReachTables
from statwalk.solve.springs import KEPT, Springs, springs_of

CUT = "limits"
"""name of what limits cut in the solvers' memory"""
FOOT_LOCK = "foot lock"
"""name of the foot lock in the solvers' memory"""
UNEVEN_GROUND = "uneven ground"
"""name of what feet need on uneven ground there"""


class Solvers(NamedTuple):
    """What the solvers of a role read; the order of the chains: of feet, of `solvers`, of `chains`."""

    springs: Springs
    legs: FootTables
    chains: Chains
    clamps: ClampTable
    reach: ReachTables
    hanging: HangingTables
    limited: tuple[int, ...]
    """the joints of the chains that have limits; the memory says how far they cut"""
    memory: SolverMemory


def solvers_of(
    character: Character, machine: Machine, definition: MachineDefinition, motions: Sequence[Motion | None]
) -> Solvers:
    """Returns the solvers that a machine file asks for.

    :raises MachineError: when it asks for a foot lock, and the character has no feet with legs; when it
        has ground and no foot lock; when it limits a joint that the character does not have; when a spring's
        joint does not exist or has no bone; when the joints of a solver or a chain do not exist or are no
        chain.
    """
    if definition.ground and not definition.foot_lock:
        line = definition.ground[0].line
        raise definition.refuse("ground: only feet find it; write `foot_lock: true` as well", line)
    every = feet_in(character, definition) if definition.foot_lock else ()
    feet = tuple(foot for foot in every if has_leg(character, foot))
    if definition.foot_lock and not feet:
        raise definition.refuse(f"foot_lock: {_why_no_legs(character, every)}", 0)
    clamps = clamp_table(limits_of(character, definition), character.bind_pose)
    legs_first = [leg_chain(character, foot) for foot in feet]
    reaching = reach_chains(character, machine, definition)
    falling = hanging_chains(character, definition)
    chains = [*legs_first, *reaching, *falling]
    limited = limited_joints(chains, clamps)
    swinging = springs_on(character, definition)
    names = {joint: f"spring {character.skeleton.names[joint]}" for joint in swinging}
    feet_memory = {FOOT_LOCK: foot_memory(len(feet))} if feet else {}
    if feet and definition.ground:
        feet_memory[UNEVEN_GROUND] = (0.0,) * (OF_GROUND + OF_FIT * len(feet))
    memory = SolverMemory(
        feet_memory
        | dict.fromkeys(names.values(), (0.0,) * KEPT)
        | reach_names(definition, reaching)
        | hanging_memory(falling, definition)
        | ({CUT: (0.0,) * len(limited)} if limited else {})
    )
    columns = {joint: memory.first(name) for joint, name in names.items()}
    springs = springs_of(swinging, columns, character.skeleton.parent)
    contacts = contacts_in(character, definition, every) if feet else {}
    ground = np.array([piece.numbers for piece in definition.ground], np.float64).reshape(-1, 7)
    weight = _weight(machine, definition.foot_lock)
    places = 0, memory.first(UNEVEN_GROUND) if UNEVEN_GROUND in feet_memory else -1
    legs = leg_tables(character, feet, contacts, motions, weight, ground, places)
    reach = reach_tables(character, machine, definition, reaching, memory, len(feet))
    hanging = hanging_tables(
        hanging_of(character, definition, falling, reaching),
        len(feet) + len(reaching),
        [memory.first(memory_name(name)) for name in definition.chains],
    )
    notes = {joint: memory.first(CUT) + place for place, joint in enumerate(limited)}
    tables = chain_tables(character.skeleton.parent, chains, clamps, notes)
    return Solvers(springs, legs, tables, clamps, reach, hanging, limited, memory)


def _why_no_legs(character: Character, feet: Sequence[Foot]) -> str:
    names = character.skeleton.names
    for foot in feet:
        if min(foot.hip, foot.knee) >= 0:
            above = int(character.skeleton.parent[foot.ankle])
            carrier = repr(names[above]) if above >= 0 else "no joint"
            return (
                f"the {foot.name} ankle {names[foot.ankle]!r} hangs on {carrier}, but a leg is three joints, "
                "each the child of the one before it: hip, knee, ankle"
            )
    return (
        "the names of the joints tell no feet with legs; name them in the file: "
        "`feet: {left: {hip: JOINT, knee: JOINT, ankle: JOINT}}`"
    )


def forget_feet(solvers: Solvers, values: Floats, rows: Ints) -> Floats:
    """Returns the memory (N, K) in which the feet and the pelvis of some rows are where their motion has
    them: a pose offset that begins takes over what the foot lock had added, and what the solvers of the
    machine file had.
    """
    kept, first = values.copy(), int(solvers.legs.memory[0])
    for foot in range(len(solvers.legs.hip)):
        at = first + OF_ACTOR + foot * OF_FOOT
        kept[rows, at + LOWEST_X] += kept[rows, at + X]
        kept[rows, at + LOWEST_Y] += kept[rows, at + Y]
        kept[rows, at + LOWEST_Z] += kept[rows, at + Z]
        kept[rows, at + X : at + Y_RATE + 1] = 0.0
        kept[rows, first + DROP] = kept[rows, first + DROP_RATE] = 0.0
        if solvers.legs.fit[0] >= 0:
            fit = int(solvers.legs.fit[0]) + OF_GROUND + foot * OF_FIT
            kept[rows, fit + TOOK : fit + TOOK + FIT] = kept[rows, fit : fit + FIT]
    for k, at in enumerate(map(int, solvers.reach.memory)):
        kept[rows, at + CARRIED], kept[rows, at + LAYER] = kept[rows, at + SHOWN], 0.0
        first, turned = at + OF_SOLVER, int(solvers.reach.turned[k])
        kept[rows, first : first + 4 * turned] = (0.0, 0.0, 0.0, 1.0) * turned
    return kept


def _weight(machine: Machine, written: float | str) -> tuple[float, int]:
    """A weight, and the parameter that replaces it or -1."""
    if isinstance(written, str):
        return 0.0, parameter_indices(machine, written)[0]
    return written, -1
