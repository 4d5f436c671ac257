"""The twelve rules of the FAQ's inverse kinematics (Q26) in their correct form; IK1 to IK12.

A bone starts at SP, ends at EP, and has a length LEN and a unit direction DIR in its own space. RM turns its
own space into the character's; RA are the Euler angles of its turn relative to its parent; TR moves its start
away from the end of its parent, in the parent's space. P stands for the parent's: PSP, PEP, PRM, PLEN.
All functions work over any leading axes: points and vectors (…, 3), angles (…, 3) radians (about X first,
then Y, then Z), matrices (…, 3, 3) acting on column vectors, lengths (…) in the unit of the points.

Three rules are misprinted in the FAQ: rule 1 subtracts, rule 6 multiplies by the untransposed matrix, and
`findmatrix` aims at PEP instead of EP.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.intersect import line_sphere

_HALF_TURN = 1e-12
"""|u + v|² below which unit vectors u and v count as opposite: the axis u × v is then mere rounding"""


class JointPoint(NamedTuple):
    """The point at which two bones join, and how far it lies from satisfying the rule that found it."""

    point: Floats
    """(…, 3)"""
    miss: Floats
    """(…) 0 if the rule has a solution; else the shortest distance between the two sets that should meet,
    and the point is the nearest on the first sphere
    """


def start_from_parent(parent_end: Floats, parent_matrix: Floats, translation: Floats) -> Floats:
    """Returns, by rule 1, SP = PEP + PRM·TR; the FAQ prints a minus."""
    return parent_end + _times(parent_matrix, translation)


def own_translation(parent_matrix: Floats, start: Floats, parent_end: Floats) -> Floats:
    """Returns, by rule 2, TR = PRMᵀ·(SP − PEP)."""
    return _times(_transposed(parent_matrix), start - parent_end)


def parent_end_from_start(start: Floats, parent_matrix: Floats, translation: Floats) -> Floats:
    """Returns, by rule 3, PEP = SP − PRM·TR."""
    return start - _times(parent_matrix, translation)


def matrix_from_angles(parent_matrix: Floats, angles: Floats) -> Floats:
    """Returns, by rule 4, RM = PRM · R(RA)."""
    return parent_matrix @ quat.to_matrix(quat.from_euler_xyz(angles))


def angles_from_matrix(parent_matrix: Floats, matrix: Floats) -> Floats:
    """Returns, by rule 5, RA = euler(PRMᵀ · RM): Y in −π/2…π/2, and Z = 0 where Y is ±π/2."""
    return quat.to_euler_xyz(quat.from_matrix(_transposed(parent_matrix) @ matrix))


def parent_matrix_from_angles(matrix: Floats, angles: Floats) -> Floats:
    """Returns, by rule 6, PRM = RM · R(RA)ᵀ; the FAQ prints R(RA) without the ᵀ."""
    return matrix @ _transposed(quat.to_matrix(quat.from_euler_xyz(angles)))


def end_from_start(start: Floats, matrix: Floats, direction: Floats, length: Floats) -> Floats:
    """Returns, by rule 7, EP = SP + RM·DIR·LEN."""
    return start + _times(matrix, direction) * length[..., None]


def find_matrix(parent_matrix: Floats, direction: Floats, aim: Floats) -> Floats:
    """Returns, by rule 8, the RM that turns DIR towards `aim` = EP − SP by the shortest turn from PRM.

    v1 = PRM·DIR, v2 = unit(aim), RM = turn(axis v1 × v2, angle acos(v1·v2)) · PRM. Parallel vectors: PRM
    itself; opposite vectors: half a turn about any axis at right angles. A zero `aim` counts as parallel.
    The FAQ's `findmatrix` aims at PEP, where EP is meant.
    """
    old = vector.unit(_times(parent_matrix, direction))
    new = vector.unit(aim)
    new = np.where(vector.length(new)[..., None] > 0, new, old)
    return quat.to_matrix(_shortest_turn(old, new)) @ parent_matrix


def start_from_end(end: Floats, matrix: Floats, direction: Floats, length: Floats) -> Floats:
    """Returns, by rule 9, SP = EP − RM·DIR·LEN."""
    return end - _times(matrix, direction) * length[..., None]


def end_along_path(start: Floats, length: Floats, path: Floats) -> Floats:
    """Returns, by rule 10, EP = SP + LEN · unit(path); `path` (…, 3) is the direction of the motion path."""
    return start + vector.unit(path) * length[..., None]


def joint_on_path(parent_start: Floats, parent_length: Floats, point: Floats, path: Floats) -> JointPoint:
    """Returns, by rule 11, PEP where the line through `point` along `path` meets sphere(PSP, PLEN); of two
    roots the root further along the path. TR must be 0.
    """
    roots = line_sphere(point, path, parent_start, parent_length)
    nearest = point + path * _along(parent_start - point, path)[..., None]
    away = nearest - parent_start
    edge = parent_start + vector.unit(away) * parent_length[..., None]
    meets = roots.roots > 0
    found = np.where(meets[..., None], point + path * roots.second[..., None], edge)
    return JointPoint(found, np.where(meets, 0, vector.length(away) - parent_length))


def joint_between(
    parent_start: Floats, parent_length: Floats, end: Floats, length: Floats, bend: Floats
) -> JointPoint:
    """Returns, by rule 12, PEP on the circle in which sphere(PSP, PLEN) meets sphere(EP, LEN): the point of
    the circle furthest in the direction `bend` (…, 3). TR must be 0.

    If `bend` is parallel to EP − PSP, any point of the circle. Spheres that do not meet: the point of the
    first sphere that is nearest to the second, and `miss`. Spheres with one centre and one radius: the point
    in the direction `bend`.
    """
    apart = end - parent_start
    distance = vector.length(apart)
    axis = np.where(distance[..., None] > 0, vector.unit(apart), 0)
    along = (distance * distance + parent_length * parent_length - length * length) / np.where(
        distance > 0, 2 * distance, 1
    )
    along = np.where(distance > 0, np.clip(along, -parent_length, parent_length), 0)
    aside = np.sqrt(np.maximum(parent_length * parent_length - along * along, 0))
    found = parent_start + axis * along[..., None] + _across(bend, axis) * aside[..., None]
    too_far, too_near = (
        distance - (parent_length + length),
        np.abs(parent_length - length) - distance,
    )
    return JointPoint(found, np.maximum(np.maximum(too_far, too_near), 0))


def _across(bend: Floats, axis: Floats) -> Floats:
    """The unit vector at right angles to the unit vector `axis` nearest to `bend`; a zero axis: along it."""
    direction = vector.unit(bend)
    rest = direction - axis * vector.dot(direction, axis)[..., None]
    is_parallel = vector.length(rest) < 1e-9
    return np.where(is_parallel[..., None], vector.perpendicular(axis), vector.unit(rest))


def _along(away: Floats, path: Floats) -> Floats:
    square = vector.dot(path, path)
    return vector.dot(away, path) / np.where(square > 0, square, 1)


def _shortest_turn(old: Floats, new: Floats) -> Floats:
    """The shortest rotation between unit vectors; within 1e-6 of opposite by way of exactly opposite."""
    both = old + new
    half_turn = np.concatenate([vector.perpendicular(old), np.zeros_like(old[..., :1])], -1)
    by_way = quat.mul(quat.between(-old, new), half_turn)
    is_opposite = vector.dot(both, both)[..., None] < _HALF_TURN
    return np.where(is_opposite, by_way, quat.between(old, new))


def _times(matrix: Floats, v: Floats) -> Floats:
    terms = matrix * v[..., None, :]
    return terms[..., 0] + terms[..., 1] + terms[..., 2]


def _transposed(matrix: Floats) -> Floats:
    return np.swapaxes(matrix, -1, -2)
