"""Measures skinning of positions and normals, four influences a vertex: `python benchmarks/skin.py`.

The peers are the usual code in NumPy and SciPy (weights as a sparse matrix times the joint matrices), and
three.js's loop in Node. The dual quaternions' peer in NumPy blends and applies them; both get the bones'
matrices, and NumPy their rotations too, from SciPy, outside its time.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
from models import figure
from rounds import Three, least, show
from scipy.sparse import csr_array
from scipy.spatial.transform import Rotation
from statwalk.files.gltf import read_model
from statwalk.maths.arrays import Floats
from statwalk.skin.crowd import CrowdSkin
from statwalk.skin.primitive import Primitive

ROUNDS = 12
GOALS = {"NumPy einsum": 22.0, "SciPy CSR": 10.0, "three.js applyBoneTransform": 90.0}
CROWD, CROWD_GOALS = 64, {"SciPy CSR, one actor": 50.0, "SciPy CSR with cofactors, one actor": 50.0}
DUAL_GOALS = {"NumPy": 22.0}


def main() -> None:
    """Prints the tables."""
    with tempfile.TemporaryDirectory() as folder, Three() as three:
        for vertices in (10_000, 100_000):
            path = Path(folder) / f"{vertices}.glb"
            path.write_bytes(figure(vertices))
            measure(three, path, vertices)
            measure_dual(path, vertices)
        path = Path(folder) / "crowd.glb"
        path.write_bytes(figure(5_000))
        measure_crowd(path, 5_000)


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

    def einsum() -> None:
        blended = np.einsum("vi,virc->vrc", weights, world[joints])
        np.einsum("vrc,vc->vr", blended, points)
        turned = np.einsum("vrc,vc->vr", blended[..., :3], part.normals)
        turned / np.linalg.norm(turned, axis=1, keepdims=True)

    jobs = {
        "statwalk": lambda: surface.pose_into(world, pose.weights, positions, normals, bounds),
        "NumPy einsum": einsum,
        "SciPy CSR": sparse_skin(part, world),
        "three.js applyBoneTransform": three.job("skin", path=str(path)),
    }
    seconds = least(jobs, ROUNDS)
    show(
        f"skin {vertices} vertices: statwalk {seconds['statwalk'] / vertices * 1e9:.1f} ns each",
        seconds,
        GOALS,
    )


def sparse_skin(part: Primitive, world: Floats, *, cofactors: bool = False) -> Callable[[], None]:
    """Returns a job that skins a part with its weights as a sparse matrix; normals by the blended matrices,
    or by their cofactors, as statwalk does, so that they stay right where bones stretch.
    """
    assert part.joints is not None
    assert part.weights is not None
    points = np.concatenate([part.positions, np.ones((len(part.positions), 1), np.float32)], axis=1)
    starts = np.arange(0, part.joints.size + 1, part.joints.shape[1])
    entries = part.weights.ravel(), part.joints.ravel().astype(np.intp), starts
    sparse = csr_array(entries, (len(points), len(world)))

    def csr() -> None:
        blended = (sparse @ world.reshape(-1, 12)).reshape(-1, 3, 4)
        np.einsum("vrc,vc->vr", blended, points)
        turned = np.einsum(
            "vrc,vc->vr", cofactors_of(blended) if cofactors else blended[..., :3], part.normals
        )
        turned / np.linalg.norm(turned, axis=1, keepdims=True)

    return csr


def cofactors_of(matrices: Floats) -> Floats:
    """Returns the cofactors (V,3,3) of the left part of matrices (V,3,4)."""
    rows = np.ascontiguousarray(matrices[..., :3].transpose(1, 2, 0))
    after, before = rows[[1, 2, 0]], rows[[2, 0, 1]]
    crossed = after[:, [1, 2, 0]] * before[:, [2, 0, 1]] - after[:, [2, 0, 1]] * before[:, [1, 2, 0]]
    return crossed.transpose(2, 0, 1)


def measure_crowd(path: Path, vertices: int) -> None:
    """Prints the table of one mesh in the poses of CROWD actors; the peer poses one actor."""
    character = read_model(path.read_bytes(), "figure")
    times = np.linspace(0, 1, CROWD)
    rows = [character.clip("clip 0").sample(float(time)) for time in times]
    world = np.stack([character.world(pose)[:, :3] for pose in rows]).astype(np.float32)
    weights = np.stack([pose.weights for pose in rows])
    skin = CrowdSkin(character.surface)
    out = skin.room(CROWD)
    part, one = character.parts[0], np.empty((2, 3 * vertices), np.float32)
    bounds = np.empty((1, 6), np.float32)
    jobs = {
        "statwalk": lambda: skin.pose(world, weights, out),
        "statwalk, one actor": lambda: character.surface.pose_into(world[0], weights[0], *one, bounds),
        "SciPy CSR, one actor": sparse_skin(part, world[0]),
        "SciPy CSR with cofactors, one actor": sparse_skin(part, world[0], cofactors=True),
    }
    seconds = least(jobs, ROUNDS)
    seconds["statwalk"] /= CROWD
    share = seconds["statwalk"] / vertices * 1e9
    show(f"crowd of {CROWD}, {vertices} vertices: statwalk {share:.2f} ns each", seconds, CROWD_GOALS)


def measure_dual(path: Path, vertices: int) -> None:
    """Prints the table of dual quaternions of one size."""
    character = read_model(path.read_bytes(), "figure").skinned("dual-quaternion")
    part, surface = character.parts[0], character.surface
    pose = character.clip("clip 0").sample(0.3)
    world = np.ascontiguousarray(character.world(pose)[:, :3])
    assert part.joints is not None
    assert part.weights is not None
    joints, weights = part.joints.astype(np.intp), part.weights
    real = Rotation.from_matrix(world[..., :3]).as_quat().astype(np.float32)
    dual = dual_parts(world[..., 3], real)
    positions, normals = np.empty((2, 3 * vertices), np.float32)
    bounds = np.empty((1, 6), np.float32)

    def numpy() -> None:
        turns = real[joints]
        same = np.einsum("vic,vc->vi", turns, turns[:, 0]) < 0
        shares = np.where(same, -weights, weights)
        q = np.einsum("vi,vic->vc", shares, turns)
        d = np.einsum("vi,vic->vc", shares, dual[joints])
        length = np.linalg.norm(q, axis=1, keepdims=True)
        q, d = q / length, d / length
        axis, w = q[:, :3], q[:, 3:]
        shift = 2 * (w * d[:, :3] - d[:, 3:] * axis + np.cross(axis, d[:, :3]))
        spun(axis, w, part.positions) + shift
        turned = spun(axis, w, part.normals)
        turned / np.linalg.norm(turned, axis=1, keepdims=True)

    jobs = {
        "statwalk": lambda: surface.pose_into(world, pose.weights, positions, normals, bounds),
        "NumPy": numpy,
    }
    seconds = least(jobs, ROUNDS)
    share = seconds["statwalk"] / vertices * 1e9
    show(f"dual quaternions {vertices} vertices: statwalk {share:.1f} ns each", seconds, DUAL_GOALS)


def dual_parts(translation: Floats, real: Floats) -> Floats:
    """Returns half the products of translations (K,3) and rotations (K,4)."""
    vector = real[:, 3:] * translation + np.cross(translation, real[:, :3])
    scalar = -np.einsum("kc,kc->k", translation, real[:, :3])
    return np.concatenate([vector, scalar[:, None]], axis=1) / 2


def spun(axis: Floats, w: Floats, vectors: Floats | None) -> Floats:
    """Returns vectors (V,3) turned by unit quaternions."""
    bent = np.cross(axis, vectors)
    return np.asarray(vectors + 2 * (w * bent + np.cross(axis, bent)))


if __name__ == "__main__":
    main()
