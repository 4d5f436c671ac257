"""Writes body and motions as one binary glTF file."""

import struct
from pathlib import Path

import numpy as np
import pygltflib as gl
import statwalk
from curves import Array
from mesh.body import MATERIALS, Body, inverse_bind, more_translation
from moves.motion import Motion
from numpy.typing import NDArray
from skeleton import INDEX, MORE, NAMES, PARENT, rest_translation

FLOAT, BYTE, SHORT = 5126, 5121, 5123
BLINK = ((-0.10, 0.0), (-0.02, 1.0), (0.02, 1.0), (0.16, 0.0))
"""seconds from a blink, and how far the lids are closed"""
LID_DEG = 50.0
"""a lid's turn that closes the eye"""
KINDS = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class Writer:
    """Collects accessors over one buffer."""

    def __init__(self) -> None:
        self.file = gl.GLTF2(asset=gl.Asset(version="2.0", generator="machines/faq-walker/make"))
        self.blob = bytearray()
        self.written: dict[bytes, int] = {}

    def add(
        self, rows: NDArray[np.generic], component: int, *, target: int | None = None, bounds: bool = False
    ) -> int:
        """Append rows (N,) or (N, n) and return their accessor."""
        width = 1 if rows.ndim == 1 else rows.shape[1]
        data = np.ascontiguousarray(rows).tobytes()
        self.file.bufferViews.append(
            gl.BufferView(buffer=0, byteOffset=len(self.blob), byteLength=len(data), target=target)
        )
        self.blob.extend(data + b"\0" * (-len(data) % 4))
        accessor = gl.Accessor(
            bufferView=len(self.file.bufferViews) - 1,
            componentType=component,
            count=len(rows),
            type=KINDS[width],
        )
        if bounds:
            table = rows.reshape(len(rows), -1)
            accessor.min, accessor.max = [float(v) for v in table.min(0)], [float(v) for v in table.max(0)]
        self.file.accessors.append(accessor)
        return len(self.file.accessors) - 1

    def turns(self, rows: Array) -> int:
        """Append rotations (N, 4) as normalized 16-bit integers, half as long as floats: a hand at the end of
        an arm is off by less than 0.1 mm.
        """
        self.file.accessors[at := self.add(np.round(rows * 32767).astype(np.int16), 5122)].normalized = True
        return at

    def floats(self, rows: Array, **how: bool | int | None) -> int:
        """Append rows as 32-bit floats; the same rows are written once."""
        numbers = rows.astype(np.float32)
        key = repr((numbers.shape, how)).encode() + numbers.tobytes()
        if key not in self.written:
            self.written[key] = self.add(numbers, FLOAT, **how)  # type: ignore[arg-type]
        return self.written[key]


def _add_body(out: Writer, body: Body) -> None:
    primitives = []
    for name, faces in body.parts.items():
        used, indices = np.unique(faces, return_inverse=True)
        surface = gl.PbrMetallicRoughness(metallicFactor=0.0, roughnessFactor=MATERIALS[name][1])
        out.file.materials.append(gl.Material(name=name, pbrMetallicRoughness=surface))
        at = out.add(indices.reshape(-1).astype(np.uint16), SHORT, target=34963)
        primitives.append(
            gl.Primitive(
                attributes=_attributes(out, body, used), indices=at, material=len(out.file.materials) - 1
            )
        )
    out.file.meshes.append(gl.Mesh(name="Body", primitives=primitives))
    matrices = np.swapaxes(inverse_bind(body.places), 1, 2).reshape(-1, 16)
    joints = [*range(len(NAMES)), *range(len(NAMES) + 1, len(NAMES) + 1 + len(MORE))]
    out.file.skins.append(
        gl.Skin(name="Body", joints=joints, skeleton=0, inverseBindMatrices=out.floats(matrices))
    )


def _attributes(out: Writer, body: Body, used: NDArray[np.int64]) -> gl.Attributes:
    light = np.concatenate([body.colours[used], np.ones((len(used), 1))], axis=1)
    colours = out.add(np.round(light * 65535).astype(np.uint16), SHORT, target=34962)
    out.file.accessors[colours].normalized = True
    return gl.Attributes(
        POSITION=out.floats(body.points[used], target=34962, bounds=True),
        NORMAL=out.floats(_unit32(body.normals[used]), target=34962),
        COLOR_0=colours,
        JOINTS_0=out.add(body.joints[used], BYTE, target=34962),
        WEIGHTS_0=out.floats(body.weights[used], target=34962),
    )


