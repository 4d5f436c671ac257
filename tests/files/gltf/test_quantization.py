"""KHR_mesh_quantization: the vertices of a mesh in 8 or 16 bits read like those it was made from."""

import khronos
import numpy as np
import pytest
from statwalk.files.gltf import read_model
from statwalk.files.gltf.write import model_glb
from tiny_model import LIFTED, NORMALS, POSITIONS, document, glb, model

KINDS = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123}


def quantized(kinds, normalized=False):
    """The model with whole numbers for its floats, padded to 4 bytes; a rigid mesh on a node that scales them
    back.
    """
    root, binary = document()
    largest = {"i1": 127, "i2": 32767, "u1": 255, "u2": 65535}
    steps = largest[kinds["POSITION"]] if normalized else 100
    for row, values, name in ((0, POSITIONS, "POSITION"), (1, NORMALS, "NORMAL"), (4, LIFTED, "target")):
        scale = largest[kinds[name]] if name == "NORMAL" else steps
        whole = np.rint(values * scale).astype(f"<{kinds[name]}")
        size = -(-whole.shape[1] * whole.itemsize // 4) * 4
        padded = np.zeros((len(whole), size // whole.itemsize), whole.dtype)
        padded[:, :3] = whole
        binary += b"\0" * (-len(binary) % 4)
        root["bufferViews"][row] = {
            "buffer": 0,
            "byteOffset": len(binary),
            "byteLength": padded.nbytes,
            "byteStride": size,
            "target": 34962,
        }
        binary += padded.tobytes()
        entry = {"bufferView": row, "componentType": KINDS[kinds[name]], "count": 3, "type": "VEC3"}
        entry |= {"min": whole.min(axis=0).tolist(), "max": whole.max(axis=0).tolist()}
        root["accessors"][row] = entry | ({"normalized": True} if normalized or name == "NORMAL" else {})
    root["buffers"][0]["byteLength"] = len(binary)
    root |= {"extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"]}
    del root["animations"], root["skins"]
    root["nodes"][2] = {"mesh": 0, "scale": [1 / steps] * 3 if not normalized else [1, 1, 1]}
    return glb(root, binary)


CASES = [
    ({"POSITION": "i2", "NORMAL": "i1", "target": "i2"}, False),
    ({"POSITION": "u1", "NORMAL": "i2", "target": "i1"}, False),
    ({"POSITION": "u2", "NORMAL": "i1", "target": "i2"}, False),
    ({"POSITION": "i2", "NORMAL": "i1", "target": "i2"}, True),
]


@pytest.fixture(params=CASES, ids=["short", "byte", "unsigned short", "normalised"])
def data(request):
    return quantized(*request.param)


def test_the_model_is_valid(data):
    assert khronos.errors(data) == []


def test_positions_normals_and_targets_read_the_same(data):
    ours, plain = read_model(data, "tiny"), read_model(model(), "tiny")
    part = ours.vertices(ours.bind_pose)[0]
    assert part.positions == pytest.approx(POSITIONS + 0.5 * LIFTED, abs=1e-5)
    assert part.normals == pytest.approx(plain.parts[0].normals, abs=1e-5)


def test_a_written_one_needs_no_extension(data):
    written = model_glb(read_model(data, "tiny"))
    assert b"KHR_mesh_quantization" not in written
    assert khronos.errors(written) == []
