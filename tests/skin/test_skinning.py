"""What the vertices follow: the heaviest bone, or pieces that go with one bone each."""

import numpy as np
import pytest
from statwalk.errors import UnknownNameError
from statwalk.skin.primitive import Primitive
from statwalk.skin.skinning import SKINNINGS, heaviest_bones, reskinned, skinning_of, triangle_bones

JOINTS = np.array([[3, 1], [3, 1], [1, 3], [1, 0]], np.uint16)
WEIGHTS = np.array([[1, 0], [0.6, 0.4], [0.5, 0.5], [0.9, 0.1]], np.float32)
POSITIONS = np.arange(12, dtype=np.float32).reshape(4, 3)
UVS = np.arange(8, dtype=np.float32).reshape(4, 2)
TARGETS = np.arange(24, dtype=np.float32).reshape(2, 4, 3)


def strip(**changes):
    """Two triangles in a strip: 0 1 2 and 2 1 3."""
    fields = {"mode": 5, "skin": 0, "joints": JOINTS, "weights": WEIGHTS, "normals": POSITIONS + 1}
    fields |= {"target_positions": TARGETS, "target_normals": TARGETS + 1, "attributes": {"TEXCOORD_0": UVS}}
    return Primitive(0, 0, 0, 0, POSITIONS, **(fields | changes))


def test_the_heaviest_bone_is_the_first_of_equals():
    assert heaviest_bones(JOINTS, WEIGHTS).tolist() == [3, 3, 1, 1]


def test_a_triangle_goes_with_the_bone_that_is_heaviest_over_its_corners():
    faces = np.array([[0, 1, 2], [2, 1, 3]])
    assert triangle_bones(faces, JOINTS, WEIGHTS).tolist() == [3, 1]  # 2.1 against 0.9; 1.1 against 1.8


def test_rigid_skin_keeps_the_mesh_and_has_one_bone_a_vertex():
    (part,) = reskinned([strip()], "rigid")
    assert part.joints.tolist() == [[3], [3], [1], [1]]
    assert part.weights.tolist() == [[1]] * 4
    assert part.positions is POSITIONS
    assert part.mode == 5


def test_pieces_have_corners_of_their_own():
    (part,) = reskinned([strip()], "parts")
    assert part.mode == 4
    first, second = part.indices.reshape(2, 3)
    assert not set(first) & set(second)
    assert np.array_equal(part.positions[first], POSITIONS[[0, 1, 2]])
    assert np.array_equal(part.positions[second], POSITIONS[[2, 1, 3]])
    assert part.joints[first].tolist() == [[3]] * 3
    assert part.joints[second].tolist() == [[1]] * 3


def test_pieces_keep_what_belongs_to_their_corners():
    (part,) = reskinned([strip()], "parts")
    corners = part.indices
    old = [0, 1, 2, 2, 1, 3]
    assert np.array_equal(part.normals[corners], (POSITIONS + 1)[old])
    assert np.array_equal(part.attributes["TEXCOORD_0"][corners], UVS[old])
    assert np.array_equal(part.target_positions[:, corners], TARGETS[:, old])
    assert np.array_equal(part.target_normals[:, corners], (TARGETS + 1)[:, old])


def test_triangles_of_one_bone_share_their_corners():
    one = np.zeros((4, 1), np.uint16)
    (part,) = reskinned([strip(joints=one, weights=np.ones((4, 1), np.float32))], "parts")
    assert len(part.positions) == 4


def test_points_and_parts_without_skin_stay_whole():
    bare = Primitive(0, 0, 0, 0, POSITIONS)
    points, same = reskinned([strip(mode=0), bare], "parts")
    assert np.array_equal(points.positions, POSITIONS)
    assert points.mode == 0
    assert same is bare


@pytest.mark.parametrize("skinning", ["linear", "dual-quaternion"])
def test_blended_skins_keep_their_weights(skinning):
    part = strip()
    assert reskinned([part], skinning) == (part,)


def test_another_name_is_refused():
    assert [skinning_of(name) for name in SKINNINGS] == list(SKINNINGS)
    with pytest.raises(UnknownNameError, match="dual-quaternion"):
        skinning_of("smooth")
