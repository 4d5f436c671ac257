"""Morph targets that a model gets: what it had stays, for the Khronos validator and for another reader."""

from pathlib import Path

import numpy as np
import orjson
import statwalk
from khronos import errors
from statwalk.files.gltf import container, read_model
from statwalk.files.gltf.add_targets import sparse
from statwalk.files.gltf.builder import Builder
from tiny_model import document, glb

CHARACTER = """\
model: tiny.glb
muscles:
  pull: {vertices: [1], path: [[0.1, 0, 0], [0.2, 0.3, 0], [0.3, 0.3, 0.2]]}
bulges:
  calf: {angle: knee.rotate_z, cubic: [1.5, 0, 0, 0], bone: hip, point: [0, 0, 0], vertices: [1]}
faces: {smile: {pull: 1}}
"""


def keyed(nodes: int = 1) -> bytes:
    """The tiny model, whose unnamed target a clip keys 0 to 1; its mesh on several nodes."""
    root, binary = document()
    channel = {"sampler": 0, "target": {"node": 2, "path": "weights"}}
    values = {key: value for key, value in root["accessors"][7].items() if key not in ("min", "max")}
    root["accessors"].append(values | {"bufferView": len(root["bufferViews"])})
    root["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": 8})
    binary += np.array([0, 1], "<f4").tobytes()
    root["buffers"][0]["byteLength"] = len(binary)
    sampler = {"input": 7, "output": len(root["accessors"]) - 1}
    root["animations"].append({"name": "Puff", "samplers": [sampler], "channels": [channel]})
    for _ in range(1, nodes):
        root["scenes"][0]["nodes"].append(len(root["nodes"]))
        root["nodes"].append({"mesh": 0, "skin": 0})
    return glb(root, binary)


def made(folder: Path, model: bytes, text: str = CHARACTER) -> statwalk.Character:
    (folder / "tiny.glb").write_bytes(model)
    (folder / "tiny.yaml").write_text(text)
    character = statwalk.load(folder / "tiny.yaml")
    assert isinstance(character, statwalk.Character)
    return character


def root_of(model: bytes) -> dict:
    return orjson.loads(bytes(container.split(model)[0]))


def test_the_validator_finds_no_error_more(tmp_path: Path) -> None:
    """The tiny model has one, a rotation of length 2."""
    for nodes in (1, 2):
        assert errors(made(tmp_path, keyed(nodes)).model_glb) == errors(keyed(nodes))


def test_the_model_reads_as_the_character_that_it_was_made_of(tmp_path: Path) -> None:
    character = made(tmp_path, keyed(2))
    again = read_model(character.model_glb, "again")
    assert again.target_names == character.target_names
    assert list(again.clips) == list(character.clips)
    for name, clip in character.clips.items():
        for time in (0.0, 0.4, 1.0):
            ours, theirs = clip.sample(time), again.clips[name].sample(time)
            np.testing.assert_array_equal(ours.weights, theirs.weights)
            for one, other in zip(character.vertices(ours), again.vertices(theirs), strict=True):
                np.testing.assert_allclose(one.positions, other.positions, atol=1e-6)
                np.testing.assert_allclose(one.normals, other.normals, atol=1e-5)


def test_old_columns_keep_their_weights_names_and_keys(tmp_path: Path) -> None:
    root = root_of(made(tmp_path, keyed()).model_glb)
    (mesh,) = root["meshes"]
    assert mesh["extras"]["targetNames"] == ["target_0", "pull", "pull.2", "pull.3", "calf"]
    assert mesh["weights"] == root["nodes"][2]["weights"] == [0.5, 0, 0, 0, 0]
    assert mesh["primitives"][0]["targets"][0]["POSITION"] == 4
    puff = next(entry for entry in root["animations"] if entry["name"] == "Puff")
    sampler = puff["samplers"][puff["channels"][0]["sampler"]]
    assert root["accessors"][sampler["output"]]["count"] == 2 * 5


def test_nodes_share_their_mesh_while_its_targets_have_the_same_names(tmp_path: Path) -> None:
    """Without names, the targets of the two nodes are target_0 and target_1."""
    text = CHARACTER.split("bulges")[0]
    root = root_of(made(tmp_path, keyed(2), text).model_glb)
    assert [mesh["extras"]["targetNames"][0] for mesh in root["meshes"]] == ["target_0", "target_1"]
    original = root_of(keyed(2))
    original["meshes"][0]["extras"] = {"targetNames": ["puff"]}
    named = glb(original, bytes(container.split(keyed(2))[1] or b""))
    assert len(root_of(made(tmp_path, named, text).model_glb)["meshes"]) == 1


def test_a_sparse_accessor_has_only_the_rows_that_are_not_zero() -> None:
    builder = Builder()
    values = np.zeros((9, 3), np.float32)
    values[4] = 1, 2, 3
    accessor = builder.accessors[sparse(builder, values, bounds=True)]
    assert (accessor["sparse"]["count"], accessor["max"]) == (1, [1, 2, 3])
