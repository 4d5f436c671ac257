"""Who is near whom, held against all pairs."""

import numpy as np
import pytest
from statwalk.world import grid
from statwalk.world.grid import Grid, overlapping

CHANCE = np.random.default_rng(11)


def all_pairs(centers, reach):
    """Every pair of balls that overlap, by brute force."""
    distance = np.linalg.norm(centers[:, None] - centers[None], axis=-1)
    return set(zip(*np.triu(distance <= reach[:, None] + reach[None], 1).nonzero(), strict=True))


def crowds():
    yield "even", CHANCE.uniform(-20, 20, (300, 3)), np.full(300, 0.9)
    yield "of all sizes", CHANCE.uniform(-20, 20, (300, 3)), 10 ** CHANCE.uniform(-3, 1, 300)
    yield "in one place", np.zeros((40, 3)), np.full(40, 0.5)
    yield (
        "farther than the grid reaches",
        CHANCE.choice([-1e9, 0, 1e9], (60, 3)) + CHANCE.normal(size=(60, 3)),
        np.full(60, 0.7),
    )
    yield "points", np.array([[0.0, 0, 0], [0, 0, 0], [1, 0, 0]]), np.zeros(3)
    yield "nobody", np.zeros((0, 3)), np.zeros(0)


@pytest.mark.parametrize(
    ("centers", "reach"), [crowd[1:] for crowd in crowds()], ids=[crowd[0] for crowd in crowds()]
)
def test_no_overlapping_pair_is_missing(centers, reach):
    found = list(zip(*overlapping(centers, reach), strict=True))
    assert all_pairs(centers, reach) <= set(found)
    assert found == sorted(set(found))
    assert all(first < second for first, second in found)


def test_an_even_crowd_gives_few_pairs():
    centers = CHANCE.uniform(0, 100, (2000, 3))
    assert len(overlapping(centers, np.full(2000, 0.5)).first) < 2000 * 1999 / 2 / 500


def test_around_lists_the_neighbours_of_each_point_in_order():
    points = CHANCE.uniform(-5, 5, (200, 3))
    near = next(Grid(points, 1.5).around(points[50:60], 1.5))
    assert (np.diff(near.first) >= 0).all()
    for row in range(10):
        close = set(np.flatnonzero(np.linalg.norm(points - points[50 + row], axis=1) <= 1.5).tolist())
        assert close <= set(near.second[near.first == row].tolist())


def test_points_in_one_place_come_in_order_of_their_rows():
    points = np.tile([0.5, 0.5, 0.5], (5, 1))
    np.testing.assert_array_equal(next(Grid(points, 1.0).around(points[:1], 1.0)).second, range(5))


def test_in_blocks_of_any_size_the_same(monkeypatch):
    centers = CHANCE.uniform(-3, 3, (80, 3))
    whole = overlapping(centers, np.full(80, 0.8))
    monkeypatch.setattr(grid, "BLOCK", 50)
    for one, other in zip(whole, overlapping(centers, np.full(80, 0.8)), strict=True):
        np.testing.assert_array_equal(one, other)


def test_a_heap_of_thousands_is_not_looked_through(monkeypatch):
    monkeypatch.setattr(grid, "BLOCK", 1000)
    assert len(overlapping(np.zeros((400, 3)), np.ones(400), most=500).first) == 500
