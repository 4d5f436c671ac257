"""Measures loading a skinned GLB of 4 MB: `python benchmarks/load.py`.

statwalk checks the whole file, and packs its clips for sampling. three.js builds its scene. trimesh loads the
mesh, without skin and clips. pygltflib only parses; NumPy then makes a view of every accessor. orjson alone
parses the JSON chunk: no reader in Python can be faster.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
import orjson
import trimesh
from models import figure
from pygltflib import GLTF2
from rounds import Three, least, show
from statwalk.files.gltf import read_model

ROUNDS = 15
GOALS = {"three.js GLTFLoader": 2.0, "trimesh": 5.0, "pygltflib": 150.0}
DTYPES = {5121: "<u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def statwalk_job(data: bytes) -> None:
    """Reads the file, and packs all clips."""
    for clip in read_model(data, "figure").clips.values():
        clip.tracks, clip.base  # noqa: B018 - packed on first use


def pygltflib(path: Path) -> None:
    """Parses the file, and makes a view of every accessor."""
    gltf = GLTF2().load(str(path))
    blob = gltf.binary_blob()
    for accessor in gltf.accessors:
        start = gltf.bufferViews[accessor.bufferView].byteOffset + (accessor.byteOffset or 0)
        np.frombuffer(blob, DTYPES[accessor.componentType], accessor.count * WIDTHS[accessor.type], start)


def main() -> None:
    """Prints the table."""
    data = figure(64_000)
    text = data[20 : 20 + int.from_bytes(data[12:16], "little")]
    with tempfile.TemporaryDirectory() as folder, Three() as three:
        path = Path(folder) / "figure.glb"
        path.write_bytes(data)
        jobs = {
            "statwalk": lambda: statwalk_job(data),
            "orjson.loads of its JSON": lambda: orjson.loads(text) and None,
            "three.js GLTFLoader": three.job("load", path=str(path)),
            "trimesh": lambda: trimesh.load(path) and None,
            "pygltflib": lambda: pygltflib(path),
        }
        seconds = least(jobs, ROUNDS)
    show(f"load {len(data) / 1e6:.1f} MB ({len(text) // 1000} KB of JSON)", seconds, GOALS)


if __name__ == "__main__":
    main()
