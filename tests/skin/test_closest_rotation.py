"""The rotation closest to a matrix, against SciPy's polar decomposition."""

import numpy as np
import pytest
from random_skin import rotations
from scipy.linalg import polar
from scipy.spatial.transform import Rotation
from statwalk.skin.dual_palette import BONE, SIGNS, dual_palette

CHANCE = np.random.default_rng(3)


def quaternions(linear):
    """The kernel's rotations (K,4) of matrices (K,3,3)."""
    matrices = np.zeros((len(linear), 16), np.float32)
    matrices[:, :12].reshape(-1, 3, 4)[..., :3] = linear
    rows, pairs, none = (
        np.zeros(BONE * len(linear), np.float32),
        np.zeros((0, 2), np.int32),
        np.zeros(0, np.float32),
    )
    dual_palette(matrices.reshape(-1), pairs, SIGNS, rows, none, none)
    return rows.reshape(-1, BONE)[:, :4].astype(float)


def angles(found, rotations):
    return (Rotation.from_quat(found).inv() * Rotation.from_matrix(rotations)).magnitude()


def test_of_a_rotation_it_is_the_rotation():
    turns = rotations(CHANCE, 500)
    assert angles(quaternions(turns), turns).max() < 1e-6


@pytest.mark.parametrize("thinnest", [0.5, 1e-2, 1e-5])
def test_of_a_stretched_rotation_it_is_the_polar_decompositions(thinnest):
    frames = rotations(CHANCE, 200)
    sizes = CHANCE.uniform(0.5, 3, (200, 3)) * [1, 1, thinnest]
    linear = (rotations(CHANCE, 200) @ (frames * sizes[:, None]) @ frames.swapaxes(1, 2)).astype(np.float32)
    expected = np.array([polar(matrix.astype(float))[0] for matrix in linear])
    assert angles(quaternions(linear), expected).max() < 1e-5


def test_of_a_mirror_it_is_that_of_the_opposite_matrix():
    turns = rotations(CHANCE, 50)
    assert angles(quaternions(-turns), turns).max() < 1e-6


def test_of_a_flattened_rotation_it_is_the_rotation():
    """The sign of a determinant that is only rounding does not make a mirror."""
    turns = rotations(CHANCE, 200)
    flat = turns @ np.diag([1.0, 1, 0]) + CHANCE.normal(size=(200, 3, 3)) * 1e-7
    assert angles(quaternions(flat), turns).max() < 1e-5


def test_of_a_flat_matrix_it_is_a_rotation_all_the_same():
    found = quaternions(np.array([np.diag([1.0, 1, 0]), np.diag([1.0, 0, 0]), np.zeros((3, 3))]))
    assert np.linalg.norm(found, axis=1) == pytest.approx([1, 1, 1])
    assert Rotation.from_quat(found[0]).magnitude() < 1e-6
