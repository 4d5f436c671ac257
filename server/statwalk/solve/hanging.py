"""Chains that hang under gravity (SK4): what a tick reads, and what it keeps.

The joints of a chain are points with masses, their bones rods. In each tick the points fall, anchors stay
where the pose has them, and the rods get their lengths back: their tensions are the solution of a tridiagonal
system (Newton's method for all rods at once), so a long chain is as stiff as a short one.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import log
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.columns import columns, locked
from statwalk.maths.simd.lanes import LANES

SINCE, OF_CHAIN, OF_JOINT = 0, 1, 6
"""of the numbers that a chain keeps: whether it hangs already, 0 or 1; then for each joint its place (3) and
velocity (3), metres in the actor's frame of that tick
"""
OLD, NEW, ROD, UPPER, PULL, FREE = 0, 3 * LANES, 6 * LANES, 9 * LANES, 10 * LANES, 11 * LANES
LINK = 12 * LANES
"""of a joint in the scratch: its place before and after the tick; the vector to the next joint; two columns
of the tridiagonal system; the inverse of its mass, 0 for an anchor
"""


class HangingTables(NamedTuple):
    """C hanging chains."""

    chain: Annotated[NDArray[np.int32], "hanging"]
    """its number in `Chains`"""
    memory: Annotated[NDArray[np.int32], "hanging"]
    """its first column in the solvers' memory"""
    numbers: Annotated[NDArray[np.float64], "hanging, 3"]
    """m/s² of gravity; 1/s by which velocities decay; the mass of the last joint, that of the others is 1"""
    holds: Annotated[NDArray[np.bool_], "hanging, 2"]
    """whether the first and the last joint are anchors"""
    first_holder: Annotated[NDArray[np.int32], "hanging + 1"]
    holder: Annotated[NDArray[np.int32], "holder"]
    """the solvers of the machine file that hold the last joint while they have weight"""


HANGING = columns(HangingTables, readonly=True)
"""the numba type of HangingTables"""


class Hanging(NamedTuple):
    """A hanging chain, as a file gives it; `joints`: how many."""

    joints: int
    gravity: float
    half_life: float
    mass: float
    holds: tuple[bool, bool]
    holders: tuple[int, ...]


def kept(joints: int) -> tuple[float, ...]:
    """Returns the numbers that a new chain of so many joints keeps."""
    return (0.0,) * (OF_CHAIN + OF_JOINT * joints)


def hanging_scratch(joints: int) -> int:
    """Returns how many float32 `hang_block` needs as scratch for chains of at most so many joints."""
    return (4 * LANES + LINK * joints) if joints else 0


def hanging_tables(chains: Sequence[Hanging], first_chain: int, memory: Sequence[int]) -> HangingTables:
    """Returns the tables of hanging chains, which are the last of `Chains` from `first_chain` on."""
    holders = [chain.holders for chain in chains]
    return locked(
        HangingTables(
            chain=np.arange(first_chain, first_chain + len(chains), dtype=np.int32),
            memory=np.array(memory, np.int32),
            numbers=np.array(
                [(chain.gravity, log(2) / chain.half_life, chain.mass) for chain in chains], np.float64
            ).reshape(-1, 3),
            holds=np.array([chain.holds for chain in chains], bool).reshape(-1, 2),
            first_holder=np.cumsum([0, *map(len, holders)]).astype(np.int32),
            holder=np.array(sum(holders, ()), np.int32),
        )
    )
