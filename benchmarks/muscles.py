"""Measures a digital skin with a bulging muscle: positions and normals of every vertex, from the angle of the
elbow: `python benchmarks/muscles.py`.

The peer is the usual code in NumPy, as the FAQ says it (Q22): the angle, its cubic, the scale factor, the
vertices moved, then turned with their bones; normals likewise. It gets the bones' matrices, as statwalk does.
"""

from __future__ import annotations

import numpy as np
from rounds import least, show
from statwalk.character.bulge_targets import with_bulges
from statwalk.character.character import Character
from statwalk.character.digital_skin import DigitalSkin, with_digital_skin
from statwalk.character.express import express
from statwalk.maths.pose import rest
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.bulge import Bulge

ROUNDS, AROUND, ANGLE = 30, 50, 90.0
BULGE = Bulge(
    "biceps", "lower", "z", (1, 0.001, 0.00004, -0.0000002), "upper", (0.15, 0, 0), (1, 0, 0), (0.1, 0.1, 0.1)
)
GOALS = {"NumPy": 10.0}


def main() -> None:
    """Prints the tables."""
    for vertices in (10_000, 100_000):
        measure(vertices)


def measure(vertices: int) -> None:
    """Prints the table of one size."""
    arm = with_bulges(tube(vertices), [BULGE])
    pose = express(arm, pose=express(arm, f"lower.rotate_z = {ANGLE}").pose).pose
    part, surface = arm.parts[0], arm.surface
    world = np.ascontiguousarray(arm.world(pose)[:, :3])
    assert part.joints is not None
    assert part.normals is not None
    assert part.target_positions is not None
    assert part.target_normals is not None
    bone, inverse = part.joints[:, 0].astype(np.intp), arm.skins[0].inverse_bind
    moves, turns, normals = part.target_positions[0], part.target_normals[0], part.normals
    base = part.positions
    out = np.empty((2, 3 * vertices), np.float32)
    bounds = np.empty((1, 6), np.float32)

    def numpy() -> None:
        weight = np.float32(BULGE.factor(ANGLE) - 1)
        matrices = np.einsum("krc,kcd->krd", world[:, :, :3], inverse)
        matrices[..., 3] += world[..., 3]
        own = matrices[bone]
        np.einsum("vrc,vc->vr", own[..., :3], base + weight * moves) + own[..., 3]
        turned = np.einsum("vrc,vc->vr", own[..., :3], normals + weight * turns)
        turned / np.linalg.norm(turned, axis=1, keepdims=True)

    jobs = {
        "statwalk": lambda: surface.pose_into(world, pose.weights, out[0], out[1], bounds),
        "NumPy": numpy,
    }
    seconds = least(jobs, ROUNDS)
    rate = vertices / seconds["statwalk"] / 1e6
    show(
        f"bulging skin of {vertices} vertices: statwalk {rate:.0f} million vertices a second", seconds, GOALS
    )


def tube(vertices: int) -> Character:
    """Returns an arm of two bones, a digital skin of as many vertices."""
    skeleton, pose = Skeleton(("upper", "lower"), np.array([-1, 0], np.int32)), rest(2)
    pose.translation[1] = 0.3, 0, 0
    rows = vertices // AROUND
    angle = np.tile(np.arange(AROUND) * 2 * np.pi / AROUND, rows)
    x = np.repeat(np.linspace(0, 0.6, rows), AROUND)
    bone = (x > 0.3).astype(np.int64)
    positions = np.stack([x - 0.3 * bone, 0.05 * np.cos(angle), 0.05 * np.sin(angle)], -1)
    quads = [
        (row * AROUND + k, (row + 1) * AROUND + k, (row + 1) * AROUND + (k + 1) % AROUND)
        for row in range(rows - 1)
        for k in range(AROUND)
    ]
    bare = Character("arm", skeleton, np.arange(2, dtype=np.int32), pose)
    return with_digital_skin(bare, DigitalSkin((0, 1), bone, positions, np.ones((vertices, 3)), quads))


if __name__ == "__main__":
    main()
