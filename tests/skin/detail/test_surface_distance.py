"""The distance of surfaces: against figures by hand, and against the plain way."""

import numpy as np
import pytest
from slow_distance import closest, distance, from_surface
from statwalk.skin.detail.surface_distance import SurfaceDistance, squared_distance


def test_points_and_triangles_at_random() -> None:
    """Inside, beside edges and corners, and a triangle without area."""
    chance = np.random.default_rng(3)
    corners, points = chance.normal(size=(500, 3, 3)), 2 * chance.normal(size=(500, 3))
    corners[0] = corners[0, 0] + np.outer([0, 1, 2], [1.0, 0, 0])
    expected = [float(((p - closest(p, *c)) ** 2).sum()) for p, c in zip(points, corners, strict=True)]
    assert squared_distance(points, corners)[1:] == pytest.approx(expected[1:], abs=1e-9)
    along = np.clip(points[0, 0] - corners[0, 0, 0], 0, 2)
    apart = points[0] - corners[0, 0] - [along, 0, 0]
    assert squared_distance(points, corners)[0] == pytest.approx(apart @ apart)


def test_a_pyramid_whose_top_is_gone() -> None:
    """The top is its height away from the base; when the pyramid flattens it is less."""
    rest = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 0.3]])
    full = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
    measured = SurfaceDistance(rest, full, np.array([[0, 1, 2], [0, 2, 3]]))
    assert measured.largest(rest) == pytest.approx(0.3)
    assert measured.largest(rest * [1, 1, 0.5]) == pytest.approx(0.15)


def test_a_bumpy_sheet_against_the_plain_way() -> None:
    chance = np.random.default_rng(5)
    x, y = np.meshgrid(np.arange(12.0), np.arange(12.0))
    points = np.stack([x.ravel(), y.ravel(), 0.4 * chance.normal(size=144)], axis=1)
    cells = (np.arange(11) + 12 * np.arange(11)[:, None]).ravel()
    full = np.concatenate([cells[:, None] + [0, 1, 13], cells[:, None] + [0, 13, 12]])
    coarse = np.array([[0, 11, 143], [0, 143, 132]])
    measured = SurfaceDistance(points, full, coarse).largest(points)
    slow = max(from_surface(point, (points, coarse)) for point in points)
    assert measured >= distance((points, full), (points, coarse), 400) - 1e-9
    assert measured == pytest.approx(slow, rel=0.05)
