"""Crossings and hits (FAQ Q31 to Q33) over any leading axes: points (…, 3) and radii (…) metres, fractions 0…1 of a step.

Four formulas of the FAQ are misprinted; each correct form stands where it is used. Element by element: one pair and a thousand get the same
bits.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths import vector
from statwalk.maths.arrays import Bools, Floats

APART, MEET, INSIDE, CONCENTRIC = range(4)
"""how two spheres lie: without a common point; with a circle (or a point) in common; one within the other; around the same centre"""


class Hit(NamedTuple):
    """Whether something is met on the way, and when."""

    is_hit: Bools
    fraction: Floats
    """of the way, 0…1; 0 where nothing is met"""


class Roots(NamedTuple):
    """Where a line meets a sphere: `first` <= `second`, as multiples of its step; both 0 where there is no root."""

    roots: NDArray[np.int8]
    """0, 1 or 2"""
    first: Floats
    second: Floats


class Plane(NamedTuple):
    """The plane in which two spheres meet (CD3), where `kind` is MEET; all else is 0 elsewhere."""

    kind: NDArray[np.uint8]
    """APART, MEET, INSIDE or CONCENTRIC"""
    normal: Floats
    """(…, 3) from the first centre towards the second"""
    point: Floats
    """(…, 3) the centre of the circle that they share"""
    radius: Floats
    """of that circle; 0 where they just touch"""


def plane_value(normal: Floats, on: Floats, point: Floats) -> Floats:
    """The plane equation at `point`: metres in front of the plane through `on` with a unit `normal` (negative: behind)."""
    return vector.dot(normal, point - on)


def crossing(old: Floats, new: Floats) -> Hit:
    """Whether a point has crossed a plane, from the plane's value at its old place and at its new one (CD1, FAQ Q31).

    A point on the plane counts as in front: a crossing that stops on it for a tick is reported once.
    """
    crosses = (old >= 0) != (new >= 0)
    return Hit(crosses, np.where(crosses, old / np.where(crosses, old - new, 1), 0))


def crossing_point(old: Floats, new: Floats, from_point: Floats, to_point: Floats) -> Floats:
    """(ro·Pn − rn·Po)/(ro − rn), where the sign changes; the FAQ prints (ro·Po + rn·Pn)/(rn − ro)."""
    apart = np.where(old == new, 1, old - new)
    return (old[..., None] * to_point - new[..., None] * from_point) / apart[..., None]


def line_sphere(start: Floats, step: Floats, center: Floats, radius: Floats) -> Roots:
    """The roots of A t² + B t + C = 0 for the line `start` + t·`step` (CD2, FAQ Q32).

    A = Pd·Pd, B = 2 Pd·(Ps − Pp), C = |Ps − Pp|² − R²; the FAQ prints A without squares, and B and C with wrong terms.
    """
    a, b, _, inside_root = _quadratic(start, step, center, radius)
    meets = (inside_root >= 0) & (a > 0)
    root, double = np.sqrt(np.where(meets, inside_root, 0)), np.where(meets, 2 * a, 1)
    number = np.where(meets, np.where(inside_root > 0, 2, 1), 0).astype(np.int8)
    return Roots(number, np.where(meets, (-b - root) / double, 0), np.where(meets, (-b + root) / double, 0))


def segment_sphere(start: Floats, end: Floats, center: Floats, radius: Floats) -> Hit:
    """The first point of the segment within the sphere: the smallest root in 0…1, and 0 where it starts inside (or on it)."""
    _, b, c, inside_root = _quadratic(start, end - start, center, radius)
    comes = (inside_root >= 0) & (b < 0)
    below = np.where(comes, np.sqrt(np.where(comes, inside_root, 0)) - b, 1)
    fraction = np.where(c <= 0, 0, 2 * c / below)  # the smaller root without a difference of numbers that are nearly the same
    is_hit = (c <= 0) | (comes & (fraction <= 1))
    return Hit(is_hit, np.where(is_hit, fraction, 0))


def swept_spheres(a0: Floats, a1: Floats, a_radius: Floats, b0: Floats, b1: Floats, b_radius: Floats) -> Hit:
    """Two spheres that go straight from their first to their second places: the way of one seen from the other, against both radii."""
    return segment_sphere(a0 - b0, a1 - b1, np.zeros(3), a_radius + b_radius)


def gap(a: Floats, a_radius: Floats, b: Floats, b_radius: Floats) -> Floats:
    """D = |Pb − Pa| − Ra − Rb: metres between the spheres; negative where they overlap, 0 where they just touch (CD3, FAQ Q33)."""
    return vector.length(b - a) - a_radius - b_radius


def meeting(a: Floats, a_radius: Floats, b: Floats, b_radius: Floats) -> Plane:
    """The plane in which two spheres meet: at (d² + Ra² − Rb²)/(2d) from Pa along unit(Pb − Pa).

    The FAQ prints the point Ra/(Ra + Rb) along, which is right only for spheres that just touch.
    """
    apart = b - a
    distance = vector.length(apart)
    kind = np.select(
        [distance > a_radius + b_radius, distance == 0, distance < np.abs(a_radius - b_radius)], [APART, CONCENTRIC, INSIDE], MEET
    ).astype(np.uint8)
    meet = kind == MEET
    along = np.where(meet, (distance * distance + a_radius * a_radius - b_radius * b_radius) / np.where(meet, 2 * distance, 1), 0)
    normal = np.where(meet[..., None], apart / np.where(meet, distance, 1)[..., None], 0)
    left = np.where(meet, a_radius * a_radius - along * along, 0)
    return Plane(kind, normal, np.where(meet[..., None], a + normal * along[..., None], 0), np.sqrt(np.maximum(left, 0)))


def _quadratic(start: Floats, step: Floats, center: Floats, radius: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """A, B, C and the discriminant B² − 4AC, which is 4(A R² − |Pd × (Ps − Pp)|²): so without a difference of large numbers."""
    away = start - center
    a, b, c = vector.dot(step, step), 2 * vector.dot(step, away), vector.dot(away, away) - radius * radius
    across = vector.cross(step, away)
    return a, b, c, 4 * (a * radius * radius - vector.dot(across, across))
