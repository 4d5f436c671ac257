import json

import numpy as np
import pytest
from statwalk.errors import ModelError
from statwalk.files.gltf import read_model
from tiny_model import LIFTED, POSITIONS, ROTATIONS, WEIGHTS, changed, document, glb, gltf, model


def test_every_node_is_a_joint():
    character = read_model(model(), "tiny")
    assert character.skeleton.names == ("hip", "knee", "skin")
    assert character.skeleton.parent.tolist() == [-1, 0, -1]


def test_node_index_maps_back_when_children_come_first():
    root, binary = document()
    root["nodes"] = [{"name": "child"}, {"name": "parent", "children": [0]}]
    root["scenes"] = [{"nodes": [1]}]
    del root["skins"], root["animations"]
    character = read_model(glb(root, binary), "tiny")
    assert [
        (name, int(node)) for name, node in zip(character.skeleton.names, character.node_index, strict=True)
    ] == [
        ("parent", 1),
        ("child", 0),
    ]


def test_unnamed_and_repeated_names_are_made_unique():
    root, binary = document()
    root["nodes"] = [{}, {"name": "a"}, {"name": "a"}, {"name": "a 2"}, {"name": "node 0"}]
    del root["skins"], root["animations"], root["scenes"], root["scene"]
    assert read_model(glb(root, binary), "tiny").skeleton.names == ("node 0 2", "a", "a 3", "a 2", "node 0")


def test_unnamed_and_repeated_clips_are_made_unique():
    root, binary = document()
    bend = root["animations"][0]
    root["animations"] = [{**bend, "name": "Walk"}, {**bend, "name": ""}, {**bend, "name": "Walk"}]
    assert list(read_model(glb(root, binary), "tiny").clips) == ["Walk", "clip 1", "Walk 2"]


def test_a_matrix_is_taken_apart():
    mirrored_turn = [0, -2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1]
    pose = read_model(changed("/nodes/1/matrix", mirrored_turn), "tiny").bind_pose
    character = read_model(changed("/nodes/1/matrix", mirrored_turn), "tiny")
    assert character.world(pose)[1] == pytest.approx(np.reshape(mirrored_turn, (4, 4)).T, abs=1e-6)


def test_hierarchies_may_be_thousands_deep():
    root, binary = document()
    depth = 4000
    root["nodes"] = [{"children": [row + 1], "translation": [0, 1, 0]} for row in range(depth - 1)] + [
        {"translation": [0, 1, 0]}
    ]
    root["scenes"] = [{"nodes": [0]}]
    del root["skins"], root["animations"]
    character = read_model(glb(root, binary), "deep")
    assert character.world(character.bind_pose)[-1, 1, 3] == depth


def test_rotation_keys_are_brought_to_unit_length():
    pose = read_model(model(), "tiny").clips["Bend"].sample(1.0)
    assert pose.rotation[1] == pytest.approx(ROTATIONS[1] / 2)


def test_missing_inverse_bind_matrices_are_identities():
    skin = read_model(changed("/skins/0/inverseBindMatrices", None), "tiny").skins[0]
    assert np.array_equal(skin.inverse_bind, np.broadcast_to(np.eye(4)[:3], (2, 3, 4)))


def test_a_wrong_skeleton_hint_changes_nothing():
    right, hinted = read_model(model(), "tiny"), read_model(changed("/skins/0/skeleton", 2), "tiny")
    assert np.array_equal(
        right.vertices(right.bind_pose)[0].positions, hinted.vertices(hinted.bind_pose)[0].positions
    )


def test_the_skinned_node_itself_does_not_move_its_mesh():
    still, moved = read_model(model(), "tiny"), read_model(changed("/nodes/2/translation", [9, 9, 9]), "tiny")
    assert np.array_equal(
        still.vertices(still.bind_pose)[0].positions, moved.vertices(moved.bind_pose)[0].positions
    )


def test_a_mesh_outside_the_scene_is_not_drawn():
    assert read_model(changed("/scenes/0/nodes", [0]), "tiny").parts == ()


def test_a_glb_keeps_its_bytes():
    assert read_model(model(), "tiny").model_glb == model()


def test_a_gltf_reads_like_the_glb():
    left, right = read_model(model(), "tiny"), read_model(gltf(), "tiny")
    assert np.array_equal(
        left.vertices(left.bind_pose)[0].positions, right.vertices(right.bind_pose)[0].positions
    )


def test_a_gltf_is_packed_into_a_glb_that_reads_the_same():
    character = read_model(gltf(), "tiny")
    again = read_model(character.model_glb, "tiny")
    assert np.array_equal(
        character.clips["Bend"].sample(0.5).rotation, again.clips["Bend"].sample(0.5).rotation
    )


def test_unknown_extensions_and_materials_pass_through_the_packing():
    root = json.loads(gltf())
    root |= {
        "extensionsUsed": ["XX_odd"],
        "extensions": {"XX_odd": {"deep": [1]}},
        "materials": [{"name": "m", "extras": {"k": 2}}],
    }
    size = int.from_bytes(
        (packed := read_model(json.dumps(root).encode(), "tiny").model_glb)[12:16], "little"
    )
    found = json.loads(packed[20 : 20 + size])
    assert (found["extensions"], found["materials"]) == (root["extensions"], root["materials"])


