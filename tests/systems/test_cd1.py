"""CD1 point and plane (FAQ Q31): the sign of the plane equation changes between the old place and the new
one.
"""

import numpy as np
import pytest
from statwalk.maths.intersect import crossing, crossing_point, plane_value

WIRE = np.array([0.0, 0, 1]), np.array([0.0, 0, 3])  # looks along +Z, three metres ahead


def values(*heights):
    """The plane's value (T,) on a way along Z."""
    places = np.array([[5.0, 7, z] for z in heights])
    return plane_value(*WIRE, places), places


def crossings(*heights) -> list[bool]:
    value, _ = values(*heights)
    return crossing(value[:-1], value[1:]).is_hit.tolist()


def test_points_in_front_are_positive_behind_negative_on_the_plane_zero():
    np.testing.assert_array_equal(values(4, 3, 1)[0], [1, 0, -2])


def test_a_change_of_sign_is_a_crossing_in_either_direction():
    assert crossings(4, 3.5, 2, 1, 3.2) == [False, True, False, True]


def test_a_crossing_that_stops_on_the_plane_is_reported_once():
    assert crossings(4, 3, 2) == [False, True]
    assert crossings(2, 3, 4) == [True, False]


def test_who_touches_the_plane_from_the_front_and_goes_back_has_not_crossed():
    assert crossings(4, 3, 4) == [False, False]


def test_the_point_lies_on_the_plane_nearer_to_the_smaller_value():
    # from (0, 0, 7), four metres in front, to (10, 0, 2), one behind: four fifths of the way.
    # As printed, (ro·Po + rn·Pn)/(rn − ro), it would be (2, 0, -5.2): eight metres off the plane.
    old, new = np.array([0.0, 0, 7]), np.array([10.0, 0, 2])
    ro, rn = plane_value(*WIRE, old), plane_value(*WIRE, new)
    np.testing.assert_allclose(crossing_point(ro, rn, old, new), [8, 0, 3])
    np.testing.assert_allclose((ro * old + rn * new) / (rn - ro), [2, 0, -5.2])


def test_the_fraction_is_that_of_the_way():
    assert crossing(np.array(4.0), np.array(-1.0)).fraction == pytest.approx(0.8)


def test_many_at_once_and_those_who_do_not_cross_are_zero():
    hit = crossing(np.array([4.0, 1, -1, 0]), np.array([-1.0, 2, -3, 0]))
    np.testing.assert_array_equal(hit.fraction, [0.8, 0, 0, 0])