def _unit32(vectors: Array) -> Array:
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def _add_nodes(out: Writer, rotation: Array, root: Array, body: Body) -> None:
    """The skeleton in a first pose, the skinned body beside it, then the joints that no motion moves."""
    places = rest_translation()
    places[0] = root
    first = len(NAMES) + 1
    hanging: dict[str, list[int]] = {name: [] for name in NAMES}
    for row, parent in enumerate(MORE.values(), first):
        hanging[parent].append(row)
    for index, name in enumerate(NAMES):
        children = [child for child, parent in enumerate(PARENT) if parent == index]
        turn = [float(v) for v in rotation[index]]
        at = [float(v) for v in places[index]]
        out.file.nodes.append(
            gl.Node(name=name, translation=at, rotation=turn, children=[*children, *hanging[name]])
        )
    out.file.nodes.append(gl.Node(name="Body", mesh=0, skin=0))
    for name, place in zip(MORE, more_translation(body.places), strict=True):
        out.file.nodes.append(gl.Node(name=name, translation=[float(v) for v in place]))
    out.file.scenes.append(gl.Scene(name="faq-walker", nodes=[0, len(NAMES)]))
    out.file.scene = 0


def _add_motion(out: Writer, motion: Motion) -> None:
    times, rotation, root = motion.frames()
    clip = gl.Animation(name=motion.name, samplers=[], channels=[])
    at = out.floats(times, bounds=True)
    tracks = [
        (INDEX["Root"], "translation", root),
        *((joint, "rotation", rotation[:, joint]) for joint in range(len(NAMES))),
    ]
    for joint, path, values in tracks:
        output = out.turns(values) if path == "rotation" else out.floats(values)
        clip.samplers.append(gl.AnimationSampler(input=at, output=output, interpolation="LINEAR"))
        target = gl.AnimationChannelTarget(node=joint, path=path)
        clip.channels.append(gl.AnimationChannel(sampler=len(clip.samplers) - 1, target=target))
    if motion.blinks:
        _add_blinks(out, clip, motion)
    out.file.animations.append(clip)


def _add_blinks(out: Writer, clip: gl.Animation, motion: Motion) -> None:
    """The lids, in channels of their own."""
    marks = [
        (0.0, 0.0),
        *((at + lag, shut) for at in motion.blinks for lag, shut in BLINK),
        (motion.duration, 0.0),
    ]
    times, shut = np.array(marks).T
    half = np.radians(LID_DEG) / 2 * shut
    turns = np.stack([np.sin(half), np.zeros(len(half)), np.zeros(len(half)), np.cos(half)], axis=-1)
    clip.samplers.append(
        gl.AnimationSampler(
            input=out.floats(times, bounds=True), output=out.turns(turns), interpolation="LINEAR"
        )
    )
    for row, name in enumerate(MORE, len(NAMES) + 1):
        if name.endswith(".lid"):
            target = gl.AnimationChannelTarget(node=row, path="rotation")
            clip.channels.append(gl.AnimationChannel(sampler=len(clip.samplers) - 1, target=target))


def write_glb(path: Path, body: Body, motions: list[Motion]) -> None:
    """Write the character with its level of detail; the nodes stand as in the first frame of the first
    motion.
    """
    out = Writer()
    _add_body(out, body)
    _, rotation, root = motions[0].frames()
    _add_nodes(out, rotation[0], root[0], body)
    for motion in motions:
        _add_motion(out, motion)
    out.file.buffers.append(gl.Buffer(byteLength=len(out.blob)))
    text = out.file.to_json(separators=(",", ":"), indent=None).encode()
    text += b" " * (-len(text) % 4)
    binary = bytes(out.blob)
    total = 12 + 8 + len(text) + 8 + len(binary)
    head = struct.pack("<4sII", b"glTF", 2, total) + struct.pack("<I4s", len(text), b"JSON") + text
    path.write_bytes(head + struct.pack("<I4s", len(binary), b"BIN\0") + binary)
    path.write_bytes(statwalk.with_detail(statwalk.load(path)).model_glb)