def test_files_beside_the_model_are_read(tmp_path):
    (tmp_path / "body data.bin").write_bytes(bytes(document()[1]))
    assert len(read_model(gltf("body%20data.bin"), "tiny", tmp_path).parts) == 1


@pytest.mark.parametrize(
    "uri",
    [
        "../secret.bin",
        "/etc/passwd",
        "file:///etc/passwd",
        "http://localhost/x",
        "%2e%2e/secret.bin",
        "a\\b",
        ".",
    ],
)
def test_no_other_place_is_read(tmp_path, uri):
    (tmp_path / "secret.bin").write_bytes(bytes(document()[1]))
    (tmp_path / "inside").mkdir()
    with pytest.raises(ModelError) as caught:
        read_model(gltf(uri), "tiny", tmp_path / "inside")
    assert caught.value.place == "/buffers/0/uri"


def test_a_link_that_leads_out_of_the_folder_is_not_followed(tmp_path):
    (tmp_path / "secret.bin").write_bytes(bytes(document()[1]))
    (tmp_path / "inside").mkdir()
    (tmp_path / "inside" / "link.bin").symlink_to(tmp_path / "secret.bin")
    with pytest.raises(ModelError):
        read_model(gltf("link.bin"), "tiny", tmp_path / "inside")


def test_an_image_that_cannot_be_had_is_noted_and_replaced():
    root = json.loads(gltf())
    root |= {"images": [{"uri": "../../etc/passwd"}], "textures": [{"source": 0}]}
    character = read_model(json.dumps(root).encode(), "tiny")
    assert any("image is left out" in note for note in character.notes)
    assert b"passwd" not in character.model_glb


def test_a_joint_without_weight_may_be_any_number():
    root, binary = document()
    binary[root["bufferViews"][2]["byteOffset"] + 1] = (
        200  # the second joint of the first vertex, whose weight is 0
    )
    odd, right = read_model(glb(root, binary), "odd"), read_model(model(), "tiny")
    poses = [character.clips["Bend"].sample(0.5) for character in (odd, right)]
    assert np.array_equal(odd.vertices(poses[0])[0].positions, right.vertices(poses[1])[0].positions)


@pytest.mark.parametrize("times", [[-1, 1], [1, 0], [0, np.nan], [0, np.inf]])
def test_key_times_that_do_not_rise_from_zero_are_refused(times):
    root, binary = document()
    start = root["bufferViews"][7]["byteOffset"]
    binary[start : start + 8] = np.array(times, "<f4").tobytes()
    with pytest.raises(ModelError) as caught:
        read_model(glb(root, binary), "tiny")
    assert caught.value.place == "/accessors/7"


def test_of_keys_at_the_same_time_the_last_counts():
    root, binary = document()
    start = root["bufferViews"][7]["byteOffset"]
    binary[start : start + 8] = bytes(8)
    character = read_model(glb(root, binary), "tiny")
    assert character.clips["Bend"].sample(0.0).rotation[1] == pytest.approx([0, 0, 1, 0])
    assert "several keys at the same time: the last one is used" in character.notes


def deep_skin(depth=1200):
    """The triangle on a chain of joints, a hundredth of a metre each: its first joint is the root, its second
    the chain's end.
    """
    root, binary = document()
    chain = [{"children": [row + 1], "translation": [0, 0.01, 0]} for row in range(depth - 1)] + [
        {"translation": [0, 0.01, 0]}
    ]
    root["nodes"] = [*chain, {"mesh": 0, "skin": 0}]
    root["scenes"] = [{"nodes": [0, depth]}]
    root["skins"][0]["joints"] = [0, depth - 1]
    root["animations"][0]["channels"][0]["target"]["node"] = depth - 1
    return read_model(glb(root, binary), "deep")


def test_a_skin_hangs_on_a_chain_of_1200_joints():
    character = deep_skin()
    bind, bent = (
        character.vertices(pose)[0].positions
        for pose in (character.bind_pose, character.clips["Bend"].sample(1.0))
    )
    ends = POSITIONS.astype(float) + 0.5 * LIFTED  # the morph target has half its weight
    shares = WEIGHTS[:, 1:2] * 12 + WEIGHTS[:, :1] * 0.01
    assert bind == pytest.approx(ends + shares * [0, 1, 0], abs=1e-3)  # float32, 1,200 sums
    assert bent == pytest.approx(
        ends * [[1, 1, 1], [0, 0, 1], [-0.5, -0.5, 1]] + shares * [0, 1, 0], abs=1e-3
    )


def test_a_gltf_buffer_without_a_uri_is_zeros_and_noted():
    root = json.loads(gltf())
    del root["buffers"][0]["uri"], root["animations"], root["skins"][0]["inverseBindMatrices"]
    character = read_model(json.dumps(root).encode(), "tiny")
    assert not character.parts[0].positions.any()
    assert "a buffer without a uri has no data: it is all zeros" in character.notes


def test_buffers_without_a_uri_cannot_ask_for_any_size():
    root = json.loads(gltf())
    root["buffers"][0] = {"byteLength": 1 << 40}
    with pytest.raises(ModelError) as caught:
        read_model(json.dumps(root).encode(), "tiny")
    assert caught.value.place == "/buffers/0/byteLength"


def test_a_glb_without_its_binary_chunk_is_refused():
    root, _ = document()
    with pytest.raises(ModelError) as caught:
        read_model(glb(root, b""), "tiny")
    assert caught.value.place == "/buffers/0/byteLength"
