"""A knight without some of its weapons: by name and by number, against a count by another reader."""

import json
from pathlib import Path

import pygltflib
import pytest
import tiny_model
from paths import GLTF, needs_assets
from statwalk import convert, load
from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.gltf import container, read_model
from statwalk.files.model_facts import mesh_names
from statwalk.files.without_meshes import without_meshes

KNIGHT, ROBOT = GLTF / "KayKit_Knight.glb", GLTF / "RobotExpressive.glb"


def counted(file: Path) -> dict[str, int]:
    """The vertices at each node of a .glb by its name, read by pygltflib."""
    model = pygltflib.GLTF2().load(str(file))
    return {
        node.name: sum(
            model.accessors[one.attributes.POSITION].count for one in model.meshes[node.mesh].primitives
        )
        for node in model.nodes
        if node.mesh is not None
    }


def vertices(character: Character) -> int:
    return sum(len(part.positions) for part in character.parts)


@needs_assets
def test_meshes_are_left_out_by_the_names_of_their_nodes_and_by_their_own(tmp_path: Path) -> None:
    knight = load(KNIGHT, without=["1H_Sword", "Spike_Shield", "Cube.12993"])
    assert isinstance(knight, Character)
    written = tmp_path / "knight.glb"
    convert(knight, written)
    left = {
        name: count
        for name, count in counted(KNIGHT).items()
        if name not in ("1H_Sword", "Spike_Shield", "2H_Sword")
    }
    assert counted(written) == left
    assert vertices(knight) == sum(left.values())
    assert set(mesh_names(knight.model_glb).values()) == set(mesh_names(KNIGHT.read_bytes()).values()) - {
        "Cube.11839",
        "Cylinder.022",
        "Cube.12993",
    }
    assert knight.notes[-1] == "left out as wished: Spike_Shield, 1H_Sword, 2H_Sword"
    assert knight.materials == load(KNIGHT).materials
    assert len(json.loads(bytes(container.split(knight.model_glb)[0]))["images"]) == 1


@needs_assets
@pytest.mark.parametrize("suffix", [".glb", ".x", ".chunk"])
def test_one_primitive_of_a_mesh_is_left_out_by_its_numbers(tmp_path: Path, suffix: str) -> None:
    """Of the head's three primitives the second; the head keeps its morph targets."""
    file = tmp_path / f"robot{suffix}"
    convert(ROBOT, file)
    whole, robot = load(file), load(file, without=["13/1"])
    assert isinstance(whole, Character)
    assert isinstance(robot, Character)
    head = [len(part.positions) for part in whole.parts if part.node == 13]
    assert [len(part.positions) for part in robot.parts if part.node == 13] == [head[0], head[2]]
    assert vertices(robot) == vertices(read_model(robot.model_glb, "again")) == vertices(whole) - head[1]
    assert robot.target_names == whole.target_names


def test_all_meshes_of_a_name_are_left_out() -> None:
    root, binary = tiny_model.document()
    root["meshes"] = [root["meshes"][0] | {"name": name} for name in ("twin", "twin", "third")]
    root["nodes"] += [{"name": "b", "mesh": 1}, {"name": "c", "mesh": 2}]
    root["scenes"][0]["nodes"] += [3, 4]
    left = without_meshes(read_model(tiny_model.glb(root, binary), "x"), ["twin"])
    assert mesh_names(left.model_glb) == {0: "third"}
    assert [part.node for part in left.parts] == [4]


@pytest.mark.parametrize(
    ("without", "words"),
    [
        (["skn"], "no mesh is called 'skn'; did you mean skin[?] There are: skin"),
        (["9/0"], "no mesh is called '9/0'. There are: skin"),
        (["skin"], "every mesh of the character is left out; at least one must stay"),
    ],
)
def test_what_cannot_be_left_out_is_refused(tmp_path: Path, without: list[str], words: str) -> None:
    (tmp_path / "tiny.glb").write_bytes(tiny_model.model())
    with pytest.raises(ContentError, match=words):
        load(tmp_path / "tiny.glb", without=without)


def test_a_machine_keeps_its_meshes() -> None:
    with pytest.raises(ContentError, match="an option of characters, not of machines"):
        load("faq-walker", without=["x"])
