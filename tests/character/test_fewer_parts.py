"""Parts that are left out take along what belongs to them alone; all else stays as it was."""

from dataclasses import replace

import numpy as np
import pytest
import tiny_model
from statwalk.character.character import Character
from statwalk.character.fewer_parts import with_parts
from statwalk.errors import ContentError
from statwalk.files.gltf import read_model
from statwalk.files.gltf.write import model_glb
from statwalk.machine.definition.expression_lines import read_lines


def twins() -> Character:
    """Two meshes, each with a morph target that rests at its own weight: `smile` at 0.5, `frown` at 0.25. The
    clip Bend also moves `smile` from 0 to 1 in its second; the clip Smile does nothing else.
    """
    root, binary = tiny_model.document()
    (mesh,) = root["meshes"]
    root["meshes"] = [
        mesh | {"extras": {"targetNames": ["smile"]}},
        mesh | {"extras": {"targetNames": ["frown"]}, "weights": [0.25]},
    ]
    root["nodes"].append({"name": "other", "mesh": 1})
    root["scenes"][0]["nodes"].append(3)
    keys, (bend,) = {"input": 7, "output": 7}, root["animations"]
    smiles = {"sampler": 0, "target": {"node": 2, "path": "weights"}}
    bend["samplers"].append(keys)
    bend["channels"].append(smiles | {"sampler": 1})
    root["animations"].append({"name": "Smile", "samplers": [keys], "channels": [smiles]})
    return read_model(tiny_model.glb(root, binary), "twins")


@pytest.mark.parametrize(
    ("kept", "names", "rest", "half"), [(0, ("smile",), 0.5, 0.5), (1, ("frown",), 0.25, 0.25)]
)
def test_weights_stay_with_their_mesh(kept: int, names: tuple[str], rest: float, half: float) -> None:
    whole = twins()
    fewer = with_parts(whole, [kept])
    for character in (fewer, read_model(model_glb(fewer), "again")):
        assert character.target_names == names
        assert character.bind_pose.weights.tolist() == [rest]
        assert {name: clip.duration for name, clip in character.clips.items()} == {"Bend": 1, "Smile": 1}
        for name, clip in character.clips.items():
            pose, before = clip.sample(0.5), whole.clips[name].sample(0.5)
            assert pose.weights.tolist() == [half]
            np.testing.assert_array_equal(pose.rotation, before.rotation)
            (drawn,) = character.vertices(pose)
            np.testing.assert_allclose(drawn.positions, whole.vertices(before)[kept].positions, atol=1e-6)


def test_nodes_that_share_a_mesh_may_lose_different_primitives() -> None:
    root, binary = tiny_model.document()
    root["meshes"][0]["primitives"] *= 2
    root["nodes"].append({"name": "other", "mesh": 0, "skin": 0})
    root["scenes"][0]["nodes"].append(3)
    whole = read_model(tiny_model.glb(root, binary), "pair")
    fewer = with_parts(whole, [1, 2, 3])
    again = read_model(model_glb(fewer), "again")
    for character in (fewer, again):
        places = [(part.node, part.mesh, part.primitive) for part in character.parts]
        assert places == [(2, 0, 0), (3, 1, 0), (3, 1, 1)]
        assert character.bind_pose.weights.tolist() == [0.5, 0.5]


def test_a_target_that_an_expression_moves_keeps_its_mesh() -> None:
    moved = replace(twins(), expressions=read_lines([(1, "smile.weight = knee.rotate_x / 90")], ()))
    assert len(with_parts(moved, [0]).expressions) == 1
    with pytest.raises(ContentError, match=r"a mesh must stay, because .* no morph target is called 'smile'"):
        with_parts(moved, [1])
