"""Quake II's normals: the corners of an icosahedron whose edges are cut in four, pushed out to a sphere.

This file makes the corners itself, from the golden ratio; assimp, in `test_ff4.py`, has their order.
"""

from itertools import combinations

import numpy as np
from statwalk.files.md2.md2_normals import NORMALS, nearest_normals

GOLDEN = (1 + 5**0.5) / 2


def halved(points: np.ndarray, edge: float) -> np.ndarray:
    """The corners of flat triangles with the middles of their edges, which have a length."""
    pairs = [(a, b) for a, b in combinations(points, 2) if np.sqrt(((a - b) ** 2).sum()) < 1.01 * edge]
    return np.concatenate([points, [(a + b) / 2 for a, b in pairs]])


def sphere() -> np.ndarray:
    """An icosahedron with edges of 2, cut and cut again, then pushed out to the unit sphere."""
    signs = [(a, b) for a in (-1, 1) for b in (-1, 1)]
    points = np.array([np.roll((a, 0, b * GOLDEN), turn) for turn in range(3) for a, b in signs])
    cut = halved(halved(points, 2.0), 1.0)
    return cut / np.sqrt((cut**2).sum(-1, keepdims=True))


def test_they_are_the_corners_of_the_cut_icosahedron() -> None:
    expected = sphere()
    assert len(expected) == len(NORMALS) == 162
    found = expected[(expected @ NORMALS.T).argmax(0)]
    assert np.abs(found - NORMALS).max() < 1e-6
    assert len(np.unique(NORMALS, axis=0)) == 162


def test_the_nearest_is_found() -> None:
    chance = np.random.default_rng(3)
    vectors = chance.normal(size=(40, 7, 3))
    vectors /= np.sqrt((vectors**2).sum(-1, keepdims=True))
    away = ((vectors[:, :, None] - NORMALS) ** 2).sum(-1)
    assert np.array_equal(nearest_normals(vectors), away.argmin(-1))


def test_each_is_its_own_nearest() -> None:
    assert nearest_normals(NORMALS).tolist() == list(range(162))
