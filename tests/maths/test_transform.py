"""Affine transforms against 4x4 matrices."""

import numpy as np
import pytest
from statwalk.maths import quat, transform

RNG = np.random.default_rng(7)
TURNS = quat.normalize(RNG.normal(size=(50, 4)))
PLACES, SIZES = RNG.normal(size=(50, 3)), np.exp(RNG.normal(size=(50, 3)) * 0.3)
TRS = transform.from_trs(PLACES, TURNS, SIZES)
MATRICES = transform.to_matrix4(TRS)


def test_from_trs_scales_first_then_turns_then_moves():
    point = np.array([1.0, 2.0, 3.0])
    np.testing.assert_allclose(
        transform.apply(TRS, point), quat.rotate(TURNS, SIZES * point) + PLACES, atol=1e-13
    )


def test_mul_is_the_matrix_product():
    np.testing.assert_allclose(
        transform.to_matrix4(transform.mul(TRS, TRS[::-1])), MATRICES @ MATRICES[::-1], atol=1e-12
    )


def test_mul_is_associative():
    a, b, c = TRS, TRS[::-1], np.roll(TRS, 7, 0)
    left, right = transform.mul(transform.mul(a, b), c), transform.mul(a, transform.mul(b, c))
    np.testing.assert_allclose(left, right, atol=1e-11)


def test_invert_is_numpys():
    np.testing.assert_allclose(
        transform.to_matrix4(transform.invert(TRS)), np.linalg.inv(MATRICES), atol=1e-12
    )


def test_vectors_are_not_moved():
    np.testing.assert_allclose(
        transform.apply_vector(TRS, PLACES), transform.apply(TRS, PLACES) - PLACES, atol=1e-13
    )


def test_matrix4_and_back():
    np.testing.assert_array_equal(transform.from_matrix4(MATRICES), TRS)


def test_one_actor_and_a_crowd_get_the_same_bits():
    small = TRS.astype(np.float32)
    crowd = transform.mul(small, small[::-1])
    assert all(transform.mul(small[i], small[::-1][i]).tobytes() == crowd[i].tobytes() for i in range(50))


def test_a_transform_comes_apart_into_what_it_was_made_of():
    place, turn, size = transform.to_trs(TRS)
    np.testing.assert_allclose(place, PLACES)
    np.testing.assert_allclose(quat.to_matrix(turn), quat.to_matrix(TURNS), atol=1e-12)
    np.testing.assert_allclose(size, SIZES)


@pytest.mark.parametrize("size", [(1, -2, 1), (-1, -2, -3), (2, 0, 1)])
def test_mirrored_and_flat_transforms_come_apart_too(size):
    made = transform.from_trs(PLACES[0], TURNS[0], np.array(size, float))
    np.testing.assert_allclose(transform.from_trs(*transform.to_trs(made)), made, atol=1e-12)


def test_skew_is_told_from_scale():
    skewed = np.array([[1, 0.5, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]], float)
    plain = transform.from_trs(PLACES[0], TURNS[0], np.array([1, -5, 0.1]))
    assert transform.is_skewed(np.stack([skewed, plain])).tolist() == [True, False]
