"""The distance of two triangle surfaces in the plain way: every sample from every triangle, one by one
(Ericson, Real-Time Collision Detection, 5.1.5).
"""

import numpy as np

Surface = tuple[np.ndarray, np.ndarray]


def closest(p: np.ndarray, a: np.ndarray, b: np.ndarray, c: np.ndarray) -> np.ndarray:
    """The point of a triangle that is closest to `p`."""
    ab, ac, ap = b - a, c - a, p - a
    d1, d2 = ab @ ap, ac @ ap
    if d1 <= 0 and d2 <= 0:
        return a
    d3, d4 = ab @ (p - b), ac @ (p - b)
    if d3 >= 0 and d4 <= d3:
        return b
    if d1 * d4 - d3 * d2 <= 0 <= d1 and d3 <= 0:
        return a + d1 / (d1 - d3) * ab
    d5, d6 = ab @ (p - c), ac @ (p - c)
    if d6 >= 0 and d5 <= d6:
        return c
    if d5 * d2 - d1 * d6 <= 0 <= d2 and d6 <= 0:
        return a + d2 / (d2 - d6) * ac
    va = d3 * d6 - d5 * d4
    if va <= 0 and d4 - d3 >= 0 and d5 - d6 >= 0:
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)
    vb, vc = d5 * d2 - d1 * d6, d1 * d4 - d3 * d2
    return a + vb / (va + vb + vc) * ab + vc / (va + vb + vc) * ac


def from_surface(point: np.ndarray, surface: Surface) -> float:
    """The distance of a point from a surface; triangles whose box is further than the best so far are
    skipped.
    """
    points, faces = surface
    corners = points[faces]
    outside = np.maximum(corners.min(1) - point, 0) + np.maximum(point - corners.max(1), 0)
    bound, best = np.linalg.norm(outside, axis=1), np.inf
    for row in np.argsort(bound):
        if bound[row] >= best:
            return best
        best = min(best, float(np.linalg.norm(point - closest(point, *corners[row]))))
    return best


def distance(full: Surface, coarse: Surface, samples: int) -> float:
    """The largest distance of random samples of each surface from the other."""
    chance = np.random.default_rng(7)
    furthest = 0.0
    for source, target in ((full, coarse), (coarse, full)):
        points, faces = source
        rows = chance.integers(len(faces), size=samples)
        shares = chance.dirichlet((1, 1, 1), samples)
        for row, share in zip(rows, shares, strict=True):
            furthest = max(furthest, from_surface(share @ points[faces[row]], target))
    return furthest
