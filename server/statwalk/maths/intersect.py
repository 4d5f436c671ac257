"""Crossings and hits (FAQ Q31 to Q33) over any leading axes: points (…, 3) and radii (…) metres, fractions
0…1 of a step.

Four formulas of the FAQ are misprinted; each docstring gives the correct form. Results are computed element
by element: one pair and a thousand get the same bits.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths import vector
from statwalk.maths.arrays import Bools, Floats

APART, MEET, INSIDE, CONCENTRIC = range(4)
"""relations of two spheres: without a common point; with a common circle (or point); one within the other;
with one centre
"""


class Hit(NamedTuple):
    """Whether a moving point or sphere hits its target, and at which fraction of the step."""

    is_hit: Bools
    fraction: Floats
    """of the step, 0…1; 0 for no hit"""


class Roots(NamedTuple):
    """The points at which a line meets a sphere: `first` <= `second`, as multiples of its step; both 0
    without a root.
    """

    roots: NDArray[np.int8]
    """number of roots: 0, 1 or 2"""
    first: Floats
    second: Floats


class Plane(NamedTuple):
    """The plane of the circle that two spheres share (CD3), if `kind` is MEET; else all other
    fields are 0.
    """

    kind: NDArray[np.uint8]
    """APART, MEET, INSIDE or CONCENTRIC"""
    normal: Floats
    """(…, 3) from the first centre towards the second"""
    point: Floats
    """(…, 3) the centre of the shared circle"""
    radius: Floats
    """of the shared circle; 0 if the spheres just touch"""


def plane_value(normal: Floats, on: Floats, point: Floats) -> Floats:
    """Returns the plane equation at `point`: metres in front of the plane through `on` with a unit `normal`
    (negative: behind).
    """
    return vector.dot(normal, point - on)


def crossing(old: Floats, new: Floats) -> Hit:
    """Returns whether a point has crossed a plane, from the plane's values at its old and new position (CD1,
    FAQ Q31).

    A point on the plane counts as in front: a crossing that stops on the plane for a tick is reported once.
    """
    crosses = (old >= 0) != (new >= 0)
    return Hit(crosses, np.where(crosses, old / np.where(crosses, old - new, 1), 0))


def crossing_point(old: Floats, new: Floats, from_point: Floats, to_point: Floats) -> Floats:
    """Returns (ro·Pn − rn·Po)/(ro − rn), the point at which the sign changes; the FAQ prints (ro·Po +
    rn·Pn)/(rn − ro).
    """
    apart = np.where(old == new, 1, old - new)
    return (old[..., None] * to_point - new[..., None] * from_point) / apart[..., None]


def line_sphere(start: Floats, step: Floats, center: Floats, radius: Floats) -> Roots:
    """Returns the roots of A t² + B t + C = 0 for the line `start` + t·`step` (CD2, FAQ Q32).

    A = Pd·Pd, B = 2 Pd·(Ps − Pp), C = |Ps − Pp|² − R²; the FAQ prints A without squares, and B and C with
    wrong terms.
    """
    a, b, _, inside_root = _quadratic(start, step, center, radius)
    meets = (inside_root >= 0) & (a > 0)
    root, double = np.sqrt(np.where(meets, inside_root, 0)), np.where(meets, 2 * a, 1)
    number = np.where(meets, np.where(inside_root > 0, 2, 1), 0).astype(np.int8)
    return Roots(number, np.where(meets, (-b - root) / double, 0), np.where(meets, (-b + root) / double, 0))


def segment_sphere(start: Floats, end: Floats, center: Floats, radius: Floats) -> Hit:
    """Returns the first hit of the segment with the sphere: the smallest root in 0…1, or 0 if the segment
    starts inside the sphere (or on it).
    """
    _, b, c, inside_root = _quadratic(start, end - start, center, radius)
    comes = (inside_root >= 0) & (b < 0)
    below = np.where(comes, np.sqrt(np.where(comes, inside_root, 0)) - b, 1)
    fraction = np.where(
        c <= 0, 0, 2 * c / below
    )  # the smaller root without a difference of numbers that are nearly the same
    is_hit = (c <= 0) | (comes & (fraction <= 1))
    return Hit(is_hit, np.where(is_hit, fraction, 0))


def swept_spheres(a0: Floats, a1: Floats, a_radius: Floats, b0: Floats, b1: Floats, b_radius: Floats) -> Hit:
    """Returns the first hit of two spheres that move straight from their first to their second positions: the
    relative movement against the sum of the radii.
    """
    return segment_sphere(a0 - b0, a1 - b1, np.zeros(3), a_radius + b_radius)


def gap(a: Floats, a_radius: Floats, b: Floats, b_radius: Floats) -> Floats:
    """Returns D = |Pb − Pa| − Ra − Rb: metres between the spheres; negative if they overlap, 0 if they just
    touch (CD3, FAQ Q33).
    """
    return vector.length(b - a) - a_radius - b_radius


def meeting(a: Floats, a_radius: Floats, b: Floats, b_radius: Floats) -> Plane:
    """Returns the plane of the circle that two spheres share: at (d² + Ra² − Rb²)/(2d) from Pa along unit(Pb
    − Pa).

    The FAQ prints the point Ra/(Ra + Rb) along, which is right only for spheres that just touch.
    """
    apart = b - a
    distance = vector.length(apart)
    kind = np.select(
        [distance > a_radius + b_radius, distance == 0, distance < np.abs(a_radius - b_radius)],
        [APART, CONCENTRIC, INSIDE],
        MEET,
    ).astype(np.uint8)
    meet = kind == MEET
    along = np.where(
        meet,
        (distance * distance + a_radius * a_radius - b_radius * b_radius) / np.where(meet, 2 * distance, 1),
        0,
    )
    normal = np.where(meet[..., None], apart / np.where(meet, distance, 1)[..., None], 0)
    left = np.where(meet, a_radius * a_radius - along * along, 0)
    return Plane(
        kind,
        normal,
        np.where(meet[..., None], a + normal * along[..., None], 0),
        np.sqrt(np.maximum(left, 0)),
    )


def _quadratic(
    start: Floats, step: Floats, center: Floats, radius: Floats
) -> tuple[Floats, Floats, Floats, Floats]:
    """A, B, C and the discriminant B² − 4AC, computed as 4(A R² − |Pd × (Ps − Pp)|²): without a difference of
    large numbers.
    """
    away = start - center
    a, b, c = vector.dot(step, step), 2 * vector.dot(step, away), vector.dot(away, away) - radius * radius
    across = vector.cross(step, away)
    return a, b, c, 4 * (a * radius * radius - vector.dot(across, across))
