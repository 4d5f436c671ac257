"""assimp, an independent reader of .x files: its scene as JSON, posed by NumPy."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

needs_assimp = pytest.mark.skipif(shutil.which("assimp") is None, reason="assimp is not installed")


class Scene(NamedTuple):
    """Nodes, parents first: `names`, `parents` and local `matrices` (4, 4); `meshes` and `clips` as assimp
    writes them, and for each mesh the node that carries it.
    """

    names: list
    parents: list
    matrices: list
    meshes: list
    carrier: list
    clips: list


def read(file: Path, folder: Path) -> Scene:
    """assimp's scene of a file."""
    out = folder / "assimp.json"
    command = ["assimp", "export", str(file), str(out), "-fassjson"]
    subprocess.run(command, check=True, capture_output=True, timeout=100)
    root = json.loads(out.read_text())
    scene = Scene(
        [], [], [], root.get("meshes", []), [None] * len(root.get("meshes", [])), root.get("animations", [])
    )
    ready = [(root["rootnode"], -1)]
    while ready:
        node, parent = ready.pop()
        scene.names.append(node["name"])
        scene.parents.append(parent)
        scene.matrices.append(np.array(node["transformation"], float).reshape(4, 4))
        for mesh in node.get("meshes", ()):
            scene.carrier[mesh] = len(scene.names) - 1
        ready += [(child, len(scene.names) - 1) for child in node.get("children", ())]
    return scene


def world(scene: Scene, clip: dict | None = None, seconds: float = 0.0) -> dict[str, np.ndarray]:
    """World matrices by the names of nodes."""
    moved = {channel["name"]: channel for channel in clip["channels"]} if clip else {}
    made: list[np.ndarray] = []
    for name, parent, rest in zip(scene.names, scene.parents, scene.matrices, strict=True):
        local = _at(moved[name], seconds * clip["tickspersecond"]) if clip and name in moved else rest
        made.append(local if parent < 0 else made[parent] @ local)
    return dict(zip(scene.names, made, strict=True))


def _at(channel: dict, ticks: float) -> np.ndarray:
    matrix = np.eye(4)
    turn = _turn(channel["rotationkeys"], ticks)
    matrix[:3, :3] = turn * _lerp(channel["scalingkeys"], ticks)
    matrix[:3, 3] = _lerp(channel["positionkeys"], ticks)
    return matrix


def _lerp(keys: list, ticks: float) -> np.ndarray:
    times, values = np.array([key[0] for key in keys], float), np.array([key[1] for key in keys], float)
    return np.stack([np.interp(ticks, times, column) for column in values.T])


def _turn(keys: list, ticks: float) -> np.ndarray:
    times = np.array([key[0] for key in keys], float)
    turns = Rotation.from_quat([[x, y, z, w] for _, (w, x, y, z) in keys])
    if len(keys) == 1:
        return turns[0].as_matrix()
    return Slerp(times, turns)(np.clip(ticks, times[0], times[-1])).as_matrix()


def vertices(scene: Scene, matrices: dict[str, np.ndarray]) -> np.ndarray:
    """(V, 3) all vertices in space, skinned where a mesh has bones."""
    return np.concatenate([_posed(scene, row, matrices) for row in range(len(scene.meshes))])


def _posed(scene: Scene, row: int, matrices: dict[str, np.ndarray]) -> np.ndarray:
    mesh = scene.meshes[row]
    rest = np.array(mesh["vertices"], float).reshape(-1, 3)
    points = np.concatenate([rest, np.ones((len(rest), 1))], 1)
    if not mesh.get("bones"):
        return (points @ matrices[scene.names[scene.carrier[row]]].T)[:, :3]
    total = np.zeros((len(rest), 4))
    for bone in mesh["bones"]:
        matrix = matrices[bone["name"]] @ np.array(bone["offsetmatrix"], float).reshape(4, 4)
        for vertex, weight in bone["weights"]:
            total[vertex] += weight * (matrix @ points[vertex])
    return total[:, :3] / total[:, 3:]
