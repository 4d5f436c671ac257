"""Whom a member of a flock sees, held against all pairs."""

import numpy as np
import pytest
from statwalk.world import grid, sight
from statwalk.world.sight import nearest_seen

CHANCE = np.random.default_rng(5)


def brute(position, forward, reach, sight_cos, count):
    """The rows that each member sees, nearest first, one by one."""
    found = []
    for me in range(len(position)):
        away = position - position[me]
        distance = np.linalg.norm(away, axis=1)
        seen = [
            (distance[other], other)
            for other in range(len(position))
            if other != me
            and distance[other] <= reach
            and away[other] @ forward[me] >= sight_cos * distance[other]
        ]
        found.append([other for _, other in sorted(seen)[:count]])
    return found


def flock(members, size):
    forward = CHANCE.normal(size=(members, 3))
    return CHANCE.uniform(0, size, (members, 3)), forward / np.linalg.norm(forward, axis=1, keepdims=True)


@pytest.mark.parametrize(
    ("members", "size", "reach"), [(300, 10, 3.0), (300, 3, 5.0), (60, 100, 5.0), (1, 1, 5.0), (0, 1, 5.0)]
)
@pytest.mark.parametrize("sight_cos", [-1.0, -0.5, 0.7])
def test_the_nearest_in_the_field_of_view(members, size, reach, sight_cos):
    position, forward = flock(members, size)
    rows, distance = nearest_seen(position, forward, reach, sight_cos, 5)
    assert [[other for other in row if other >= 0] for row in rows.tolist()] == brute(
        position, forward, reach, sight_cos, 5
    )
    assert (np.isinf(distance) == (rows < 0)).all()


@pytest.mark.parametrize("radius", [0.1, 1.0, 4.0])
def test_where_to_look_first_changes_nothing(radius, monkeypatch):
    position, forward = flock(200, 6)
    monkeypatch.setattr(sight, "first_look", lambda *_: radius)
    rows, _ = nearest_seen(position, forward, 4.0, 0.0, 6)
    assert [[other for other in row if other >= 0] for row in rows.tolist()] == brute(
        position, forward, 4.0, 0.0, 6
    )


def test_of_equally_near_ones_the_lower_row_comes_first():
    grid = np.array([[x, y, z] for x in range(4) for y in range(4) for z in range(4)], float)[::-1]
    ahead = np.tile([0.0, 0, 1], (64, 1))
    rows, _ = nearest_seen(grid, ahead, 3.0, -1.0, 6)
    assert rows.tolist() == brute(grid, ahead, 3.0, -1.0, 6)


def test_how_the_flock_is_divided_changes_nothing(monkeypatch):
    position, forward = flock(150, 4)
    whole = nearest_seen(position, forward, 3.0, -0.2, 7)
    monkeypatch.setattr(grid, "BLOCK", 70)
    for one, other in zip(whole, nearest_seen(position, forward, 3.0, -0.2, 7), strict=True):
        np.testing.assert_array_equal(one, other)
