"""Quaternions against SciPy's Rotation, and the laws of rotations."""

import numpy as np
import pytest
from hypothesis import given
from rotations import ANGLES, FRACTIONS, quaternions, same_rotation, unit_vectors, vectors
from scipy.spatial.transform import Rotation, Slerp
from statwalk.maths import quat


@given(quaternions(), quaternions())
def test_mul_is_scipys(a, b):
    assert same_rotation(quat.mul(a, b), (Rotation.from_quat(a) * Rotation.from_quat(b)).as_quat())


@given(quaternions(), quaternions(), quaternions())
def test_mul_is_associative(a, b, c):
    np.testing.assert_allclose(quat.mul(quat.mul(a, b), c), quat.mul(a, quat.mul(b, c)), atol=1e-13)


@given(quaternions(), quaternions(), vectors())
def test_a_product_turns_by_the_right_factor_first(a, b, v):
    np.testing.assert_allclose(quat.rotate(quat.mul(a, b), v), quat.rotate(a, quat.rotate(b, v)), atol=1e-11)


@given(quaternions(), vectors())
def test_rotate_is_scipys(q, v):
    np.testing.assert_allclose(quat.rotate(q, v), Rotation.from_quat(q).apply(v), atol=1e-11)


@given(quaternions())
def test_conjugate_undoes(q):
    np.testing.assert_allclose(quat.mul(quat.conjugate(q), q), quat.IDENTITY, atol=1e-13)


@given(quaternions())
def test_matrix_is_scipys_and_back(q):
    matrix = quat.to_matrix(q)
    np.testing.assert_allclose(matrix, Rotation.from_quat(q).as_matrix(), atol=1e-13)
    assert same_rotation(quat.from_matrix(matrix), q)


@given(unit_vectors(), ANGLES)
def test_axis_and_angle(axis, angle):
    assert same_rotation(quat.from_axis_angle(axis, angle), Rotation.from_rotvec(axis * angle).as_quat())


@given(vectors())
def test_euler_xyz_is_x_then_y_then_z_about_the_parents_axes(angles):
    assert same_rotation(quat.from_euler_xyz(angles), Rotation.from_euler("xyz", angles).as_quat())


@given(quaternions())
def test_euler_and_back(q):
    assert same_rotation(
        quat.from_euler_xyz(quat.to_euler_xyz(q)), q, 1e-7
    )  # near gimbal lock angles are known to half the digits


@pytest.mark.parametrize("lock", [90.0, -90.0])
def test_euler_at_gimbal_lock(lock):
    q = quat.from_euler_xyz(np.radians([20.0, lock, 50.0]))
    angles = quat.to_euler_xyz(q)
    assert angles[2] == 0
    assert same_rotation(quat.from_euler_xyz(angles), q, 1e-7)


@given(unit_vectors(), ANGLES)
def test_rotation_vector_and_back(axis, angle):
    v = axis * angle
    np.testing.assert_allclose(quat.to_rotation_vector(quat.from_rotation_vector(v)), v, atol=1e-12)


def test_rotation_vector_takes_the_shorter_arc():
    long_way = quat.from_axis_angle([0.0, 0.0, 1.0], np.radians(350.0))
    np.testing.assert_allclose(quat.to_rotation_vector(long_way), [0, 0, np.radians(-10)], atol=1e-14)


@pytest.mark.parametrize("size", [0.0, 1e-20, 1e-8])
def test_tiny_rotation_vectors_keep_their_digits(size):
    np.testing.assert_allclose(
        quat.to_rotation_vector(quat.from_rotation_vector(np.array([0, size, 0]))), [0, size, 0], rtol=1e-14
    )


def test_zero_normalises_to_the_identity():
    np.testing.assert_array_equal(
        quat.normalize(np.array([[0.0, 0, 0, 0], [0, 0, 0, 2]])), [quat.IDENTITY] * 2
    )


@given(quaternions(), quaternions())
def test_align_is_the_nearer_of_the_two_signs(a, b):
    assert quat.dot(a, quat.align(a, b)) >= 0


@given(quaternions(), quaternions(), FRACTIONS)
def test_slerp_is_scipys(a, b, f):
    if abs(a @ b) < 1e-6:  # half a turn apart: both ways are the shorter one
        return
    expected = Slerp([0, 1], Rotation.from_quat([a, b]))(f).as_quat()
    assert same_rotation(quat.slerp(a, b, f), expected, 1e-12)


@given(quaternions(), quaternions(), FRACTIONS)
def test_slerp_in_float32_is_right_to_1e_6(a, b, f):
    if abs(a @ b) < 1e-3:
        return
    result = quat.slerp(a.astype(np.float32), b.astype(np.float32), f)
    assert result.dtype == np.float32
    assert same_rotation(result, quat.slerp(a, b, f), 1e-6)


@given(quaternions(), quaternions(), FRACTIONS)
def test_interpolated_quaternions_are_unit(a, b, f):
    for result in (quat.slerp(a, b, f), quat.nlerp(a, b, f)):
        assert abs(np.linalg.norm(result) - 1) < 1e-12


@given(quaternions(), quaternions())
def test_slerp_meets_its_ends_exactly(a, b):
    np.testing.assert_array_equal(quat.slerp(a, b, 0.0), a)
    assert same_rotation(quat.slerp(a, b, 1.0), b, 0)


@given(quaternions(), FRACTIONS)
def test_slerp_between_a_rotation_and_itself_stays(q, f):
    np.testing.assert_allclose(quat.slerp(q, q, f), q, atol=1e-15)


@given(unit_vectors(), unit_vectors())
def test_between_takes_one_to_the_other(u, v):
    np.testing.assert_allclose(quat.rotate(quat.between(u, v), u), v, atol=1e-7)


@given(unit_vectors())
def test_between_parallel_and_opposite(u):
    np.testing.assert_allclose(quat.between(u, u), quat.IDENTITY, atol=1e-12)
    np.testing.assert_allclose(quat.rotate(quat.between(u, -u), u), -u, atol=1e-12)


RNG = np.random.default_rng(5)
CROWD = RNG.normal(size=(2, 37, 5, 4)).astype(np.float32)
A, B = CROWD / np.linalg.norm(CROWD, axis=-1, keepdims=True)


F = RNG.uniform(size=A.shape[:2]).astype(np.float32)
DIRECTION = A[..., :3] / np.linalg.norm(A[..., :3], axis=-1, keepdims=True)
BATCHED = {
    "mul": (quat.mul, A, B),
    "rotate": (quat.rotate, A, B[..., :3]),
    "normalize": (quat.normalize, 3 * A),
    "nlerp": (quat.nlerp, A, B, F),
    "slerp": (quat.slerp, A, B, F),
    "to_matrix": (quat.to_matrix, A),
    "from_matrix": (quat.from_matrix, quat.to_matrix(A)),
    "to_rotation_vector": (quat.to_rotation_vector, A),
    "from_rotation_vector": (quat.from_rotation_vector, B[..., :3]),
    "from_euler_xyz": (quat.from_euler_xyz, B[..., :3]),
    "between": (quat.between, DIRECTION, DIRECTION[::-1]),
}


@pytest.mark.parametrize("name", BATCHED)
def test_one_actor_and_a_crowd_get_the_same_bits(name):
    function, *crowd = BATCHED[name]
    together = function(*crowd)
    assert together.dtype == np.float32
    alone = [function(*(array[actor] for array in crowd)) for actor in range(len(A))]
    assert [one.tobytes() for one in alone] == [one.tobytes() for one in together]
