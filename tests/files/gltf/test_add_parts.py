"""A model that gets a digital skin: cameras, lights and foreign extras stay."""

from pathlib import Path

import orjson
import statwalk
from khronos import errors
from statwalk.files.gltf import container, read_model
from tiny_model import document, glb

CHARACTER = """\
model: tiny.glb
digital_skin: |
  #vertices hip
  0 0 0
  0.1 0 0
  #vertices knee #ff0000
  0 0.1 0
  #polygons
  0 1 2
bulges:
  calf: {angle: knee.rotate_z, cubic: [1.5, 0, 0, 0], bone: hip, point: [0, 0, 0], vertices: [1, 4]}
"""


def lit() -> bytes:
    """The tiny model with a camera, a light, and extras of another program."""
    root, binary = document()
    root["cameras"] = [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}]
    root["extensionsUsed"] = ["KHR_lights_punctual"]
    root["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "point", "name": "lamp"}]}}
    root["scenes"][0]["nodes"] += [3, 4]
    root["nodes"].append({"name": "eye", "camera": 0, "extras": {"studio": 1}})
    root["nodes"].append({"name": "lamp", "extensions": {"KHR_lights_punctual": {"light": 0}}})
    root["extras"] = {"studio": {"shot": 7}}
    root["meshes"][0]["extras"] = {"artist": "me"}
    return glb(root, binary)


def made(folder: Path) -> statwalk.Character:
    (folder / "tiny.glb").write_bytes(lit())
    (folder / "tiny.yaml").write_text(CHARACTER)
    character = statwalk.load(folder / "tiny.yaml")
    assert isinstance(character, statwalk.Character)
    return character


def test_cameras_lights_and_foreign_extras_stay(tmp_path: Path) -> None:
    model = made(tmp_path).model_glb
    before, after = (orjson.loads(bytes(container.split(data)[0])) for data in (lit(), model))
    for key in ("cameras", "extensions", "extensionsUsed", "asset"):
        assert after[key] == before[key], key
    assert after["nodes"][3:5] == before["nodes"][3:5]
    assert after["nodes"][:2] == before["nodes"][:2]
    assert after["extras"]["studio"] == {"shot": 7}
    assert after["meshes"][0]["extras"]["artist"] == "me"
    assert after["scenes"][0]["nodes"] == [0, 2, 3, 4, 5]
    assert errors(model) == errors(lit())  # a rotation of length 2, which the tiny model has


def test_the_file_shows_the_digital_skin_and_its_bulge(tmp_path: Path) -> None:
    character = made(tmp_path)
    again = read_model(character.model_glb, "again")
    pose = statwalk.express(character, pose=character.bind_pose).pose
    ours = character.vertices(pose)
    theirs = again.vertices(statwalk.express(again, pose=again.bind_pose).pose)
    assert len(ours) == len(theirs) == 2
    for one, other in zip(ours, theirs, strict=True):
        assert abs(one.positions - other.positions).max() < 1e-6
    assert abs(ours[1].positions[1] - [0.15, 0, 0]).max() < 1e-6  # 1.5 times the offset 0.1 0 0
