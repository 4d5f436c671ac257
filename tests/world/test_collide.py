"""Touches of colliders that move within a step: hand-worked spheres and sheets."""

import numpy as np
import pytest
from statwalk.world.collide import Bodies, touches

ALL = np.ones((1, 1), bool)


def bodies(*rows):
    """Rows (before, now, radius) of spheres, or (before, now, radius, normal) of planes; each of an owner of
    its own.
    """
    normal = np.array([row[3] if len(row) > 3 else (0, 0, 0) for row in rows], float)
    return Bodies(
        owner=np.arange(len(rows)),
        kind=np.zeros(len(rows), np.int64),
        before=np.array([row[0] for row in rows], float),
        now=np.array([row[1] for row in rows], float),
        radius=np.array([row[2] for row in rows], float),
        is_plane=np.array([len(row) > 3 for row in rows]),
        normal_before=normal,
        normal=normal,
    )


def only(*rows):
    """The one touch of two colliders: start, end, lasts, point at start."""
    found = touches(bodies(*rows), ALL)
    assert len(found.first) == 1
    return float(found.start[0]), float(found.end[0]), bool(found.lasts[0]), found.point_at_start[0].tolist()


def none(*rows):
    assert not len(touches(bodies(*rows), ALL).first)


STILL = ((0, 0, 0), (0, 0, 0), 1)
FRONT = (0, 0, 1)
WALL = ((0, 0, 0), (0, 0, 0), 0, FRONT)
WIRE = ((0, 0, 0), (0, 0, 0), 2, FRONT)


def test_a_sphere_that_comes_and_stays():
    assert only(STILL, ((5, 0, 0), (1, 0, 0), 1)) == (0.75, 1, True, [1, 0, 0])


def test_a_sphere_that_goes():
    start, end, lasts, _ = only(STILL, ((1, 0, 0), (5, 0, 0), 1))
    assert (start, end, lasts) == (0, 0.25, False)


def test_a_missile_that_is_through_within_the_step():
    start, end, lasts, point = only(STILL, ((-5, 0, 0), (5, 0, 0), 0))
    assert (start, end, lasts) == pytest.approx((0.4, 0.6, False))
    assert point == pytest.approx([-1, 0, 0])


def test_a_missile_that_passes_by():
    none(STILL, ((-5, 1.1, 0), (5, 1.1, 0), 0))


def test_both_may_move():
    assert only(((0, 0, 0), (0, 4, 0), 1), ((0, 10, 0), (0, 6, 0), 1))[:3] == (1, 1, True)


def test_a_point_goes_through_a_wall():
    assert only(WALL, ((3, 0, 1), (7, 0, -3), 0)) == (0.25, 0.25, False, [4, 0, 0])


def test_a_sphere_touches_a_wall_before_its_centre_is_through():
    assert only(WALL, ((0, 0, 3), (0, 0, -5), 1))[:3] == (0.25, 0.5, False)
    assert only(WALL, ((0, 0, 3), (0, 0, 0.5), 1))[:3] == (0.8, 1, True)


def test_from_behind_as_from_the_front():
    assert only(WALL, ((0, 0, -3), (0, 0, 1), 1))[0] == 0.5


def test_a_sphere_far_from_a_wall():
    none(WALL, ((0, 0, 3), (0, 0, 2), 1))
    none(WALL, ((0, 0, -3), (9, 0, -2), 1))


def test_a_trip_wire_counts_within_its_disc_alone():
    assert only(WIRE, ((0, 1.9, 1), (0, 1.9, -1), 0))[0] == 0.5
    none(WIRE, ((0, 2.1, 1), (0, 2.1, -1), 0))


def test_a_wire_that_is_carried_over_a_point():
    assert only(((0, 0, -1), (0, 0, 1), 2, FRONT), ((0, 0, 0), (0, 0, 0), 0))[0] == 0.5


def test_planes_do_not_touch_planes():
    none(WALL, ((0, 0, -1), (0, 0, 1), 0, FRONT))


def test_nobody_touches_itself():
    pair = bodies(STILL, STILL)._replace(owner=np.zeros(2, np.int64))
    assert not len(touches(pair, ALL).first)


def test_only_the_kinds_that_are_wanted_in_either_order():
    three = bodies(STILL, STILL, STILL)._replace(kind=np.array([0, 1, 0]))
    wanted = np.array([[False, False], [True, False]])
    found = touches(three, wanted)
    assert list(zip(found.first.tolist(), found.second.tolist(), strict=True)) == [(0, 1), (1, 2)]


def test_a_crowd_gives_what_each_pair_gives_alone():
    chance = np.random.default_rng(2)
    rows = [
        (chance.normal(size=3) * 3, chance.normal(size=3) * 3, chance.uniform(0.1, 0.5)) for _ in range(40)
    ]
    rows += [(*row, FRONT) for row in rows[:4]]
    crowd = touches(bodies(*rows), ALL)
    for at, (first, second) in enumerate(zip(crowd.first, crowd.second, strict=True)):
        alone = touches(bodies(rows[first], rows[second]), ALL)
        assert [array[at].tolist() for array in crowd[2:]] == [array[0].tolist() for array in alone[2:]]
    assert len(crowd.first) > 20
