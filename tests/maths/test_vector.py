"""Vector products against NumPy's."""

import numpy as np
from hypothesis import given
from rotations import unit_vectors, vectors
from statwalk.maths import vector


@given(vectors(), vectors())
def test_dot_and_cross(a, b):
    np.testing.assert_allclose(vector.dot(a, b), np.dot(a, b), atol=1e-12)
    np.testing.assert_allclose(vector.cross(a, b), np.cross(a, b), atol=1e-12)


@given(unit_vectors())
def test_perpendicular_is_a_unit_vector_at_right_angles(v):
    other = vector.perpendicular(v)
    assert abs(other @ v) < 1e-12
    assert abs(np.linalg.norm(other) - 1) < 1e-12


def test_the_zero_vector_stays_zero():
    assert (vector.unit(np.zeros(3)) == 0).all()
