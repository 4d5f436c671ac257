"""Measures inverse kinematics of 1,000 chains on one thread: two-bone and CCD against three.js's CCDIKSolver,
FABRIK against NumPy over all chains: `python benchmarks/ik.py`.

statwalk's time includes reading the poses, the hierarchy of the chain, and writing local rotations and
distances, but no notes of what limits cut; three.js's the update of its bones; NumPy's the joints' places
alone, without rotations.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack
from copy import copy as copy_of
from statistics import median
from time import perf_counter
from typing import Any, Self

import numpy as np
from peers.fabrik import places_of_fabrik, places_within_cones
from rounds import Job, Node, least, show
from statwalk.maths import quat
from statwalk.maths.clamp_kinds import CONE, EULER
from statwalk.maths.clamp_table import CLAMP_TABLE, JointLimit, clamp_table
from statwalk.maths.packed import packed
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.simd.aligned import copy, zeros
from statwalk.solve import _kernels
from statwalk.solve.chain_lanes import scratch_floats
from statwalk.solve.chains import (
    CHAINS,
    DEFAULT_ITERATIONS,
    POLE,
    POLE_DIRECTION,
    TARGET,
    WEIGHT,
    Chain,
    chain_tables,
    input_rows,
)

CHAINS_SOLVED, JOINTS, ITERATIONS, ROUNDS, BEND = 1000, 10, 10, 25, 0.9
PROCESSES = 9
"""processes of the peer for two bones: V8 compiles its loop well in some and badly in most"""
CCD_ITERATIONS = DEFAULT_ITERATIONS["two-bone"]
"""with limits, two-bone goes on with so many iterations of CCD at most, and the peer makes as many"""
ANGLES = JointLimit(EULER, angles=((-BEND, BEND),) * 3)
CONES = JointLimit(CONE, twist=(-BEND, BEND), swing=((-BEND, BEND), (-BEND, BEND)))


class CcdOfThree(Node):
    """A process with three.js's CCDIKSolver."""

    script = "ccd.mjs"


class Crowd:
    """Straight chains of random bones, and random targets within reach."""

    def __init__(self, joints: int) -> None:
        chance = np.random.default_rng(joints)
        self.joints, self.rest = joints, rest(joints)
        self.offsets = np.zeros((CHAINS_SOLVED, joints, 3))
        self.offsets[:, 1:] = chance.normal(size=(CHAINS_SOLVED, joints - 1, 3)) * 0.1 + (0, 1, 0)
        aim = chance.normal(size=(CHAINS_SOLVED, 3))
        aim[:, 1] = np.abs(aim[:, 1])
        reach = np.linalg.norm(self.offsets, axis=-1).sum(1) * chance.uniform(0.5, 0.85, CHAINS_SOLVED)
        self.targets = aim / np.linalg.norm(aim, axis=1, keepdims=True) * reach[:, None]

    def within_cones(self) -> Self:
        """Returns the same chains with targets that CONES allow: the ends after random turns within them."""
        other, chance = copy_of(self), np.random.default_rng(self.joints + 1)
        turned, other.targets = np.broadcast_to(self.rest.rotation[0], (CHAINS_SOLVED, 4)), self.targets * 0
        for bones in self.offsets[:, 1:].swapaxes(0, 1):
            way = chance.normal(size=(CHAINS_SOLVED, 2))
            way *= (BEND * np.sqrt(chance.uniform(size=CHAINS_SOLVED)) / np.linalg.norm(way, axis=1))[:, None]
            swing = quat.from_rotation_vector(np.insert(way, 1, 0, axis=1))
            twist = quat.from_axis_angle((0, 1, 0), chance.uniform(-BEND, BEND, CHAINS_SOLVED))
            turned = quat.mul(turned, quat.mul(swing, twist))
            other.targets += quat.rotate(turned, bones)
        return other

    def job(self, solver: str, limit: JointLimit | None = None, **options: Any) -> Job:
        """Returns a job that solves all chains from their rest poses, and times the kernel alone."""
        parts = (np.repeat(part[None], CHAINS_SOLVED, 0) for part in self.rest[1:])
        buffer = PoseBuffer.of(self.rest, Pose(self.offsets.astype(np.float32), *parts))
        limits = clamp_table(dict.fromkeys(range(self.joints - 1), limit) if limit else {}, self.rest)
        chain = Chain(solver, tuple(range(self.joints)), tolerance=1e-6, **options)
        tables = packed(chain_tables(np.arange(-1, self.joints - 1), [chain], limits), CHAINS)
        clamps, rows = packed(limits, CLAMP_TABLE), input_rows(len(buffer.values), 1)
        lanes = np.zeros((rows.shape[0] * 16, 3), np.float32)
        lanes[:CHAINS_SOLVED] = self.targets
        rows[:, 0, TARGET : TARGET + 3] = lanes.reshape(-1, 16, 3).transpose(0, 2, 1)
        rows[:, 0, POLE + 2] = 1
        rows[:, 0, WEIGHT] = (np.arange(len(lanes)) < CHAINS_SOLVED).reshape(-1, 16)
        start, scratch = buffer.values.copy(), zeros(scratch_floats(self.joints))
        notes = np.zeros((CHAINS_SOLVED, 0))
        aligned = copy(rows).reshape(rows.shape)

        def run() -> float:
            np.copyto(buffer.values, start)
            begin = perf_counter()
            _kernels.solve(tables.argument, clamps.argument, 0, buffer.values, aligned, scratch, notes)
            return perf_counter() - begin

        return run

    def numpy_fabrik(self, bend: float = 0.0) -> Job:
        """Returns a job of FABRIK over all chains; within cones of `bend` radians, unless that is 0."""
        offsets, targets = self.offsets.astype(np.float32), self.targets.astype(np.float32)

        def run() -> None:
            if bend:
                places_within_cones(offsets, targets, ITERATIONS, bend)
            else:
                places_of_fabrik(offsets, targets, ITERATIONS)

        return run


