"""Touches between spheres and planes that move within a tick (FAQ Q30 to Q33): the pairs, their times and
points. Metres, stage space.

Each collider moves straight from its old to its new position; both colliders of a pair may move. A plane is a
thin sheet: a sphere touches it while it intersects it, from either side, and an actor that passes through it
within a tick touches it too.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numba import types
from numpy.typing import NDArray

from statwalk.maths import vector
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.compiling import LONG, kernel, read
from statwalk.maths.intersect import Hit, plane_value, swept_spheres
from statwalk.world.grid import ROUNDING, Pairs, overlapping

_DOUBLE = types.float64
FEW = 32
"""number of colliders up to which every pair is tested"""


class Bodies(NamedTuple):
    """C colliders, before and after a step."""

    owner: NDArray[np.int64]
    """(C,) the actor; colliders of one actor do not touch each other"""
    kind: Ints
    """(C,) 0 … K − 1; pairs are wanted by their kinds"""
    before: Floats
    """(C, 3) centres"""
    now: Floats
    """(C, 3)"""
    radius: Floats
    """(C,) of a sphere, or of a plane's disc; 0: an endless plane"""
    is_plane: Bools
    """(C,)"""
    normal_before: Floats
    """(C, 3) unit, of planes"""
    normal: Floats
    """(C, 3)"""

    def _reversed(self) -> Bodies:
        """The same step backwards."""
        return self._replace(
            before=self.now, now=self.before, normal_before=self.normal, normal=self.normal_before
        )

    def take(self, rows: Ints) -> Bodies:
        """Returns the colliders of some rows."""
        return Bodies._make(array[rows] for array in self)


_NONE, _NOWHERE = np.zeros(0), np.zeros((0, 3))
_NO_ROWS = _NONE.astype(np.int64)
NO_BODIES = Bodies(_NO_ROWS, _NO_ROWS, _NOWHERE, _NOWHERE, _NONE, _NONE.astype(bool), _NOWHERE, _NOWHERE)


class Touches(NamedTuple):
    """Pairs that touch within the step, sorted by their rows."""

    first: Ints
    second: Ints
    start: Floats
    """fraction 0…1 of the step at which the touch begins; 0 if it began before the step"""
    end: Floats
    """fraction at which the touch ends; 1 if it lasts beyond the step"""
    lasts: Bools
    """whether the pair still touches at the end of the step"""
    point_at_start: Floats
    """(P, 3) the point of contact"""
    point_at_end: Floats
    """(P, 3)"""


NOBODY = Touches(_NO_ROWS, _NO_ROWS, _NONE, _NONE, _NONE.astype(bool), _NOWHERE, _NOWHERE)


def touches(bodies: Bodies, wanted: Bools) -> Touches:
    """Returns all pairs of different owners that touch, of kinds with `wanted` (K, K) in either order.

    Planes do not touch planes.
    """
    if len(bodies.owner) <= FEW and not _is_any_near(*_compared(bodies, wanted)):
        return NOBODY
    pairs = _candidates(bodies, wanted)
    if not len(pairs.first):
        return NOBODY
    a, b = bodies.take(pairs.first), bodies.take(pairs.second)
    forward, backward = _met(a, b), _met(a._reversed(), b._reversed())
    both = (forward.is_hit | backward.is_hit).nonzero()[0]
    a, b, start, left = a.take(both), b.take(both), forward.fraction[both], backward.fraction[both]
    end = 1 - left
    lasts = backward.is_hit[both] & (left <= 0)
    start = np.where(forward.is_hit[both], start, end)
    end = np.maximum(
        end, start
    )  # an actor that passes through a sheet enters and leaves at the same time, but for rounding
    return Touches(
        pairs.first[both], pairs.second[both], start, end, lasts, _point(a, b, start), _point(a, b, end)
    )


def _compared(bodies: Bodies, wanted: Bools) -> tuple[Any, ...]:
    """The arguments of `_is_any_near`."""
    kind = np.ascontiguousarray(bodies.kind, np.int64)
    columns = bodies.owner, kind, bodies.before, bodies.now, bodies.radius, bodies.is_plane, wanted
    return tuple(np.ascontiguousarray(column) for column in columns)


@kernel(
    read(LONG, 1), read(LONG, 1), read(_DOUBLE, 2), read(_DOUBLE, 2), read(_DOUBLE, 1),
    read(types.boolean, 1), read(types.boolean, 2), returns=types.boolean,
)  # fmt: skip
def _is_any_near(
    owner: Any, kind: Any, before: Any, now: Any, radius: Any, is_plane: Any, wanted: Any
) -> bool:
    """Whether `_candidates` would find any pair: among few colliders testing each pair costs less than
    sorting them into cubes.
    """
    for i in range(len(owner)):
        for j in range(i + 1, len(owner)):
            fits = wanted[kind[i], kind[j]] or wanted[kind[j], kind[i]]
            if not fits or owner[i] == owner[j] or (is_plane[i] and is_plane[j]):
                continue
            if (is_plane[i] and radius[i] <= 0) or (is_plane[j] and radius[j] <= 0):
                return True
            apart, steps_i, steps_j = 0.0, 0.0, 0.0
            for axis in range(3):
                step_i, step_j = now[i, axis] - before[i, axis], now[j, axis] - before[j, axis]
                away = (before[j, axis] + step_j * 0.5) - (before[i, axis] + step_i * 0.5)
                apart += away * away
                steps_i += step_i * step_i
                steps_j += step_j * step_j
            reach = radius[i] + math.sqrt(steps_i) * 0.5 + (radius[j] + math.sqrt(steps_j) * 0.5)
            reach *= ROUNDING
            if apart <= reach * reach:
                return True
    return False


