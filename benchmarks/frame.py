"""Measures a posed frame as a complete GLB with 5,000 skinned vertices: `python benchmarks/frame.py`.

From joint matrices to the bytes of the file: statwalk, pygltflib after a skin in NumPy, three.js's skin and
exporter. Also the peers with posed vertices, which then only write the file while statwalk still skins; and
statwalk from the pose on, with the skeleton.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from models import figure
from pygltflib import GLTF2, Accessor, Attributes, Buffer, BufferView, Mesh, Node, Primitive, Scene
from rounds import Three, least, show
from statwalk.character.character import Character
from statwalk.files.gltf import read_model
from statwalk.files.gltf.template import FrameTemplate, PosedCast, actor_matrices
from statwalk.skin.primitive import Part

ROUNDS = 25
GOALS = {
    "NumPy skin, pygltflib": 25.0,
    "pygltflib alone": 25.0,
    "three.js skin, GLTFExporter": 35.0,
    "GLTFExporter alone": 35.0,
}


def pygltflib(part: Part, indices: np.ndarray) -> bytes:
    """Returns the vertices as a GLB from a new document, as users of pygltflib write it."""
    arrays = (indices, part.positions, part.normals)
    blobs = [np.ascontiguousarray(array).tobytes() for array in arrays]
    starts = np.cumsum([0, *map(len, blobs)]).tolist()
    gltf = GLTF2(
        scene=0,
        scenes=[Scene(nodes=[0])],
        nodes=[Node(mesh=0)],
        meshes=[Mesh(primitives=[Primitive(attributes=Attributes(POSITION=1, NORMAL=2), indices=0)])],
        accessors=[
            Accessor(bufferView=0, componentType=5123, count=len(indices), type="SCALAR"),
            Accessor(
                bufferView=1,
                componentType=5126,
                count=len(part.positions),
                type="VEC3",
                min=part.positions.min(axis=0).tolist(),
                max=part.positions.max(axis=0).tolist(),
            ),
            Accessor(bufferView=2, componentType=5126, count=len(part.positions), type="VEC3"),
        ],
        bufferViews=[
            BufferView(buffer=0, byteOffset=start, byteLength=len(blob), target=34962 if row else 34963)
            for row, (start, blob) in enumerate(zip(starts, blobs, strict=False))
        ],
        buffers=[Buffer(byteLength=starts[-1])],
    )
    gltf.set_binary_blob(b"".join(blobs))
    return b"".join(gltf.save_to_bytes())


def einsum(character: Character, world: np.ndarray) -> Part:
    """Returns the figure's only part under joint matrices (J,3,4), skinned in plain NumPy."""
    part = character.parts[0]
    blended = np.einsum("vi,virc->vrc", part.weights, world[part.joints])
    positions = np.einsum("vrc,vc->vr", blended[..., :3], part.positions) + blended[..., 3]
    turned = np.einsum("vrc,vc->vr", blended[..., :3], part.normals)
    return Part(0, 0, 0, positions, turned / np.linalg.norm(turned, axis=1, keepdims=True))


def main() -> None:
    """Prints the table."""
    data = figure(5_000)
    character = read_model(data, "figure")
    poses = character.clip("clip 0").sample(np.array([0.3]))
    template, cast = FrameTemplate([(character, 1)]), PosedCast(poses, np.zeros((1, 3)), np.zeros(1))
    matrices, posed = actor_matrices(character, cast), character.vertices(poses.take(0))[0]
    indices = np.asarray(character.parts[0].indices, np.uint16)
    with tempfile.TemporaryDirectory() as folder, Three() as three:
        path = Path(folder) / "figure.glb"
        path.write_bytes(data)
        seconds = least(
            {
                "statwalk": lambda: template.filled(1, "00ff", [matrices], [poses.weights]) and None,
                "statwalk, skeleton too": lambda: template.frame(1, "00ff", [cast]) and None,
                "NumPy skin, pygltflib": lambda: (
                    pygltflib(einsum(character, matrices[0, 1:]), indices) and None
                ),
                "three.js skin, GLTFExporter": three.job("frame", path=str(path)),
                "pygltflib alone": lambda: pygltflib(posed, indices) and None,
                "GLTFExporter alone": three.job("frame", path=str(path), posed=True),
            },
            ROUNDS,
        )
    show(
        f"frame of {len(posed.positions)} vertices, {len(template.frame(1, '', [cast])) // 1000} KB",
        seconds,
        GOALS,
    )


if __name__ == "__main__":
    main()
