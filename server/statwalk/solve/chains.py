"""The inverse kinematics chains of a character, as tables that kernels read; inputs and outputs of a solve.

A chain is a row of joints, each the child of the one before it, from its start to its end (the effector).
Its input rows are floats of sixteen actors:

    target      3   a point in model space, metres
    pole        3   two-bone: the direction from the chain's start, or the point in model space, towards which
                    the middle joint bends; zero: it bends as it does now
    weight      1   0 (the pose stays, bit for bit) … 1 (the solution)
    rotation    4   the end's rotation in model space, for chains with `turns_end`

and its output rows

    distance    1   metres from the end to the target afterwards; look-at: from the line of sight; 0 where the
                    weight is 0
    iterations  1   that were made; 0 where the weight is 0
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.clamp_table import ClampTable
from statwalk.maths.columns import columns, locked
from statwalk.maths.simd.lanes import LANES

SOLVERS = ("two-bone", "ccd", "fabrik", "force", "look-at")
TWO_BONE, CCD, FABRIK, FORCE, LOOK_AT = range(len(SOLVERS))
NO_POLE, POLE_DIRECTION, POLE_POINT = range(3)
TARGET, POLE, WEIGHT, ROTATION, DISTANCE, ITERATIONS, ROWS = 0, 3, 6, 7, 11, 12, 13
"""rows of a chain's inputs and outputs: sixteen floats each"""
LONGEST_CHAIN = 256
"""joints of a chain"""
DEFAULT_ITERATIONS = {"two-bone": 16, "ccd": 256, "fabrik": 512, "force": 2000, "look-at": 8}
"""enough for all targets within reach of the ground truth; chains stop at their targets, most far earlier"""
FORCE_IN_A_TICK = 64
"""of a force in a machine file: it goes on in the next tick"""
MOST_ITERATIONS = 10_000


@dataclass(frozen=True)
class Chain:
    """One chain; joints are rows of the skeleton."""

    solver: str
    """one of SOLVERS"""
    joints: tuple[int, ...]
    """from start to end without a gap, at least two; look-at: at least one"""
    sensitivity: tuple[float, ...] = ()
    """0 (the joint stays) … 1 (it turns as much as the solver wants) for each joint; default 1"""
    middle: int = 1
    """two-bone: the index in `joints` of the joint that bends"""
    hinge: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """two-bone: the axis about which the middle joint bends, in the frame of the first joint; zero: as it
    bends
    """
    softening: float = 0.0
    """metres before full stretch from which the chain eases towards it, 0 or more"""
    tolerance: float = 1e-4
    """metres from the target at which a solver stops, above 0"""
    iterations: int = 16
    """at most, 1 or more; two-bone needs none without limits"""
    pole_kind: int = NO_POLE
    """NO_POLE, POLE_DIRECTION or POLE_POINT"""
    forward: tuple[float, float, float] = (0.0, 0.0, 1.0)
    """look-at: the line of sight in the frame of the last joint, unit length"""
    gain: float = 1.0
    """force: radians of a step for a force as long as the chain, shared by the joints, above 0"""
    is_carried: bool = False
    """force: whether the solver begins with the turns at TURNED of its scratch, and leaves them there"""
    turns_end: bool = False
    """whether the end gets the input `rotation`; otherwise it keeps its rotation from its parent"""
    is_moored: bool = False
    """whether the end is the anchor: it stays where it is, the start comes to the target, and the root of the
    skeleton moves; otherwise the start stays
    """


class Chains(NamedTuple):
    """The chains of a character, with the joints of all of them in rows one after the other."""

    solver: Annotated[NDArray[np.int32], "chain"]
    first: Annotated[NDArray[np.int32], "chain + 1"]
    """a chain's first row"""
    joint: Annotated[NDArray[np.int32], "row"]
    sensitivity: Annotated[NDArray[np.float32], "row"]
    first_ancestor: Annotated[NDArray[np.int32], "chain + 1"]
    ancestor: Annotated[NDArray[np.int32], "ancestor"]
    """the ancestors of a chain's start, parents first"""
    middle: Annotated[NDArray[np.int32], "chain"]
    hinge: Annotated[NDArray[np.float32], "chain, xyz"]
    softening: Annotated[NDArray[np.float32], "chain"]
    tolerance: Annotated[NDArray[np.float32], "chain"]
    iterations: Annotated[NDArray[np.int32], "chain"]
    pole_kind: Annotated[NDArray[np.int32], "chain"]
    forward: Annotated[NDArray[np.float32], "chain, xyz"]
    gain: Annotated[NDArray[np.float32], "chain"]
    is_carried: Annotated[NDArray[np.bool_], "chain"]
    turns_end: Annotated[NDArray[np.bool_], "chain"]
    is_moored: Annotated[NDArray[np.bool_], "chain"]
    top: Annotated[NDArray[np.int32], "chain"]
    """the joint without a parent above a chain's start"""
    note: Annotated[NDArray[np.int32], "row"]
    """the column of `keep` that says how far the joint's limits cut its last turn; -1: none"""
    is_noted: Annotated[NDArray[np.bool_], "chain"]
    """whether a joint of the chain has a column in `note`"""
    is_free: Annotated[NDArray[np.bool_], "chain"]
    """whether no joint that turns has limits or a sensitivity below 1"""


