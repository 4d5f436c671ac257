"""DS9 muscles of a face beside the morph targets that a mesh has, and muscles that name their vertices."""

import numpy as np
import pytest
import statwalk
from statwalk.errors import ContentError
from statwalk.files.gltf.read import read_model
from systems.test_ds9 import AT_REST, FACE, PATH, face, on_path, points
from tiny_model import document, glb


def with_own_target():
    """The same triangle, with its morph target `puff`, default weight 0.5, and a clip that keys it 0 to 1."""
    root, binary = document()
    (primitive,) = root["meshes"][0]["primitives"]
    del root["nodes"][2]["skin"], root["skins"]
    for name in ("JOINTS_0", "WEIGHTS_0"):
        del primitive["attributes"][name]
    root["materials"] = [{"name": "skin"}]
    primitive["material"] = 0
    root["meshes"][0]["extras"] = {"targetNames": ["puff"], "artist": "me"}
    channel = {"sampler": 0, "target": {"node": 2, "path": "weights"}}
    root["animations"].append(
        {"name": "Puff", "samplers": [{"input": 7, "output": 7}], "channels": [channel]}
    )
    return glb(root, binary)


def test_a_mesh_keeps_the_targets_that_it_has(tmp_path):
    """The hand computation: the rest, the own target at its default weight 0.5, and the muscle's path."""
    (tmp_path / "tiny.glb").write_bytes(with_own_target())
    (tmp_path / "face.yaml").write_text(FACE)
    character = statwalk.load(tmp_path / "face.yaml")
    assert character.target_names == ("puff", "pull", "pull.2", "pull.3", "lift")
    moved = points(character, pull=0.6)
    np.testing.assert_allclose(moved[1], AT_REST[1] + (0, 0, 0.5) + on_path(0.6), atol=1e-6)
    np.testing.assert_allclose(moved[[0, 2]], AT_REST[[0, 2]] + (0, 0, 0.5), atol=1e-6)
    assert character.clip("Puff").sample(0.5).weights == pytest.approx([0.5, 0, 0, 0, 0])
    both = points(character, puff=0.25, lift=1)
    np.testing.assert_allclose(both[1], AT_REST[1] + (0, 0, 0.65), atol=1e-6)


def test_vertices_may_be_named_by_their_numbers(tmp_path):
    text = FACE.replace("to: [1, 0, 0], radius: 0.5", "vertices: [0, 2-2]")
    character = face(tmp_path, text)
    moved = points(character, pull=0.6)
    np.testing.assert_allclose(moved[[0, 2]], AT_REST[[0, 2]] + on_path(0.6), atol=1e-6)
    np.testing.assert_allclose(moved[1], AT_REST[1], atol=1e-6)
    again = read_model(character.model_glb, "again")
    assert again.muscles == character.muscles
    assert again.muscles["pull"].vertices == {0, 2}


def test_a_radius_takes_away_from_named_vertices(tmp_path):
    text = FACE.replace("to: [1, 0, 0], radius: 0.5", "to: [1, 0.3, 0], radius: 0.5, vertices: [1, 2]")
    moved = points(face(tmp_path, text), pull=1)
    np.testing.assert_allclose(moved[1] - AT_REST[1], (1 - 0.6**2) ** 2 * PATH[3], atol=1e-6)
    np.testing.assert_allclose(moved[2], AT_REST[2], atol=1e-6)


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        ("to: [1, 0, 0], radius: 0.5", "vertices: [9]", "there is no vertex 9; the last is 2"),
        ("to: [1, 0, 0],", "vertices: [1],", "a muscle needs `to`"),
        ("to: [1, 0, 0],", "to: [1, 0, 0], vertices: [1], mirror: up,", "`vertices` has no mirror"),
    ],
)
def test_wrong_vertices_are_refused_with_their_line(tmp_path, old, new, what):
    with pytest.raises(ContentError, match=what) as refused:
        face(tmp_path, FACE.replace(old, new))
    assert refused.value.place == "line 3"


def test_the_name_of_a_target_that_the_mesh_has_is_refused(tmp_path):
    (tmp_path / "tiny.glb").write_bytes(with_own_target())
    (tmp_path / "face.yaml").write_text(FACE.replace("pull", "puff"))
    with pytest.raises(ContentError, match="'puff' exists already") as refused:
        statwalk.load(tmp_path / "face.yaml")
    assert refused.value.place == "line 3"
