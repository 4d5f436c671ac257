"""Measures two-bone with limits: how many targets that the limits allow it reaches, how near it comes to any
target, and how far its joints turn when a target moves by two millimetres: `python benchmarks/limbs.py`.

Limbs of two bones, a metre each, bent by 0.3 radians. The targets are the ends of 2,000 limbs in random poses
within the limits of their two joints, and then 2,000 random places within two metres of the start.
"""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from statwalk.maths.clamp_kinds import CONE, EULER
from statwalk.maths.clamp_table import JointLimit, clamp_table
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.solve.chains import POLE_DIRECTION, Chain
from statwalk.solve.solve_poses import Goal, solve_poses

Floats = NDArray[np.float64]
LIMBS, STEPS, STEP = 2000, 40, 0.002
REACHED = 1e-3
"""metres"""


def _span(low: float, high: float) -> tuple[float, float]:
    return float(np.radians(low)), float(np.radians(high))


STARTS = {
    "round cone": JointLimit(CONE, twist=_span(-60, 60), swing=(_span(-60, 60), _span(-60, 60))),
    "elliptic cone": JointLimit(CONE, twist=_span(-40, 40), swing=(_span(-30, 100), _span(-50, 60))),
    "three angles": JointLimit(EULER, angles=(_span(-30, 100), _span(-40, 40), _span(-50, 60))),
}
MIDDLES = {
    "hinge": JointLimit(EULER, angles=(_span(0, 150), _span(0, 0), _span(0, 0))),
    "three angles": JointLimit(EULER, angles=(_span(0, 150), _span(-10, 10), _span(-10, 10))),
    "cone": JointLimit(CONE, twist=_span(-90, 90), swing=(_span(-80, 80), _span(-80, 80))),
}


def within(limit: JointLimit, chance: np.random.Generator) -> Rotation:
    """Returns random rotations (LIMBS,) within a limit."""
    if limit.kind == EULER:
        return Rotation.from_euler(
            "xyz", np.stack([chance.uniform(*ends, LIMBS) for ends in limit.angles], -1)
        )
    direction, part = chance.uniform(0, 2 * np.pi, LIMBS), np.sqrt(chance.uniform(0, 1, LIMBS))
    swing, twist = np.zeros((LIMBS, 3)), np.zeros((LIMBS, 3))
    for axis, way, (low, high) in zip(
        (0, 2), (np.cos(direction), np.sin(direction)), limit.swing, strict=True
    ):
        swing[:, axis] = part * np.where(way < 0, -way * low, way * high)
    twist[:, 1] = chance.uniform(*limit.twist, LIMBS)
    return Rotation.from_rotvec(swing) * Rotation.from_rotvec(twist)


def solved(target: Floats, limits: dict[int, JointLimit], iterations: int) -> tuple[Floats, Floats]:
    """Returns the rotations (LIMBS, 2, 4) of both joints, and the distances (LIMBS,) from the targets."""
    begin = rest(3)
    begin.translation[1:, 1] = 1
    begin.rotation[1] = Rotation.from_euler("x", 0.3).as_quat()
    buffer = PoseBuffer.of(rest(3), Pose(*(np.repeat(part[None], LIMBS, 0) for part in begin)))
    chain = Chain("two-bone", (0, 1, 2), pole_kind=POLE_DIRECTION, iterations=iterations)
    goal = Goal(target, np.array(1.0), np.array([0.0, 0, -1]), np.array([0.0, 0, 0, 1]))
    found = solve_poses(buffer, np.arange(-1, 2, dtype=np.int32), clamp_table(limits, rest(3)), chain, goal)
    return buffer.poses().rotation[:, :2].astype(float), found.distance.astype(float)


def show(start: str, middle: str) -> None:
    """Measures and prints a pair of limits."""
    chance = np.random.default_rng(3)
    first, second = within(STARTS[start], chance), within(MIDDLES[middle], chance)
    target, limits = (
        first.apply([0, 1, 0]) + (first * second).apply([0, 1, 0]),
        {0: STARTS[start], 1: MIDDLES[middle]},
    )
    once, often = (np.mean(solved(target, limits, count)[1] < REACHED) for count in (1, 16))
    print(
        f"{start:14} {middle:14} reached after 1 iteration {once:6.1%}, after 16 {often:6.1%};"
        f" {turns(target, limits, chance)}"
    )
    anywhere = ways(chance) * 2 * np.cbrt(chance.uniform(size=(LIMBS, 1)))
    missed = solved(anywhere, limits, 16)[1].mean()
    print(f"{'any target':29} missed by {missed:.3f} m on average; {turns(anywhere, limits, chance)}")


def ways(chance: np.random.Generator) -> Floats:
    """Returns random unit vectors (LIMBS, 3)."""
    way: Floats = chance.normal(size=(LIMBS, 3))
    return way / np.linalg.norm(way, axis=1, keepdims=True)


def turns(target: Floats, limits: dict[int, JointLimit], chance: np.random.Generator) -> str:
    """Returns how far the joints turn in each step of targets that move straight."""
    way = ways(chance) * STEP
    path = np.stack([solved(target + way * step, limits, 16)[0] for step in range(STEPS)])
    alike = np.abs((path[1:] * path[:-1]).sum(-1)).min(-1)
    angles = np.degrees(2 * np.arccos(np.minimum(alike, 1)))
    most, rare = np.quantile(angles, (0.99, 0.999))
    return f"turns in degrees: 99 % < {most:.2f}, 99.9 % < {rare:.2f}, over 30: {np.mean(angles > 30):.3%}"


def main() -> None:
    """Prints all pairs of limits."""
    for start, middle in product(STARTS, MIDDLES):
        show(start, middle)


if __name__ == "__main__":
    main()
