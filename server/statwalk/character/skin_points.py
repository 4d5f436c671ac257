"""Points of a character's skin, posed for many poses at once: with linear blend skinning a point is a linear
function of the matrices of the joints (RTCA 2.3.2). Not for ticks: it takes long.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from statwalk.character.character import Character
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.columns import lock_fields
from statwalk.maths.elementary import sincos
from statwalk.rig.evaluate import world_from_local

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
        """Sums joint by joint: a product of matrices would have other last bits on another processor."""
        rows = world[..., axis, :]
        poses = rows.reshape(-1, *rows.shape[-2:]).transpose(1, 2, 0).copy()  # poses side by side: faster
        values = np.zeros((self.count, poses.shape[-1]), rows.dtype)
        for joint, column in zip(*np.nonzero(self.shares.any(-1)), strict=True):
            carried = np.flatnonzero(self.shares[joint, column])
            values[carried] += (
                self.shares[joint, column, carried, None].astype(rows.dtype) * poses[joint, column]
            )
        found: Floats = values.T.reshape(*rows.shape[:-2], self.count)
        return found


def outermost(points: Floats, directions: Floats) -> Ints:
    """Returns the rows of the points (V, 3) that lie furthest out in one of the directions (3, D); the same
    rows on every processor, also where two points lie as far.
    """
    x, y, z = (points[:, axis, None] * directions[axis] for axis in range(3))
    rows: Ints = np.unique((x + y + z).argmax(0))
    return rows


def _sphere() -> Floats:
    """(3, DIRECTIONS) unit vectors spread evenly: a spiral of golden angles."""
    height = 1 - (2 * np.arange(DIRECTIONS) + 1) / DIRECTIONS
    angle, radius = np.pi * (3 - np.sqrt(5)) * np.arange(DIRECTIONS), np.sqrt(1 - height * height)
    sine, cosine = sincos(angle)
    return np.stack([radius * cosine, height, radius * sine])


def bound_points(character: Character, joints: Sequence[int]) -> SkinPoints:
    """Returns the vertices that one of the joints carries: has the largest weight in."""
    surface = character.surface
    rows = np.flatnonzero(np.isin(_carriers(character), joints))
    rest = np.concatenate([surface.positions[:, rows], np.ones((1, len(rows)))]).T.astype(np.float64)
    shares, every = np.zeros((len(character.skeleton), 4, len(rows))), np.arange(len(rows))
    for bones, weights in zip(surface.bones[rows].T, surface.weights[rows].T.astype(np.float64), strict=True):
        bind = surface.palette.inverse_bind[bones].astype(np.float64)
        at = np.concatenate([np.einsum("vab,vb->va", bind, rest), np.ones((len(rows), 1))], -1)
        shares[surface.palette.joints[bones], :, every] += weights[:, None] * at
    return SkinPoints(shares)


def outermost_points(character: Character, whole: Sequence[int] = ()) -> SkinPoints:
    """Returns the points of a character that could touch a floor: all that the joints `whole` carry, and of
    every other joint those that lie furthest out in DIRECTIONS directions at rest.
    """
    rest = world_from_local(character.skeleton, character.bind_pose).astype(np.float64)
    shares: list[Floats] = [np.zeros((len(character.skeleton), 4, 0))]
    for joint in np.unique(_carriers(character)).tolist():
        points = bound_points(character, [joint])
        furthest = outermost(points.at(rest), _sphere())
        shares.append((points if joint in whole else points.take(furthest)).shares)
    return SkinPoints(np.concatenate(shares, -1))


def _carriers(character: Character) -> Ints:
    """(V,) the joint with the largest weight in each vertex."""
    surface = character.surface
    heaviest = np.take_along_axis(surface.bones, surface.weights.argmax(1)[:, None], 1)[:, 0]
    carriers: Ints = surface.palette.joints[heaviest].astype(np.int64)
    return carriers
