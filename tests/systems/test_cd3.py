"""CD3 sphere and sphere (FAQ Q33): D = |Pb − Pa| − Ra − Rb, and the plane in which they meet."""

import numpy as np
import pytest
from statwalk.maths.intersect import APART, CONCENTRIC, INSIDE, MEET, gap, meeting, swept_spheres

ORIGIN = np.zeros(3)


def along_x(distance, a_radius, b_radius):
    return ORIGIN, np.array(float(a_radius)), np.array([float(distance), 0, 0]), np.array(float(b_radius))


@pytest.mark.parametrize(
    ("distance", "expected"), [(4, -1), (5, 0), (7, 2)], ids=["overlap", "just touch", "apart"]
)
def test_the_gap(distance, expected):
    assert gap(*along_x(distance, 3, 2)) == expected


def test_the_plane_of_a_right_triangle():
    # radii 3 and 4, centres 5 apart: the circle's radius is the triangle's height 3·4/5, its foot 9/5 from
    # the first centre. As printed the point is Ra/(Ra + Rb) of the way along the full vector, 15/7 = 2.14
    # (with the unit normal meant: 0.43).
    plane = meeting(*along_x(5, 3, 4))
    assert plane.kind == MEET
    np.testing.assert_allclose(plane.point, [1.8, 0, 0])
    np.testing.assert_allclose(plane.normal, [1, 0, 0])
    assert plane.radius == pytest.approx(2.4)


def test_every_point_of_the_circle_lies_on_both_spheres():
    a, b, ra, rb = np.array([1.0, -2, 0.5]), np.array([2.5, -1, 2]), np.array(1.7), np.array(1.1)
    plane = meeting(a, ra, b, rb)
    beside = np.cross(plane.normal, [0.3, 0.9, -0.1])
    rim = plane.point + beside / np.linalg.norm(beside) * plane.radius
    assert (np.linalg.norm(rim - a), np.linalg.norm(rim - b)) == pytest.approx((1.7, 1.1))


def test_where_they_just_touch_the_printed_point_is_right():
    plane = meeting(*along_x(5, 3, 2))
    np.testing.assert_allclose(plane.point, [3 / (3 + 2) * 5, 0, 0])
    assert plane.radius == 0


def test_the_centre_of_the_smaller_may_lie_beyond_the_plane():
    # radii 5 and 3, centres 3 apart: (9 + 25 − 9)/6 = 25/6 from the first, beyond the second
    np.testing.assert_allclose(meeting(*along_x(3, 5, 3)).point, [25 / 6, 0, 0])


@pytest.mark.parametrize(
    ("distance", "radii", "kind"),
    [
        (6, (3, 2), APART),
        (0.5, (3, 2), INSIDE),
        (0.5, (2, 3), INSIDE),
        (0, (3, 2), CONCENTRIC),
        (0, (2, 2), CONCENTRIC),
    ],
)
def test_where_there_is_no_plane_that_is_said(distance, radii, kind):
    plane = meeting(*along_x(distance, *radii))
    assert plane.kind == kind
    assert not plane.normal.any()
    assert not plane.point.any()


def test_many_pairs_at_once():
    plane = meeting(
        np.zeros((2, 3)), np.array([3.0, 3]), np.array([[5.0, 0, 0], [9, 0, 0]]), np.array([4.0, 4])
    )
    np.testing.assert_array_equal(plane.kind, [MEET, APART])


def test_two_that_fly_through_each_other_within_a_step_meet():
    # ten metres towards each other each, radii 1: the gap of 8 m closes at 20 m a step
    hit = swept_spheres(
        *(np.array([-5.0, 0, 0]), np.array([5.0, 0, 0]), np.array(1.0)),
        *(np.array([5.0, 0, 0]), np.array([-5.0, 0, 0]), np.array(1.0)),
    )
    assert hit.is_hit
    assert hit.fraction == pytest.approx(0.4)


def test_two_that_fly_side_by_side_do_not():
    step = np.array([10.0, 0, 0])
    beside = np.array([0.0, 2.5, 0])
    assert not swept_spheres(ORIGIN, step, np.array(1.0), beside, beside + step, np.array(1.0)).is_hit