def _candidates(bodies: Bodies, wanted: Bools) -> Pairs:
    """Pairs that are near enough for an exact test, sorted."""
    is_endless = bodies.is_plane & (bodies.radius <= 0)
    bounded, endless = (~is_endless).nonzero()[0], is_endless.nonzero()[0]
    step = bodies.now[bounded] - bodies.before[bounded]
    near = overlapping(
        bodies.before[bounded] + step * 0.5, bodies.radius[bounded] + vector.length(step) * 0.5
    )
    first = np.concatenate([bounded[near.first], np.arange(len(bodies.owner)).repeat(len(endless))])
    second = np.concatenate([bounded[near.second], np.tile(endless, len(bodies.owner))])
    kinds = bodies.kind[first], bodies.kind[second]
    fits = (
        (wanted | wanted.T)[kinds]
        & (bodies.owner[first] != bodies.owner[second])
        & ~(bodies.is_plane[first] & bodies.is_plane[second])
    )
    low, high = np.minimum(first, second)[fits], np.maximum(first, second)[fits]
    order = (low * len(bodies.owner) + high).argsort(kind="stable")
    return Pairs(low[order], high[order])


def _met(a: Bodies, b: Bodies) -> Hit:
    """The time at which the colliders of each pair begin to touch."""
    hit = swept_spheres(a.before, a.now, a.radius, b.before, b.now, b.radius)
    flat = (a.is_plane | b.is_plane).nonzero()[0]
    if len(flat):
        is_first = a.is_plane[flat, None]
        sheet = Bodies._make(
            _chosen(is_first, of_a[flat], of_b[flat]) for of_a, of_b in zip(a, b, strict=True)
        )
        sphere = Bodies._make(
            _chosen(is_first, of_b[flat], of_a[flat]) for of_a, of_b in zip(a, b, strict=True)
        )
        hit.is_hit[flat], hit.fraction[flat] = _sheet_met(sphere, sheet)
    return hit


def _chosen(is_first: Bools, first: NDArray[Any], second: NDArray[Any]) -> NDArray[Any]:
    return np.where(is_first if first.ndim > 1 else is_first[:, 0], first, second)


def _sheet_met(sphere: Bodies, sheet: Bodies) -> Hit:
    """The time at which spheres begin to intersect sheets: the signed distance of the centre from the plane
    changes (CD1).

    A centre on the plane counts as in front, so a point (a sphere of radius 0) crosses once, however long it
    stays there.
    """
    old = plane_value(sheet.normal_before, sheet.before, sphere.before)
    new = plane_value(sheet.normal, sheet.now, sphere.now)
    front = old >= 0
    distance, later = np.abs(old), np.where(front, new, -new)
    inside = _reaches(front, distance, sphere.radius)
    comes = ~inside & _reaches(front, later, sphere.radius)
    fraction = np.where(comes, (distance - sphere.radius) / np.where(comes, distance - later, 1), 0)
    is_hit = (inside | comes) & _is_over(sphere, sheet, fraction)
    return Hit(is_hit, np.where(is_hit, fraction, 0))


def _reaches(front: Bools, distance: Floats, radius: Floats) -> Bools:
    return np.where(front, distance < radius, distance <= radius)


def _is_over(sphere: Bodies, sheet: Bodies, fraction: Floats) -> Bools:
    """Whether the sphere's centre is over the disc at that fraction; always true for an endless plane."""
    part = fraction[:, None]
    away = _at(sphere, part) - _at(sheet, part)
    normal = sheet.normal_before + (sheet.normal - sheet.normal_before) * part
    height = vector.dot(away, normal)
    along = vector.dot(away, away) - height * height
    return (sheet.radius <= 0) | (along <= sheet.radius * sheet.radius)


def _at(body: Bodies, part: Floats) -> Floats:
    return body.before + (body.now - body.before) * part


def _point(a: Bodies, b: Bodies, fraction: Floats) -> Floats:
    """The point of contact: between the spheres' centres by their radii; on a sheet below the sphere's
    centre.
    """
    part = fraction[:, None]
    first, second = _at(a, part), _at(b, part)
    size = a.radius + b.radius
    point = (
        first + (second - first) * np.where(size > 0, a.radius / np.where(size > 0, size, 1), 0.5)[:, None]
    )
    for sphere, sheet, center, on in ((b, a, second, first), (a, b, first, second)):
        normal = sheet.normal_before + (sheet.normal - sheet.normal_before) * part
        foot = center - normal * vector.dot(center - on, normal)[:, None]
        point = np.where((sheet.is_plane & ~sphere.is_plane)[:, None], foot, point)
    return point
