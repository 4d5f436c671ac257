"""A model whose vertices follow many bones."""

import base64
import json

import numpy as np

VERTICES = 30


def many_bones(influences: int) -> bytes:
    """A .gltf of triangles; each vertex follows `influences` bones, four in a set. The bones stand elsewhere
    than where they were bound: every weight shows.
    """
    random = np.random.default_rng(influences)
    shares = random.uniform(0.5, 1, (VERTICES, influences))
    shares /= shares.sum(1, keepdims=True)
    filled = np.zeros((VERTICES, -(-influences // 4) * 4), "<f4")
    filled[:, :influences] = shares
    joints = np.tile(np.arange(filled.shape[1]) % influences, (VERTICES, 1)).astype("<u2")
    places = random.uniform(0, 1, (VERTICES, 3)).astype("<f4")
    arrays = {"POSITION": (places, 5126, "VEC3")}
    for row in range(filled.shape[1] // 4):
        columns = slice(4 * row, 4 * row + 4)
        arrays[f"JOINTS_{row}"] = joints[:, columns], 5123, "VEC4"
        arrays[f"WEIGHTS_{row}"] = filled[:, columns], 5126, "VEC4"
    return json.dumps(_document(arrays, influences)).encode()


def _document(arrays: dict[str, tuple[np.ndarray, int, str]], bones: int) -> dict:
    """The JSON of a skin with these arrays, and its data."""
    blobs = [np.ascontiguousarray(values).tobytes() for values, _, _ in arrays.values()]
    starts = np.cumsum([0, *map(len, blobs)])[:-1].tolist()
    data = b"".join(blobs)
    places = arrays["POSITION"][0]
    accessors = [
        {"bufferView": k, "componentType": kind, "count": VERTICES, "type": form}
        for k, (_, kind, form) in enumerate(arrays.values())
    ]
    accessors[0] |= {"min": places.min(0).tolist(), "max": places.max(0).tolist()}
    half = np.sqrt(0.5)
    joints = [
        {
            "name": f"bone {k}",
            "translation": [0.1 * k, 0.3 * (k % 3), 0],
            "rotation": [0, 0, half * (k % 2), half],
        }
        for k in range(bones)
    ]
    for joint in joints:
        if joint["rotation"][2] == 0:
            del joint["rotation"]
    attributes = {name: k for k, name in enumerate(arrays)}
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(bones + 1))}],
        "nodes": [*joints, {"name": "fan", "mesh": 0, "skin": 0}],
        "skins": [{"joints": list(range(bones))}],
        "meshes": [{"primitives": [{"attributes": attributes}]}],
        "accessors": accessors,
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": len(blob)}
            for start, blob in zip(starts, blobs, strict=True)
        ],
        "buffers": [{"byteLength": len(data), "uri": "data:;base64," + base64.b64encode(data).decode()}],
    }