def three_job(node: CcdOfThree, crowd: Crowd, iteration: int, limit: float) -> Job:
    """Returns a job of three.js; the chains are sent once."""
    name = f"{crowd.joints}-{iteration}-{limit}"
    offsets, targets = crowd.offsets.tolist(), crowd.targets.tolist()
    node.job("ccd", crowd=name, offsets=offsets, targets=targets, iteration=iteration, limit=limit)()
    return node.job("ccd", crowd=name)


def table(title: str, jobs: dict[str, Job], goals: dict[str, float]) -> None:
    """Measures and prints one table."""
    seconds = least(jobs, ROUNDS)
    show(f"{title}: {seconds['statwalk'] / CHAINS_SOLVED * 1e9:.1f} ns a chain", seconds, goals)


def two_bone_table(title: str, limb: Crowd, limit: JointLimit | None, iteration: int) -> None:
    """Measures and prints a table of two bones: the peer in its median process, and in its best one."""
    bend = BEND if limit else 0
    with ExitStack() as open_nodes:
        nodes = [open_nodes.enter_context(CcdOfThree()) for _ in range(PROCESSES)]
        jobs = {
            f"process {number}": three_job(node, limb, iteration, bend) for number, node in enumerate(nodes)
        }
        ours = limb.job("two-bone", limit, pole_kind=POLE_DIRECTION, iterations=iteration)
        seconds = least({"statwalk": ours} | jobs, ROUNDS)
    ordered, peer = sorted(seconds[name] for name in jobs), f"CCDIKSolver, {PROCESSES} processes"
    shown = {"statwalk": seconds["statwalk"], f"{peer}: median": median(ordered), f"{peer}: best": ordered[0]}
    nanoseconds = seconds["statwalk"] / CHAINS_SOLVED * 1e9
    title = f"two-bone, pole{title}, peer: {iteration} iterations"
    show(f"{title}: {nanoseconds:.1f} ns a chain", shown, {f"{peer}: median": 150})


def main() -> None:
    """Prints the tables."""
    limb, chain, ccd = Crowd(3), Crowd(JOINTS), {"iterations": ITERATIONS}
    free: Callable[..., Job] = chain.job
    two_bone_table("", limb, None, 1)
    for iteration in (CCD_ITERATIONS, 1):
        two_bone_table(", cones that allow the targets", limb.within_cones(), CONES, iteration)
        two_bone_table(", cones that allow no target", limb, CONES, iteration)
    with CcdOfThree() as node:
        peer = f"CCDIKSolver, {ITERATIONS} iterations"
        free_ccd = {"statwalk": free("ccd", **ccd), peer: three_job(node, chain, ITERATIONS, 0)}
        table(f"CCD of {JOINTS} joints", free_ccd, {peer: 80})
        bound = {"statwalk": free("ccd", ANGLES, **ccd), "statwalk, cones": free("ccd", CONES, **ccd)}
        bound[peer] = three_job(node, chain, ITERATIONS, BEND)
        table(f"CCD of {JOINTS} joints, limits of three angles", bound, {peer: 80})
        fabrik = {"statwalk": free("fabrik", **ccd), "NumPy, places": chain.numpy_fabrik()}
        table(f"FABRIK of {JOINTS} joints, {ITERATIONS} iterations", fabrik, {"NumPy, places": 50})
        cones = {"statwalk": free("fabrik", CONES, **ccd), "NumPy, cones": chain.numpy_fabrik(BEND)}
        cones["NumPy, places, no limits"] = chain.numpy_fabrik()
        table(f"FABRIK of {JOINTS} joints, {ITERATIONS} iterations, cones", cones, {"NumPy, cones": 50})


if __name__ == "__main__":
    main()