CHAINS = columns(Chains, readonly=True)
"""the numba type of Chains"""


def chain_tables(
    parent: Ints, chains: Sequence[Chain], limits: ClampTable, notes: Mapping[int, int] | None = None
) -> Chains:
    """Returns the tables of the chains of a skeleton with these parents (J,) and limits; `notes`: the column
    of `keep` for each joint whose clamp is noted.
    """
    ancestors = [_ancestors(parent, chain.joints[0]) for chain in chains]
    joints = [chain.joints for chain in chains]
    sensitivity = [chain.sensitivity or (1.0,) * len(chain.joints) for chain in chains]
    return locked(
        Chains(
            solver=np.array([SOLVERS.index(chain.solver) for chain in chains], np.int32),
            first=_starts(joints),
            joint=np.array(sum(joints, ()), np.int32),
            sensitivity=np.array(sum(sensitivity, ()), np.float32),
            first_ancestor=_starts(ancestors),
            ancestor=np.array(sum(ancestors, ()), np.int32),
            middle=np.array([chain.middle for chain in chains], np.int32),
            hinge=np.array([chain.hinge for chain in chains], np.float32).reshape(-1, 3),
            softening=np.array([chain.softening for chain in chains], np.float32),
            tolerance=np.array([chain.tolerance for chain in chains], np.float32),
            iterations=np.array([chain.iterations for chain in chains], np.int32),
            pole_kind=np.array([chain.pole_kind for chain in chains], np.int32),
            forward=np.array([chain.forward for chain in chains], np.float32).reshape(-1, 3),
            gain=np.array([chain.gain for chain in chains], np.float32),
            is_carried=np.array([chain.is_carried for chain in chains], bool),
            turns_end=np.array([chain.turns_end for chain in chains], bool),
            is_moored=np.array([chain.is_moored for chain in chains], bool),
            top=np.array([top_of(parent, chain.joints[0]) for chain in chains], np.int32),
            note=np.array([(notes or {}).get(joint, -1) for joint in sum(joints, ())], np.int32),
            is_noted=np.array([not set(chain.joints).isdisjoint(notes or {}) for chain in chains], bool),
            is_free=np.array([_is_free(chain, limits) for chain in chains], bool),
        )
    )


def _is_free(chain: Chain, limits: ClampTable) -> bool:
    """Two-bone: only the limits of the two joints that turn count."""
    if chain.solver == "two-bone":
        return bool((limits.row[[chain.joints[0], chain.joints[chain.middle]]] < 0).all())
    return min((1.0, *chain.sensitivity[:-1])) == 1 and bool((limits.row[[*chain.joints[:-1]]] < 0).all())


def limited_joints(chains: Sequence[Chain], limits: ClampTable) -> tuple[int, ...]:
    """Returns the joints of the chains that have limits, in ascending order."""
    joints = {joint for chain in chains for joint in chain.joints}
    return tuple(sorted(joint for joint in joints if limits.row[joint] >= 0))


def cut_angle(noted: Floats) -> Floats:
    """Returns the radians by which limits cut turns, from what solvers note in their memory."""
    angles: Floats = 2 * np.arcsin(np.sqrt(np.clip(noted, 0, 1)))
    return angles


def joints_between(parent: Ints, start: int, end: int) -> tuple[int, ...]:
    """Returns the joints from `start` to its descendant `end`; empty if `end` does not descend from it."""
    joints = (*_ancestors(parent, end), end)
    return joints[joints.index(start) :] if start in joints else ()


def top_of(parent: Ints, joint: int) -> int:
    """Returns the joint without a parent above a joint, or itself."""
    return (*_ancestors(parent, joint), joint)[0]


def input_rows(blocks: int, chains: int) -> NDArray[np.float32]:
    """Returns (B, C, ROWS, LANES) inputs and outputs of chains: zeros, with the identity as rotations."""
    rows = np.zeros((blocks, chains, ROWS, LANES), np.float32)
    rows[:, :, ROTATION + 3] = 1
    return rows


def _ancestors(parent: Ints, joint: int) -> tuple[int, ...]:
    above: list[int] = []
    while (joint := int(parent[joint])) >= 0:
        above.append(joint)
    return tuple(above[::-1])


def _starts(rows: Sequence[tuple[int, ...]]) -> NDArray[np.int32]:
    return np.cumsum([0, *map(len, rows)]).astype(np.int32)
