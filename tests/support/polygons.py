"""Plane polygons: how deep two of them overlap."""

import numpy as np


def inside(points, polygon):
    """Whether points (N, 2) lie in a polygon (M, 2): crossings of the ray to +x, odd."""
    x, y = points[:, None, 0], points[:, None, 1]
    x0, y0 = polygon.T
    x1, y1 = np.roll(polygon, -1, 0).T
    spans = (y0 > y) != (y1 > y)
    at = x0 + (y - y0) * (x1 - x0) / np.where(y1 == y0, 1, y1 - y0)
    return (spans & (x < at)).sum(1) % 2 == 1


def distance_to_edge(points, polygon):
    """(N,) the distance of points to the nearest edge of a polygon."""
    start, way = polygon, np.roll(polygon, -1, 0) - polygon
    apart = points[:, None] - start
    along = np.clip((apart * way).sum(-1) / np.maximum((way * way).sum(-1), 1e-300), 0, 1)
    return np.linalg.norm(apart - along[..., None] * way, axis=-1).min(1)


def refined(polygon, parts=6):
    """The polygon with points along each edge."""
    share = np.arange(parts)[None, :, None] / parts
    ends = np.roll(polygon, -1, 0)
    return (polygon[:, None] * (1 - share) + ends[:, None] * share).reshape(-1, 2)


def overlap(a, b):
    """The depth to which either polygon's edge lies in the other, 0 if they are apart."""
    deepest = 0.0
    for points, polygon in ((refined(a), b), (refined(b), a)):
        near = points[inside(points, polygon)]
        if len(near):
            deepest = max(deepest, float(distance_to_edge(near, polygon).max()))
    return deepest
