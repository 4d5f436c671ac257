"""Touches between spheres and planes that move within a tick (FAQ Q30 to Q33): who meets whom, when and where. Metres, stage space.

Each collider goes straight from where it was to where it is; both may move. A plane is a thin sheet: a sphere touches it while it reaches
through it, from either side, and whoever goes through it within a tick has touched it too.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths import vector
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.intersect import Hit, plane_value, swept_spheres
from statwalk.world.grid import Pairs, overlapping


class Bodies(NamedTuple):
    """C colliders, before and after a step."""

    owner: NDArray[np.int64]
    """(C,) the actor: it does not touch itself"""
    kind: Ints
    """(C,) 0 … K − 1: what is said of pairs is said of kinds"""
    before: Floats
    """(C, 3) centres"""
    now: Floats
    """(C, 3)"""
    radius: Floats
    """(C,) of a sphere, or of the disc that counts of a plane; 0: the plane has no end"""
    is_plane: Bools
    """(C,)"""
    normal_before: Floats
    """(C, 3) unit, of planes"""
    normal: Floats
    """(C, 3)"""

    def reversed(self) -> Bodies:
        """The same step backwards."""
        return self._replace(before=self.now, now=self.before, normal_before=self.normal, normal=self.normal_before)

    def take(self, rows: Ints) -> Bodies:
        """Some of them."""
        return Bodies._make(array[rows] for array in self)


class Touches(NamedTuple):
    """Pairs that meet within the step, sorted by their rows."""

    first: Ints
    second: Ints
    start: Floats
    """fraction 0…1 of the step at which they begin to touch; 0 where they did from its beginning"""
    end: Floats
    """fraction at which they cease to; 1 where they still touch"""
    lasts: Bools
    """they touch when the step is over"""
    point_at_start: Floats
    """(P, 3) where they touch"""
    point_at_end: Floats
    """(P, 3)"""


_NONE, _NOWHERE = np.zeros(0), np.zeros((0, 3))
NOBODY = Touches(_NONE.astype(np.int64), _NONE.astype(np.int64), _NONE, _NONE, _NONE.astype(bool), _NOWHERE, _NOWHERE)


def touches(bodies: Bodies, wanted: Bools) -> Touches:
    """All pairs of other owners that meet, of kinds for which `wanted` (K, K) says so, in either order. Planes do not touch planes."""
    pairs = _candidates(bodies, wanted)
    if not len(pairs.first):
        return NOBODY
    a, b = bodies.take(pairs.first), bodies.take(pairs.second)
    there, back = _met(a, b), _met(a.reversed(), b.reversed())
    both = (there.is_hit | back.is_hit).nonzero()[0]
    a, b, start, left = a.take(both), b.take(both), there.fraction[both], back.fraction[both]
    end = 1 - left
    lasts = back.is_hit[both] & (left <= 0)
    start = np.where(there.is_hit[both], start, end)
    end = np.maximum(end, start)  # whoever goes through a sheet is in and out at once, but for rounding
    return Touches(pairs.first[both], pairs.second[both], start, end, lasts, _point(a, b, start), _point(a, b, end))


def _candidates(bodies: Bodies, wanted: Bools) -> Pairs:
    """Pairs that are worth a closer look, sorted."""
    is_endless = bodies.is_plane & (bodies.radius <= 0)
    bounded, endless = (~is_endless).nonzero()[0], is_endless.nonzero()[0]
    step = bodies.now[bounded] - bodies.before[bounded]
    near = overlapping(bodies.before[bounded] + step * 0.5, bodies.radius[bounded] + vector.length(step) * 0.5)
    first = np.concatenate([bounded[near.first], np.arange(len(bodies.owner)).repeat(len(endless))])
    second = np.concatenate([bounded[near.second], np.tile(endless, len(bodies.owner))])
    kinds = bodies.kind[first], bodies.kind[second]
    fits = (wanted | wanted.T)[kinds] & (bodies.owner[first] != bodies.owner[second]) & ~(bodies.is_plane[first] & bodies.is_plane[second])
    low, high = np.minimum(first, second)[fits], np.maximum(first, second)[fits]
    order = (low * len(bodies.owner) + high).argsort(kind="stable")
    return Pairs(low[order], high[order])


def _met(a: Bodies, b: Bodies) -> Hit:
    """When the colliders of each pair begin to touch."""
    hit = swept_spheres(a.before, a.now, a.radius, b.before, b.now, b.radius)
    flat = (a.is_plane | b.is_plane).nonzero()[0]
    if len(flat):
        is_first = a.is_plane[flat, None]
        sheet = Bodies._make(_chosen(is_first, one[flat], other[flat]) for one, other in zip(a, b, strict=True))
        sphere = Bodies._make(_chosen(is_first, other[flat], one[flat]) for one, other in zip(a, b, strict=True))
        hit.is_hit[flat], hit.fraction[flat] = _sheet_met(sphere, sheet)
    return hit


def _chosen(is_first: Bools, first: NDArray[Any], second: NDArray[Any]) -> NDArray[Any]:
    return np.where(is_first if first.ndim > 1 else is_first[:, 0], first, second)


def _sheet_met(sphere: Bodies, sheet: Bodies) -> Hit:
    """When spheres begin to reach through sheets: their centres' distances from the planes change (CD1), and the side with it.

    On the plane counts as in front, so a point (a sphere of radius 0) crosses once, however long it stays there.
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
    """Whether the sphere's centre stands over the disc at that moment; always, over a plane without end."""
    part = fraction[:, None]
    away = _at(sphere, part) - _at(sheet, part)
    normal = sheet.normal_before + (sheet.normal - sheet.normal_before) * part
    height = vector.dot(away, normal)
    along = vector.dot(away, away) - height * height
    return (sheet.radius <= 0) | (along <= sheet.radius * sheet.radius)


def _at(body: Bodies, part: Floats) -> Floats:
    return body.before + (body.now - body.before) * part


def _point(a: Bodies, b: Bodies, fraction: Floats) -> Floats:
    """Where two touch: between the spheres' centres by their radii; below the sphere's centre on a sheet."""
    part = fraction[:, None]
    first, second = _at(a, part), _at(b, part)
    size = a.radius + b.radius
    point = first + (second - first) * np.where(size > 0, a.radius / np.where(size > 0, size, 1), 0.5)[:, None]
    for sphere, sheet, center, on in ((b, a, second, first), (a, b, first, second)):
        normal = sheet.normal_before + (sheet.normal - sheet.normal_before) * part
        foot = center - normal * vector.dot(center - on, normal)[:, None]
        point = np.where((sheet.is_plane & ~sphere.is_plane)[:, None], foot, point)
    return point
