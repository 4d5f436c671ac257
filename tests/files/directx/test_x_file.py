"""Small .x files, worked out by hand."""

import numpy as np
import pytest
import small_x
from statwalk.errors import TextError
from statwalk.files.directx import read_directx

HEADER = "xof 0303txt 0032\n"
NO_PICTURE = "the picture 'skin // not a comment.png' is left out: a .x file is read without its pictures"
GREY = "Material { 1;1;1;1;; 0; 0;0;0;; 0;0;0;; }"
TRIANGLE = "3; 0;0;0;, 1;0;0;, 0;1;0;; 1; 3;0,2,1;;"


def read(text: str):
    return read_directx(text.encode(), "small")


ARM = read(small_x.ARM)


def points(character, pose) -> list[list[float]]:
    return np.concatenate([part.positions for part in character.vertices(pose)]).round(5).tolist()


def test_frames_are_joints_mirrored() -> None:
    assert ARM.skeleton.names == ("Root", "Arm", "Hand")
    assert ARM.skeleton.parent.tolist() == [-1, 0, 1]
    assert ARM.world(ARM.bind_pose)[:, :3, 3].tolist() == [[0, 0, 0], [0, 1, -2], [0, 2, -2]]


def test_a_turn_about_x_from_y_to_z_goes_from_y_to_minus_z() -> None:
    assert ARM.world(ARM.clips["Bend"].sample(1.0))[2, :3, 3] == pytest.approx([0, 1, -3], abs=1e-6)


def test_matrix_keys_are_the_same_motion_as_rotation_and_position_keys() -> None:
    bend, turn = ARM.clips["Bend"].sample(1.0), ARM.clips["Turn"].sample(5.0)
    assert ARM.world(turn) == pytest.approx(ARM.world(bend), abs=1e-6)


def test_times_are_in_ticks_and_a_closed_set_repeats() -> None:
    assert (ARM.clips["Bend"].duration, ARM.clips["Turn"].duration) == (1.0, 2.0)
    assert (ARM.clips["Bend"].loop, ARM.clips["Turn"].loop) == (False, True)


def test_the_skin_rests_where_the_mesh_is_and_follows_by_weight() -> None:
    assert points(ARM, ARM.bind_pose) == [[0, 0, 0], [1, 0, 0], [1, 3, -2], [0, 3, -2]]
    bent = points(ARM, ARM.clips["Bend"].sample(1.0))
    # the vertex 1 3 2 is 2 above the Arm, which lies down: 2 in front of it; both bones agree
    assert bent[2] == pytest.approx([1, 1, -4], abs=1e-5)


def test_faces_run_the_other_way_round_and_normals_point_out_of_them() -> None:
    (part,) = ARM.parts
    assert part.indices.tolist() == [3, 1, 2, 3, 0, 1]
    corners = part.positions[part.indices.reshape(-1, 3)]
    flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (np.einsum("ti,ti->t", flat, part.normals[part.indices[::3]]) > 0).all()
    assert part.normals.tolist() == [[0, 0, 1]] * 4


def test_materials_have_colour_roughness_and_glow_and_no_picture() -> None:
    (material,) = ARM.materials
    assert material["name"] == "Skin"
    assert material["pbrMetallicRoughness"]["baseColorFactor"] == [0.5, 0.25, 1, 1]
    assert material["pbrMetallicRoughness"]["roughnessFactor"] == 0.5
    assert material["emissiveFactor"] == [0, 0.5, 0]
    assert ARM.notes == (NO_PICTURE,)


def test_texture_coordinates_stay() -> None:
    assert ARM.parts[0].attributes["TEXCOORD_0"].tolist() == [[0, 1], [1, 1], [1, 0], [0, 0]]


def test_a_vertex_with_two_normals_is_split() -> None:
    normals = "MeshNormals { 2; 0;0;-1;, 0;1;0;; 2; 3;0,0,0;, 3;1,1,1;; }"
    mesh = f"Mesh {{ 4; 0;0;0;, 1;0;0;, 0;1;0;, 1;1;0;; 2; 3;0,2,1;, 3;1,2,3;; {normals} }}"
    (part,) = read(HEADER + mesh).parts
    assert len(part.positions) == 6
    assert sorted(part.normals.tolist()) == [[0, 0, 1]] * 3 + [[0, 1, 0]] * 3


def test_faces_of_any_size_become_triangles() -> None:
    mesh = "Mesh { 5; 0;0;0;, 2;0;0;, 2;2;0;, 1;3;0;, 0;2;0;; 3; 5;4,3,2,1,0;, 3;0,2,1;, 2;0,1;; }"
    (part,) = read(HEADER + mesh).parts
    assert part.indices.reshape(-1, 3).tolist() == [[4, 2, 3], [4, 1, 2], [4, 0, 1], [0, 1, 2]]


def test_a_mesh_has_a_part_for_each_material_and_colours_for_vertices() -> None:
    red = "Material red { 1;0;0;1;; 0; 0;0;0;; 0;0;0;; }"
    blue = "Material { 0;0;1;0.5;; 0; 0;0;0;; 0;0;0;; }"
    colors = "MeshVertexColors { 1; 3; 0;1;0;1;;; }"
    body = "4; 0;0;0;, 1;0;0;, 0;1;0;, 1;1;0;; 2; 3;0,2,1;, 3;1,2,3;;"
    character = read(
        f"{HEADER}{red} Mesh {{ {body} MeshMaterialList {{ 2; 2; 1,0; {{red}} {blue} }} {colors} }}"
    )
    assert [(part.material, len(part.positions)) for part in character.parts] == [(0, 3), (1, 3)]
    assert character.materials[1]["alphaMode"] == "BLEND"
    assert character.parts[0].attributes["COLOR_0"].tolist() == [[1, 1, 1, 1], [1, 1, 1, 1], [0, 1, 0, 1]]


