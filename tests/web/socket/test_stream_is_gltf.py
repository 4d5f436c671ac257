"""The pose stream is a glTF animation that is still being written: its arrays, put one after the other, are a
valid file.
"""

import numpy as np
import pygltflib
import pytest
from khronos import errors
from statwalk import Character, Stage, load
from statwalk.character.role import Role
from statwalk.files.gltf import read_model
from statwalk.services.publish.pose_message import CastPoses, decode, encode

TICKS = 90
PATHS = {"translation": "VEC3", "rotation": "VEC4", "scale": "VEC3"}


@pytest.fixture(scope="module")
def walker() -> Role:
    role = load("faq-walker")
    assert isinstance(role, Role)
    return role


@pytest.fixture(scope="module")
def received(walker: Role) -> list[CastPoses]:
    """What a viewer gets while the walker sets off."""
    stage = Stage()
    stage.send(stage.add(walker), "FORWARD")
    frames = []
    for _ in range(TICKS):
        stage.step()
        frames.append(decode(encode(stage.frame, 0, stage.head)).casts[0])
    return frames


def append(document: pygltflib.GLTF2, values: np.ndarray, kind: str) -> int:
    """Adds an accessor over `values` as they were received; its number."""
    data = np.ascontiguousarray(values, "<f4").tobytes()
    blob = document.binary_blob() + data
    document.set_binary_blob(blob)
    document.buffers[0].byteLength = len(blob)
    document.bufferViews.append(
        pygltflib.BufferView(buffer=0, byteOffset=len(blob) - len(data), byteLength=len(data))
    )
    limits = {"min": [float(values.min())], "max": [float(values.max())]} if kind == "SCALAR" else {}
    view = len(document.bufferViews) - 1
    document.accessors.append(
        pygltflib.Accessor(
            bufferView=view, componentType=pygltflib.FLOAT, count=len(values), type=kind, **limits
        )
    )
    return len(document.accessors) - 1


@pytest.fixture(scope="module")
def recording(walker: Role, received: list[CastPoses]) -> bytes:
    """The model with one animation whose keys are the stream's frames."""
    document = pygltflib.GLTF2.load_from_bytes(walker.character.model_glb)
    document.set_binary_blob(document.binary_blob() + b"\0" * (-len(document.binary_blob()) % 4))
    times = append(document, np.arange(TICKS, dtype=np.float32) / 60, "SCALAR")
    take = pygltflib.Animation(name="take")
    for joint, node in enumerate(walker.character.node_index.tolist()):
        for path, kind in PATHS.items():
            values = np.stack([getattr(frame, path)[0, joint] for frame in received])
            take.samplers.append(
                pygltflib.AnimationSampler(input=times, output=append(document, values, kind))
            )
            target = pygltflib.AnimationChannelTarget(node=node, path=path)
            take.channels.append(pygltflib.AnimationChannel(sampler=len(take.samplers) - 1, target=target))
    document.animations = [take]
    return b"".join(document.save_to_bytes())


def test_a_recording_is_valid(recording: bytes) -> None:
    assert errors(recording) == []


def test_a_recording_plays_what_was_streamed(recording: bytes, received: list[CastPoses]) -> None:
    character: Character = read_model(recording, "recording", None)
    pose = character.clips["take"].sample(60 / 60)
    np.testing.assert_allclose(pose.rotation, received[60].rotation[0], atol=1e-5)
