"""A small valid glTF model, written by hand: a skinned triangle on two joints with a morph target and a clip.

Tests change it.
"""

import base64
import json
import struct

import numpy as np

POSITIONS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4")
NORMALS = np.array([[0, 0, 1]] * 3, "<f4")
JOINTS = np.array([[0, 1, 0, 0]] * 3, "u1")
WEIGHTS = np.array([[1, 0, 0, 0], [0.5, 0.5, 0, 0], [0.25, 0.75, 0, 0]], "<f4")
LIFTED = np.array([[0, 0, 1]] * 3, "<f4")
INVERSE_BIND = np.array([np.eye(4), np.eye(4)], "<f4")
INDICES = np.array([0, 1, 2, 0], "<u2")
TIMES = np.array([0, 1], "<f4")
ROTATIONS = np.array([[0, 0, 0, 1], [0, 0, 2, 0]], "<f4")  # the second one of length 2
ARRAYS = [
    POSITIONS,
    NORMALS,
    JOINTS,
    WEIGHTS,
    LIFTED,
    INVERSE_BIND.reshape(2, 16),
    INDICES[:3],
    TIMES,
    ROTATIONS,
]
KINDS = {(): "SCALAR", (3,): "VEC3", (4,): "VEC4", (16,): "MAT4"}
COMPONENTS = {"<f4": 5126, "|u1": 5121, "<u2": 5123}


def document() -> tuple[dict, bytearray]:
    """The JSON and the binary data of the model."""
    binary, views, accessors = bytearray(), [], []
    for array in ARRAYS:
        binary += b"\0" * (-len(binary) % 4)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": array.nbytes})
        kind, component = KINDS[array.shape[1:]], COMPONENTS[array.dtype.str]
        accessors.append(
            {"bufferView": len(views) - 1, "componentType": component, "count": len(array), "type": kind}
        )
        binary += array.tobytes()
    accessors[0] |= {"min": [0, 0, 0], "max": [1, 1, 0]}
    accessors[4] |= {"min": [0, 0, 1], "max": [0, 0, 1]}
    accessors[7] |= {"min": [0], "max": [1]}
    attributes = {"POSITION": 0, "NORMAL": 1, "JOINTS_0": 2, "WEIGHTS_0": 3}
    primitive = {"attributes": attributes, "indices": 6, "targets": [{"POSITION": 4}]}
    root = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0, 2]}],
        "nodes": [
            {"name": "hip", "children": [1]},
            {"name": "knee", "translation": [0, 1, 0]},
            {"name": "skin", "mesh": 0, "skin": 0},
        ],
        "meshes": [{"primitives": [primitive], "weights": [0.5]}],
        "skins": [{"joints": [0, 1], "inverseBindMatrices": 5}],
        "animations": [
            {
                "name": "Bend",
                "samplers": [{"input": 7, "output": 8}],
                "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}],
            }
        ],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(binary)}],
    }
    return root, binary


def glb(root: dict, binary: bytes) -> bytes:
    """A GLB of any JSON and binary data."""
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    binary = bytes(binary) + b"\0" * (-len(binary) % 4)
    body = (
        struct.pack("<II", len(text), 0x4E4F534A)
        + text
        + struct.pack("<II", len(binary), 0x004E4942)
        + binary
    )
    return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def robot() -> bytes:
    """The model with the joints and clips that the documents' examples name; Walking takes 0.958 s, each
    other clip 1 s.
    """
    root, binary = document()
    root["nodes"][0]["name"], root["nodes"][1]["name"] = "Hips", "Shoulder.R"
    binary += b"\0" * (-len(binary) % 4)
    walking = np.array([0, 23 / 24], "<f4")
    root["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": walking.nbytes})
    binary += walking.tobytes()
    times = root["accessors"][7] | {"bufferView": len(root["bufferViews"]) - 1, "max": [float(walking[1])]}
    root["accessors"].append(times)
    root["buffers"][0]["byteLength"] = len(binary)
    (clip,) = root["animations"]
    root["animations"] = [
        clip | {"name": name, "samplers": [{"input": 9 if name == "Walking" else 7, "output": 8}]}
        for name in (
            "Idle",
            "Walking",
            "Running",
            "Jump",
            "No",
            "Wave",
            "Death",
            "Standing",
            "Punch",
            "Dance",
        )
    ]
    return glb(root, binary)


def changed(pointer: str, value: object) -> bytes:
    """The model with the value at a JSON pointer replaced (or, for None, removed)."""
    root, binary = document()
    *path, last = [int(key) if key.isdigit() else key for key in pointer.split("/")[1:]]
    entry = root
    for key in path:
        entry = entry[key]
    if value is None:
        del entry[last]
    else:
        entry[last] = value
    return glb(root, binary)


def model() -> bytes:
    """The model as a GLB."""
    return glb(*document())


def gltf(uri: str | None = None) -> bytes:
    """The model as a .gltf with its buffer in a data: address, or at `uri`."""
    root, binary = document()
    root["buffers"][0]["uri"] = (
        uri or "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    )
    return json.dumps(root).encode()
