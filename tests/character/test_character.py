import builders
import locked_arrays
import numpy as np
import pytest
from statwalk.errors import UnknownNameError
from statwalk.files.gltf import read_model
from tiny_model import POSITIONS, document, glb, model


@pytest.fixture(scope="module")
def tiny():
    return read_model(model(), "tiny")


def test_world_has_a_matrix_for_every_joint(tiny):
    assert tiny.world(tiny.bind_pose).shape == (3, 4, 4)
    assert tiny.world(tiny.bind_pose)[1].tolist() == [[1, 0, 0, 0], [0, 1, 0, 1], [0, 0, 1, 0], [0, 0, 0, 1]]


def test_world_takes_many_poses_at_once(tiny):
    poses = tiny.clips["Bend"].sample(np.linspace(0, 1, 5))
    assert np.array_equal(tiny.world(poses)[3], tiny.world(poses.take(3)))


def test_vertices_at_rest_by_hand(tiny):
    part = tiny.vertices(tiny.bind_pose)[0]
    lifted = POSITIONS + np.array([0, 0, 0.5])  # the morph target at its rest weight
    raised = lifted + np.array([[0, 0, 0], [0, 0.5, 0], [0, 0.75, 0]])  # knee's share of its height of 1
    assert (part.node, part.mesh, part.primitive) == (2, 0, 0)
    assert part.positions == pytest.approx(raised)


def test_vertices_of_a_bent_knee_by_hand(tiny):
    part = tiny.vertices(tiny.clips["Bend"].sample(1.0))[0]
    half_turn = (0.5 * np.array([1, 0, 0.5]) + 0.5 * np.array([-1, 1, 0.5])).tolist()
    assert part.positions[1] == pytest.approx(half_turn, abs=1e-6)


def test_an_unknown_clip_names_those_that_exist(tiny):
    with pytest.raises(UnknownNameError, match="Bend"):
        tiny.clip("Bent")


def test_repairs_are_noted():
    root, binary = document()
    root["nodes"][1]["rotation"] = [0, 0, 0, 2]
    assert read_model(glb(root, binary), "tiny").notes == (
        "node rotations were not of unit length and were normalised",
    )


def test_shared_meshes_are_drawn_once_a_node():
    root, binary = document()
    root["nodes"] += [{"mesh": 0}, {"mesh": 0, "translation": [0, 0, 5], "weights": [0]}]
    root["scenes"][0]["nodes"] += [3, 4]
    character = read_model(glb(root, binary), "tiny")
    parts = character.vertices(character.bind_pose)
    assert [part.node for part in parts] == [2, 3, 4]
    assert [part.positions[0, 2] for part in parts] == [0.5, 0.5, 5.0]
    assert character.parts[1].positions is character.parts[2].positions


def test_its_arrays_cannot_be_written():
    locked_arrays.check(builders.character())


def test_a_character_prints_on_one_line(tiny):
    size = f"{len(tiny.skeleton)} joints, {len(tiny.clips)} clips"
    vertices = sum(len(part.positions) for part in tiny.vertices(tiny.bind_pose))
    assert repr(tiny) == f"Character({tiny.name!r}, {size}, {vertices} vertices)"
