"""A skin that is put into a model: the file says what the character in memory says, and nothing else is
lost.
"""

import json

import numpy as np
import pytest
import statwalk
from khronos import errors_by_name
from paths import GLTF, needs_assets
from rig_shapes import cylinder, human, mesh
from statwalk.character.character import Character
from statwalk.files.gltf import container, read_model
from statwalk.maths.pose import Pose


def vertices(character: Character, pose: Pose) -> np.ndarray:
    return np.concatenate([part.positions for part in character.vertices(pose)])


def same_in_the_file(character: Character, clip: str) -> Character:
    """The character of the model, whose vertices move as those in memory."""
    read = read_model(character.model_glb, character.name)
    assert read.skeleton.names == character.skeleton.names
    assert list(read.clips) == list(character.clips)
    for time in (0.0, 0.2, 0.9):
        expected = vertices(character, character.clips[clip].sample(time))
        size = max(float(np.ptp(expected, axis=0).max()), 1)
        ours = vertices(read, read.clips[clip].sample(time))
        assert ours == pytest.approx(expected, abs=2e-6 * size)
    return read


def test_a_mesh_of_one_node() -> None:
    character = statwalk.rigged(mesh(*human()), "human")
    same_in_the_file(character, "Bend")
    assert errors_by_name({"human": character.model_glb}) == {"human": []}


def test_a_name_that_is_taken_gets_a_prefix() -> None:
    character = statwalk.rigged(mesh(*cylinder()))
    twice = statwalk.rigged(character)
    assert "rig:Root" in twice.skeleton.names
    assert list(twice.clips) == ["Bend", "Bend 2"]
    same_in_the_file(twice, "Bend 2")


@needs_assets
@pytest.mark.parametrize(
    ("name", "skeleton", "clip"),
    [
        ("Khronos_Fox.glb", "own", "Walk"),
        ("Quaternius_Fox.glb", "mammal", "Bend"),
        ("RobotExpressive.glb", "human", "Bend"),
        ("Kenney_character.glb", "parts", "Bend"),
        ("AnimatedMorphCube.glb", "parts", "Square"),
    ],
)
def test_real_models_keep_all_else(name: str, skeleton: str, clip: str) -> None:
    """Several meshes, several skins, morph targets, textures: what a viewer reads is what was made."""
    source = statwalk.load(GLTF / name)
    character = statwalk.rigged(source, skeleton)
    same_in_the_file(character, clip)
    before, after = (json.loads(bytes(container.split(one.model_glb)[0])) for one in (source, character))
    for key in ("images", "textures", "materials", "cameras"):
        assert after.get(key) == before.get(key)
    assert len(after["animations"]) >= len(before["animations"])
    assert errors_by_name({name: character.model_glb})[name] == []
