"""Models that are legal and unusual: points, lines, bones without a mesh, a .gltf with its files."""

import base64
import json
import struct
import zlib

import numpy as np

POINTS, LINES, LINE_LOOP, LINE_STRIP = range(4)
RING = 12


def drawn(mode: int, colour: list[float] | None = None) -> bytes:
    """A .gltf of a standing ring of vertices, two metres high, as points or lines; without a material unless
    it gets a colour.
    """
    turns = np.linspace(0, 2 * np.pi, RING, endpoint=False)
    places = np.stack([np.cos(turns), 1 + np.sin(turns), 0 * turns], -1).astype("<f4")
    root = document(places)
    root["meshes"][0]["primitives"][0]["mode"] = mode
    if colour:
        root["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [*colour, 1]}}]
        root["meshes"][0]["primitives"][0]["material"] = 0
    root["buffers"][0]["uri"] = "data:;base64," + base64.b64encode(places.tobytes()).decode()
    return json.dumps(root).encode()


def document(places: np.ndarray) -> dict:
    """The JSON of a model with one primitive of these vertices; its buffer has no address yet."""
    bounds = {"min": places.min(0).tolist(), "max": places.max(0).tolist()}
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "ring", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(places), "type": "VEC3"} | bounds
        ],
        "bufferViews": [{"buffer": 0, "byteLength": places.nbytes}],
        "buffers": [{"byteLength": places.nbytes}],
    }


def bare_bones() -> bytes:
    """A .gltf of three joints without any mesh."""
    nodes = [{"name": "hip", "children": [1], "translation": [0, 1, 0]}]
    nodes += [{"name": "knee", "children": [2], "translation": [0, -0.5, 0.1]}]
    nodes += [{"name": "foot", "translation": [0, -0.5, -0.1]}]
    root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes}
    return json.dumps(root).encode()


def picture_files() -> dict[str, bytes]:
    """A red square as panel.gltf, which names panel.bin and textures/red dot.png."""
    corners = np.array([[-1, 0, 0], [1, 0, 0], [1, 2, 0], [-1, 2, 0]], "<f4")
    places = corners[[0, 1, 2, 0, 2, 3]]
    uv = np.full((6, 2), 0.5, "<f4")
    root = document(places)
    binary = places.tobytes() + uv.tobytes()
    root["bufferViews"].append({"buffer": 0, "byteOffset": places.nbytes, "byteLength": uv.nbytes})
    root["accessors"].append({"bufferView": 1, "componentType": 5126, "count": 6, "type": "VEC2"})
    root["buffers"] = [{"byteLength": len(binary), "uri": "panel.bin"}]
    root["images"] = [{"uri": "textures/red%20dot.png"}]
    root["textures"] = [{"source": 0}]
    root["materials"] = [
        {"doubleSided": True, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}}
    ]
    root["meshes"][0]["primitives"][0] |= {"material": 0, "attributes": {"POSITION": 0, "TEXCOORD_0": 1}}
    return {
        "panel.gltf": json.dumps(root).encode(),
        "panel.bin": binary,
        "textures/red dot.png": png(255, 0, 0),
    }


def png(red: int, green: int, blue: int) -> bytes:
    """A picture of one pixel."""
    head = struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", head), (b"IDAT", zlib.compress(bytes((0, red, green, blue)))), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks
    )
