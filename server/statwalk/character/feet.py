"""The feet of a character: the joints of each leg, and the points of the sole that touch the ground."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from statwalk.character.character import Character
from statwalk.character.joint_names import is_part, side_of
from statwalk.character.skin_points import SkinPoints, bound_points
from statwalk.maths import transform
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.columns import lock_fields
from statwalk.rig.evaluate import world_from_local

FOOT, TOE = "foot ankle", "toe ball"
NO_FOOT = "ik ctrl control pole target end nub effector roll heel"
"""words of joints that steer a foot or mark its end"""
SHIN, THIGH = "lowerleg shin calf knee", "upperleg upleg thigh hip"
SOLE = 0.02
"""metres above the lowest point of a foot at rest, for a leg of one metre: the height of its sole"""
MOST_POINTS = 48


@dataclass(frozen=True, eq=False)
class Foot:
    """A foot; joints are rows of the skeleton, -1 none.

    The points of the sole are at rest in the space of the joint that carries most of each (`carriers`: the
    ankle, the toe, or a joint below them), in metres of that joint's space.
    """

    name: str
    """`left`, `right`; the ankle's name if a side has several feet"""
    hip: int
    knee: int
    ankle: int
    toe: int
    carriers: Ints
    """(K,)"""
    points: Floats
    """(K, 3) float64"""
    skin: SkinPoints
    """the same points as the skin moves them"""
    is_front: Bools
    """(K,) the points of the ball, not of the heel"""

    def __post_init__(self) -> None:
        lock_fields(self)

    @property
    def leg(self) -> tuple[int, int, int]:
        """Returns hip, knee and ankle."""
        return self.hip, self.knee, self.ankle

    def length(self, world: Floats) -> float:
        """Returns the length of the leg, in metres, for matrices (J, 3, 4): hip to knee to ankle; of a foot
        without leg the height of its ankle above the sole.
        """
        if min(self.leg) < 0:
            return max(float(world[self.ankle, 1, 3] - self.skin.heights(world).min()), 1e-3)
        hip, knee, ankle = (world[joint, :, 3] for joint in self.leg)
        return float(np.linalg.norm(knee - hip) + np.linalg.norm(ankle - knee))

    @property
    def joints(self) -> list[int]:
        """Returns ankle and toe, and the other joints that carry the sole."""
        return sorted({self.ankle, *self.carriers.tolist(), *([self.toe] if self.toe >= 0 else [])})


def feet_of(character: Character) -> tuple[Foot, ...]:
    """Returns the feet that the names of the joints tell; none for a character without feet."""
    names = character.skeleton.names
    ankles = [joint for joint, name in enumerate(names) if is_part(name, FOOT) and not is_part(name, NO_FOOT)]
    ankles = [joint for joint in ankles if not is_part(names[joint], TOE)]
    ankles = [joint for joint in ankles if not set(_ancestors(character, joint)) & set(ankles)]
    sides = [side_of(names[ankle]) for ankle in ankles]
    return tuple(
        _foot(character, side if side and sides.count(side) == 1 else names[ankle], ankle)
        for side, ankle in zip(sides, ankles, strict=True)
    )


def _ancestors(character: Character, joint: int) -> list[int]:
    """The joints above a joint, the nearest first."""
    parent, above = character.skeleton.parent, []
    while (joint := int(parent[joint])) >= 0:
        above.append(joint)
    return above


def _below(character: Character, joint: int) -> list[int]:
    """The joint and its descendants."""
    return [row for row in range(len(character.skeleton)) if joint in (row, *_ancestors(character, row))]


def _foot(character: Character, name: str, ankle: int) -> Foot:
    names, above = character.skeleton.names, _ancestors(character, ankle)
    knee = next((joint for joint in reversed(above) if is_part(names[joint], SHIN)), -1)
    hip = next((joint for joint in reversed(above) if is_part(names[joint], THIGH)), -1)
    if knee < 0 and len(above) > 1:  # Mixamo's LeftLeg, and names that tell nothing
        knee, hip = above[0], above[1] if hip < 0 else hip
    if hip < 0 and knee >= 0:
        hip = int(character.skeleton.parent[knee])
    below = _below(character, ankle)
    toe = next((joint for joint in below[1:] if is_part(names[joint], TOE)), -1)
    world = world_from_local(character.skeleton, character.bind_pose).astype(np.float64)
    skin = _sole(character, below, world)
    carriers = skin.carriers
    points = transform.apply(transform.invert(world[carriers]), skin.at(world))
    at = skin.at(world)[:, ::2]
    ahead = at.mean(0) - world[ankle, ::2, 3]
    along = at @ (ahead if np.linalg.norm(ahead) > 1e-6 else np.array([0.0, 1]))
    is_front = along > (along.min() + along.max()) / 2
    return Foot(name, hip, knee, ankle, toe, carriers, points, skin, is_front)


def _sole(character: Character, below: list[int], world: Floats) -> SkinPoints:
    """The lowest points of the skin of the joints `below`; the joints themselves if they have none."""
    points = bound_points(character, below)
    if not points.count:
        points = SkinPoints.of_joints_themselves(below, len(character.skeleton))
    height = points.heights(world)
    leg = max(float(world[below[0], 1, 3] - height.min()), float(np.ptp(world[:, 1, 3])), 1e-6)
    low = np.flatnonzero(height <= height.min() + SOLE * leg)
    return points.take(_spread(points.at(world)[low][:, ::2], low))


def _spread(flat: Floats, rows: Ints) -> Ints:
    """At most MOST_POINTS of some rows: those that lie furthest out in directions all round (K, 2)."""
    if len(rows) <= MOST_POINTS:
        return rows
    angles = np.linspace(0, 2 * np.pi, MOST_POINTS, endpoint=False)
    directions = np.stack([np.cos(angles), np.sin(angles)], -1)
    outermost: Ints = rows[np.unique((flat @ directions.T).argmax(0))]
    return outermost
