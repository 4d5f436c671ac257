"""Measures skinning of positions and normals, four influences a vertex: `python benchmarks/skin.py`.

The peers are the usual code in NumPy and SciPy (weights as a sparse matrix times the joint matrices), and
three.js's loop in Node.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from models import figure
from rounds import Three, least, show
from scipy.sparse import csr_array
from statwalk.files.gltf import read_model

ROUNDS = 12
GOALS = {"NumPy einsum": 22.0, "SciPy CSR": 10.0, "three.js applyBoneTransform": 90.0}


def main() -> None:
    """Prints the tables."""
    with tempfile.TemporaryDirectory() as folder, Three() as three:
        for vertices in (10_000, 100_000):
            path = Path(folder) / f"{vertices}.glb"
            path.write_bytes(figure(vertices))
            measure(three, path, vertices)


def measure(three: Three, path: Path, vertices: int) -> None:
    """Prints the table of one size."""
    character = read_model(path.read_bytes(), "figure")
    part, surface = character.parts[0], character.surface
    pose = character.clip("clip 0").sample(0.3)
    world = np.ascontiguousarray(character.world(pose)[:, :3])
    assert part.joints is not None
    assert part.weights is not None
    joints, weights = part.joints.astype(np.intp), part.weights
    points = np.concatenate([part.positions, np.ones((vertices, 1), np.float32)], axis=1)
    positions, normals = np.empty((2, 3 * vertices), np.float32)
    bounds = np.empty((1, 6), np.float32)
    starts = np.arange(0, joints.size + 1, joints.shape[1])
    sparse = csr_array((weights.ravel(), joints.ravel(), starts), (vertices, len(world)))

    def einsum() -> None:
        blended = np.einsum("vi,virc->vrc", weights, world[joints])
        np.einsum("vrc,vc->vr", blended, points)
        turned = np.einsum("vrc,vc->vr", blended[..., :3], part.normals)
        turned / np.linalg.norm(turned, axis=1, keepdims=True)

    def csr() -> None:
        blended = (sparse @ world.reshape(-1, 12)).reshape(-1, 3, 4)
        np.einsum("vrc,vc->vr", blended, points)
        turned = np.einsum("vrc,vc->vr", blended[..., :3], part.normals)
        turned / np.linalg.norm(turned, axis=1, keepdims=True)

    jobs = {
        "statwalk": lambda: surface.pose_into(world, pose.weights, positions, normals, bounds),
        "NumPy einsum": einsum,
        "SciPy CSR": csr,
        "three.js applyBoneTransform": three.job("skin", path=str(path)),
    }
    seconds = least(jobs, ROUNDS)
    show(
        f"skin {vertices} vertices: statwalk {seconds['statwalk'] / vertices * 1e9:.1f} ns each",
        seconds,
        GOALS,
    )


if __name__ == "__main__":
    main()
