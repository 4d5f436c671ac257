"""Points of a character's skin, posed for many poses at once: with linear blend skinning a point is a linear
function of the matrices of the joints (RTCA 2.3.2). Not for ticks: it uses BLAS.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from statwalk.character.character import Character
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.columns import lock_fields

DIRECTIONS = 96


@dataclass(frozen=True, eq=False)
class SkinPoints:
    """V points of the skin, at rest, without morph targets."""

    shares: Floats
    """(J, 4, V): for each joint weight · inverse bind matrix · point, as x, y, z and weight"""

    def __post_init__(self) -> None:
        lock_fields(self)

    @classmethod
    def of_joints_themselves(cls, joints: Sequence[int], count: int) -> SkinPoints:
        """Returns the origins of some joints of a skeleton of `count` joints."""
        shares = np.zeros((count, 4, len(joints)))
        shares[list(joints), 3, np.arange(len(joints))] = 1
        return cls(shares)

    @property
    def count(self) -> int:
        """Returns V."""
        return int(self.shares.shape[2])

    @property
    def carriers(self) -> Ints:
        """Returns (V,) the joint with the largest weight in each point."""
        carriers: Ints = self.shares[:, 3].argmax(0)
        return carriers

    def outermost(self, world: Floats, whole: Sequence[int] = ()) -> SkinPoints:
        """Returns the points that could touch a floor: all that the joints `whole` carry, and of every other
        joint those that lie furthest out in DIRECTIONS directions in the pose of `world` (J, 3, 4).
        """
        points, carriers, directions = self.at(world), self.carriers, _sphere()
        every = [np.flatnonzero(carriers == joint) for joint in np.unique(carriers)]
        chosen = [rows[(points[rows] @ directions).argmax(0)] for rows in every]
        return self.take(np.unique(np.concatenate([np.flatnonzero(np.isin(carriers, whole)), *chosen])))

    def of_joints(self, joints: Sequence[int]) -> SkinPoints:
        """Returns the points that one of the joints carries."""
        return self.take(np.flatnonzero(np.isin(self.carriers, joints)))

    def take(self, rows: Ints) -> SkinPoints:
        """Returns some of the points."""
        return SkinPoints(self.shares[:, :, rows])

    def at(self, world: Floats) -> Floats:
        """Returns the points (…, V, 3) for matrices (…, J, 3, 4) of the joints."""
        return np.stack([self._row(world, axis) for axis in range(3)], -1)

    def heights(self, world: Floats) -> Floats:
        """Returns the heights (…, V) of the points for matrices (…, J, 3, 4) of the joints."""
        return self._row(world, 1)

    def _row(self, world: Floats, axis: int) -> Floats:
        rows = world[..., axis, :]
        flat = rows.reshape(*rows.shape[:-2], -1)
        values: Floats = flat @ self.shares.reshape(-1, self.count).astype(flat.dtype)
        return values


def _sphere() -> Floats:
    """(3, DIRECTIONS) unit vectors spread evenly: a spiral of golden angles."""
    height = 1 - (2 * np.arange(DIRECTIONS) + 1) / DIRECTIONS
    angle, radius = np.pi * (3 - np.sqrt(5)) * np.arange(DIRECTIONS), np.sqrt(1 - height * height)
    return np.stack([radius * np.cos(angle), height, radius * np.sin(angle)])


def bound_points(character: Character) -> SkinPoints:
    """Returns all vertices of a character."""
    surface, joints = character.surface, len(character.skeleton)
    count = surface.positions.shape[1]
    shares = np.zeros((joints, 4, count))
    rest = np.concatenate([surface.positions, np.ones((1, count))]).T.astype(np.float64)
    for influence in range(surface.bones.shape[1]):
        bones, weights = surface.bones[:, influence], surface.weights[:, influence].astype(np.float64)
        bind = surface.palette.inverse_bind[bones].astype(np.float64)
        at = np.concatenate([np.einsum("vab,vb->va", bind, rest), np.ones((count, 1))], -1)
        carried = surface.palette.joints[bones].astype(np.intp), np.arange(count)
        shares[carried[0], :, carried[1]] += weights[:, None] * at  # a vertex has each influence once
    return SkinPoints(shares)