def test_several_meshes_in_a_frame_get_joints_of_their_own() -> None:
    character = read(
        f"{HEADER}Frame A {{ Mesh {{ {TRIANGLE} }} Mesh b {{ {TRIANGLE} }} }} Mesh {{ {TRIANGLE} }}"
    )
    assert character.skeleton.names == ("A", "b", "mesh")
    assert character.skeleton.parent.tolist() == [-1, 0, -1]
    assert [part.joint for part in character.parts] == [0, 1, 2]


def test_what_a_file_lacks_is_repaired_with_a_note() -> None:
    weights = "".join(
        f'SkinWeights {{ "{bone}"; 1; {vertex}; 0.5; {small_x.IDENTITY} }} '
        for bone, vertex in (("A", 0), ("gone", 1))
    )
    keys = "AnimationKey { 0; 2; 9;4;1,0,0,0;;, 3;4;0,0,0,0;;; }"
    text = f"""{HEADER}Frame A {{ Mesh m {{ {TRIANGLE} {weights} }} {{nothing}} }} Frame A {{ }}
    AnimationSet {{ Animation {{ {{A}} {keys} {keys} }} Animation {{ {{gone}} }} }}
    IKchain {{ {{A}} {{gone}} }}"""
    character = read(text)
    assert character.skeleton.names == ("A", "A 2")
    assert list(character.clips) == ["clip 0"]
    assert len(character.clips["clip 0"].channels) == 1
    for said in (
        "a frame refers to 'nothing'",
        "no frames gone: their skin weights go to the other bones",
        "2 vertices of mesh m have no bone and follow their frame",
        "skin weights did not sum to 1",
        "smooth normals",
        "4800 ticks a second",
        "not in the order of their times",
        "two animations of a set move the same property",
        "an animation for 'gone' is left out",
        "the IKchain 'chain 0' is left out",
    ):
        assert any(said in note for note in character.notes), said


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "nothing to show"),
        ("Frame A {\nFrameTransformMatrix {\n1,2;; }}", "line 4: 16 numbers should follow for a matrix"),
        ("Mesh {\n3; 0;0;0;, 1;0;0;, 0;1;0;;\n1; 3;0,2,3;; }", "line 4: a corner of faces: 3 should be"),
        (
            "Mesh {\n3; 0;0;0;, 1;0;0;, 0;1;0;;\n1; 9;0,2,1;; }",
            "line 4: 9 corners of a face of faces cannot be",
        ),
        (
            f"Mesh {{ {TRIANGLE}\nMeshNormals {{ 1; 0;0;1;; 0; }} }}",
            "line 3: MeshNormals must have the faces",
        ),
        (f"Mesh {{ {TRIANGLE}\nMeshTextureCoords {{ 1; 0;0;; }} }}", "needs 3 texture coordinates"),
        (
            f"Mesh {{ {TRIANGLE}\nMeshVertexColors {{ 1; 7; 0;0;0;0;;; }} }}",
            "line 3: a colour is for vertex 7",
        ),
        (f"Mesh {{ {TRIANGLE}\nMeshMaterialList {{ 1; 1; 0; {{no}} }} }}", "the file has no material 'no'"),
        (
            f"Mesh {{ {TRIANGLE}\nMeshMaterialList {{ 2; 1; 1; {GREY} }} }}",
            "1 materials",
        ),
        (f"Mesh {{ {TRIANGLE}\nSkinWeights {{ 1; }} }}", "line 3: SkinWeights begin with the name"),
        (
            f'Mesh {{ {TRIANGLE}\nSkinWeights {{ "A"; 1; 3; 1; }} }}',
            "line 3: a vertex of a bone: 3 should be",
        ),
        (
            "Frame A { }\nAnimTicksPerSecond { 0; }\nAnimationSet { }",
            "line 3: AnimTicksPerSecond should be 1 to",
        ),
        (
            "Frame A { }\nAnimationSet { Animation { {A}\nAnimationKey { 7; 0; } } }",
            "line 4: the type of keys should be",
        ),
        (
            "Frame A { }\nAnimationSet { Animation { {A} AnimationKey { 1; 1;\n0;4;1,1,1;;; } } }",
            "line 4: a key of type 1 is a time, 0 to 4294967295 ticks, then 3, and 3 numbers",
        ),
        (
            "Frame A { }\nAnimationSet { Animation { {A} AnimationKey { 1; 1;\n-2;3;1,1,1;;; } } }",
            "line 4: a key of type 1 is a time, 0 to",
        ),
    ],
)
def test_broken_files_are_refused_with_the_line(text: str, said: str) -> None:
    with pytest.raises(TextError) as refused:
        read(HEADER + text)
    assert said in str(refused.value)


def test_few_vertices_with_very_many_bones_take_no_memory() -> None:
    vertices = 2_000
    mesh = f"{vertices}; {'0;0;0;' * vertices} 0;"
    bones = f'SkinWeights {{ "A"; 1; 0; 1; {small_x.IDENTITY} }} ' * 4_001
    with pytest.raises(
        TextError, match="2000 vertices with up to 4001 bones each need more than 8000000 weights"
    ):
        read(f"{HEADER}Frame A {{ Mesh {{ {mesh} {bones} }} }}")
