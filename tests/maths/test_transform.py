"""Affine transforms against 4x4 matrices."""

import numpy as np
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
