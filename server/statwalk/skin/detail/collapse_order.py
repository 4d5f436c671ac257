"""Finds the order in which the vertices of a surface collapse: the edges that cost least first.

A pass looks at all edges at once, and collapses the cheap ones that do not touch each other; so a surface
of a hundred thousand triangles takes seconds without a compiled loop.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.skin.collapses import remaining, same_rows
from statwalk.skin.detail.collapsible_edges import Edges, border_edges, collapsible, folds
from statwalk.skin.detail.quadrics import Quadrics, quadrics

CHEAPEST = 0.25
"""the share of the edges that a pass may collapse"""


class CollapsePass(NamedTuple):
    """The collapses of a pass, cheapest first, and the faces that it leaves.

    vertices, onto   (K,) vertices that move, and the vertices that they move onto
    order            (K,) the number of the collapse in the pass: vertices at one place share it
    faces            (T,3)
    """

    vertices: Ints
    onto: Ints
    order: Ints
    faces: Ints


def collapse_passes(shapes: Sequence[Floats], faces: Ints) -> Iterator[CollapsePass]:
    """Yields passes until no edge can collapse.

    shapes  (V,n) the vertices in several poses, metres; the first three columns are their place, further
            ones, in metres too, what else should stay: texture coordinates, normals, colours
    faces   (T,3) vertices
    """
    place = places_of(shapes)
    count = int(place.max(initial=-1)) + 1
    points = np.zeros((count, 3))
    points[place] = shapes[0][:, :3]
    faces = remaining(faces, np.arange(len(place)), place)
    borders = border_edges(faces, place)
    errors = [quadrics(shape, faces, borders) for shape in shapes]
    while len(faces):
        edges = collapsible(faces, place, count)
        edges, cost = _cheap(edges, _costs(edges, shapes, errors))
        fits = ~folds(edges, points, faces, place)
        edges, cost = edges.take(fits), cost[fits]
        if not len(cost):
            return
        chosen, rank = _apart(edges, cost, place[faces], count)
        stands_for = np.arange(len(place))
        stands_for[chosen.vertex] = chosen.onto
        faces = remaining(faces, stands_for, place)
        for error in errors:
            error.add(chosen.vertex, chosen.onto)
        order = rank[chosen.edge]
        by_cost = np.argsort(order, kind="stable")
        yield CollapsePass(chosen.vertex[by_cost], chosen.onto[by_cost], order[by_cost], faces)


def places_of(shapes: Sequence[Floats]) -> Ints:
    """Returns (V,) the place of each vertex: the same for vertices that lie together in all shapes (V,n)."""
    return same_rows(np.concatenate([shape[:, :3] for shape in shapes], axis=1))


def _costs(edges: Edges, shapes: Sequence[Floats], errors: Sequence[Quadrics]) -> Floats:
    """(E,) the mean squared distance from the planes that a collapse leaves, in the shape in which it is
    largest.
    """
    worst = np.zeros(len(edges.start))
    for shape, error in zip(shapes, errors, strict=True):
        goal = shape[edges.onto]
        sums = error.at(edges.vertex, goal) + error.at(edges.onto, goal)
        weight = error.weight[edges.vertex] + error.weight[edges.onto]
        total, weights = (np.bincount(edges.edge, values, len(worst)) for values in (sums, weight))
        worst = np.maximum(worst, total / np.where(weights > 0, weights, 1))
    return worst


def _cheap(edges: Edges, cost: Floats) -> tuple[Edges, Floats]:
    """The cheapest edges, with their costs."""
    if not len(cost):
        return edges, cost
    kept: Bools = cost <= np.quantile(cost, CHEAPEST)
    return edges.take(kept), cost[kept]


def _apart(edges: Edges, cost: Floats, corners: Ints, places: int) -> tuple[Edges, Ints]:
    """The edges that are cheaper than all edges at the triangles (T,3) around both their ends, and the rank
    (E,) of each by cost.
    """
    rank = np.empty(len(cost), np.int64)
    rank[np.argsort(cost, kind="stable")] = np.arange(len(cost))
    best = np.full(places, len(cost))
    for ends in (edges.start, edges.end):
        np.minimum.at(best, ends, rank)
    nearby = best.copy()
    for corner in corners.T:
        np.minimum.at(nearby, corner, best[corners].min(axis=1))
    least = (nearby[edges.start] == rank) & (nearby[edges.end] == rank)
    chosen = edges.take(least)
    return chosen, np.argsort(np.argsort(rank[least]))
