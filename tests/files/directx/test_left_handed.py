"""The way from DirectX's convention to glTF's and back, held against products of matrices."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk.files.directx.left_handed import affine, mirrored, rotation_keys, rotations, row_matrices
from statwalk.maths import transform

RANDOM = np.random.default_rng(4)
MATRICES = RANDOM.normal(size=(9, 4, 4)) * [1, 1, 1, 0] + np.diag([0, 0, 0, 1])


def test_a_point_goes_the_same_way_in_both_conventions() -> None:
    point = RANDOM.normal(size=(9, 3))
    there = np.einsum("nr,nrc->nc", np.pad(point, ((0, 0), (0, 1)), constant_values=1), MATRICES)[:, :3]
    here = transform.apply(affine(MATRICES.reshape(9, 16)), mirrored(point))
    assert here == pytest.approx(mirrored(there))


def test_a_figure_that_looks_at_the_viewer_still_does() -> None:
    forward_of_directx, left_hand = np.array([0.0, 0.0, -1.0]), np.array([1.0, 0.0, 0.0])
    assert mirrored(forward_of_directx).tolist() == [0, 0, 1]
    assert mirrored(left_hand).tolist() == [1, 0, 0]


def test_matrices_and_rotations_come_back() -> None:
    assert row_matrices(affine(MATRICES.reshape(9, 16))) == pytest.approx(MATRICES.reshape(9, 16))
    turns = Rotation.random(9, random_state=1).as_quat()
    assert rotations(rotation_keys(turns)) == pytest.approx(turns)


def test_a_rotation_key_is_the_inverse_of_the_matrix_s_rotation() -> None:
    turns = Rotation.random(9, random_state=2)
    matrices = np.zeros((9, 4, 4))
    matrices[:, :3, :3], matrices[:, 3, 3] = np.swapaxes(turns.as_matrix(), 1, 2), 1
    keys = turns.inv().as_quat()[:, [3, 0, 1, 2]]
    here = Rotation.from_quat(rotations(keys)).as_matrix()
    assert here == pytest.approx(affine(matrices.reshape(9, 16))[..., :3])
