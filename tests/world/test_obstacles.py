"""Spheres and planes that are flown around, worked out by hand."""

import numpy as np
import pytest
from statwalk.world.obstacles import NO_OBSTACLES, Obstacles, evasion, pushed_out, repulsion

BALL = Obstacles(np.array([[0.0, 0, 10]]), np.array([2.0]), np.zeros((1, 3)), np.array([False]))
FLOOR = Obstacles(np.array([[7.0, 1, 7]]), np.zeros(1), np.array([[0.0, 1, 0]]), np.array([True]))


@pytest.mark.parametrize(
    ("gap", "force"),
    [(1, 4), (2, 0), (3, 0), (0.5, 20)],
    ids=["at the distance", "at twice it", "far", "at half"],
)
def test_the_field_of_a_sphere(gap, force):
    # 4·((1/gap)² − 1/4)/(3/4) away from it
    pushed = repulsion(BALL, np.array([[0.0, 0, 8 - gap]]), 1.0, 4.0)
    np.testing.assert_allclose(pushed, [[0, 0, -force]], atol=1e-12)


def test_the_field_of_a_plane_leads_along_its_normal():
    np.testing.assert_allclose(
        repulsion(FLOOR, np.array([[0.0, 2, 0], [3, 9, 1]]), 1.0, 4.0), [[0, 4, 0], [0, 0, 0]]
    )


def test_who_is_inside_is_put_onto_the_surface_and_flies_on_along_it():
    place, velocity = pushed_out(BALL, np.array([[0.0, 0, 9], [0, 0, 0]]), np.array([[3.0, 0, 1], [3, 0, 1]]))
    np.testing.assert_allclose(place, [[0, 0, 8], [0, 0, 0]])
    np.testing.assert_allclose(velocity, [[3, 0, 0], [3, 0, 1]])


def test_who_is_below_the_floor_is_put_onto_it():
    place, velocity = pushed_out(FLOOR, np.array([[0.0, -3, 0]]), np.array([[1.0, -2, 0]]))
    np.testing.assert_allclose((place[0], velocity[0]), [[0, 1, 0], [1, 0, 0]])


def test_who_is_in_the_very_middle_is_put_out_upwards():
    place, _ = pushed_out(BALL, np.array([[0.0, 0, 10]]), np.zeros((1, 3)))
    np.testing.assert_allclose(place, [[0, 2, 10]])


def test_a_course_into_a_sphere_is_turned_aside():
    # one metre beside the middle, which is a second ahead; 2 m and the distance of 1 m are to be kept: 2·(3 −
    # 1)/1²
    aside = evasion(BALL, np.array([[1.0, 0, 0]]), np.array([[0.0, 0, 10]]), 1.0)
    np.testing.assert_allclose(aside, [[4, 0, 0]])


@pytest.mark.parametrize(
    ("place", "velocity"),
    [((3.1, 0, 0), (0, 0, 10)), ((0, 0, 20), (0, 0, 10)), ((0, 0, 0), (0, 0, 1)), ((0, 0, 0), (0, 0, 0))],
    ids=["passes by", "flies away", "has time", "stands"],
)
def test_others_are_left_alone(place, velocity):
    assert not evasion(BALL, np.array([place], float), np.array([velocity], float), 1.0).any()


def test_who_flies_right_at_the_middle_turns_to_some_side():
    aside = evasion(BALL, np.zeros((1, 3)), np.array([[0.0, 0, 10]]), 1.0)
    assert np.linalg.norm(aside) == pytest.approx(6)
    assert aside[0, 2] == 0


def test_nothing_is_in_the_way():
    place = np.ones((2, 3))
    assert not repulsion(NO_OBSTACLES, place, 1.0, 4.0).any()
    np.testing.assert_array_equal(pushed_out(NO_OBSTACLES, place, place)[0], place)
