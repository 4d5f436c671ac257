"""Flocks and swarms (FL1, FAQ Q34): particles that see their nearest neighbours, keep a preferred distance
and fly to a goal.

One flock is N members as arrays; metres, seconds. A member's flight depends on what it sees, not on how the
work is divided.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from statwalk.maths import vector
from statwalk.maths.arrays import Bools, Floats
from statwalk.world.obstacles import Obstacles, evasion, pushed_out, repulsion
from statwalk.world.sight import nearest_seen

SETTLING_S = 0.7
"""seconds in which a member reaches its wanted speed or position"""
RESPONSE_S = 0.35
"""seconds in which a member of a formation reaches its wanted speed; shorter, as followers follow
followers
"""
LEADING = 0.75
"""the leader's top speed as a part of the greatest speed, so that followers can keep up"""
CLOSEST = 0.05
"""part of the preferred distance below which the force stays constant"""


@dataclass(frozen=True)
class Rules:
    """The rules that members of a flock follow."""

    distance: float = 1.0
    """metres: wanted distance to the neighbours that a member sees"""
    reach: float = 5.0
    """metres: range of sight"""
    sight_cos: float = -1.0
    """cosine of half the field of view; −1: all round"""
    nearest: int = 7
    """number of neighbours that a member looks at; near neighbours hide far ones"""
    strength: float = 4.0
    """metres per second squared: scales the forces"""
    min_speed: float = 0.0
    max_speed: float = 5.0
    max_acceleration: float = 10.0
    wander: float = 0.0
    """metres per second squared of random acceleration"""
    follow: float = 0.0
    """0…1: the part of its neighbours' velocity that a member takes over (beyond the FAQ)"""
    formation: tuple[float, float] | None = None
    """metres beside and behind the member ahead: the first leads, the others fly in two arms behind it"""


class Members(NamedTuple):
    """Positions, velocities and directions of the members: (N, 3) each; `forward` has unit length."""

    position: Floats
    velocity: Floats
    forward: Floats


def flown(
    members: Members, rules: Rules, goal: Floats | None, obstacles: Obstacles, chance: Floats, dt: float
) -> Members:
    """Returns the flock `dt` seconds later. `goal` (3,): the wanted position; `chance` (N, 3): random numbers
    −1…1.
    """
    wish = _forces(members, rules, chance) + repulsion(
        obstacles, members.position, rules.distance, rules.strength
    )
    wish += evasion(obstacles, members.position, members.velocity, rules.distance)
    wish += _desires(members, rules, goal)
    velocity = members.velocity + _limited(wish, rules.max_acceleration) * dt
    velocity = _limited(velocity, rules.max_speed)
    velocity = _at_least(velocity, rules.min_speed, members.forward)
    position, velocity = pushed_out(obstacles, members.position + velocity * dt, velocity)
    moves = vector.dot(velocity, velocity) > 0
    return Members(position, velocity, np.where(moves[:, None], vector.unit(velocity), members.forward))


def _forces(members: Members, rules: Rules, chance: Floats) -> Floats:
    """Accelerations (N, 3): the sum over the visible neighbours, the nearest first; far neighbours attract
    and near ones repel.

    (r − d)·d/r² along the direction to the neighbour: the difference from the wanted distance, times the
    inverse square of the distance.
    """
    total = chance * rules.wander
    seen, distance = nearest_seen(
        members.position, members.forward, rules.reach, rules.sight_cos, rules.nearest
    )
    for row in range(seen.shape[1]):
        is_seen = np.isfinite(distance[:, row])
        neighbour = np.where(is_seen, seen[:, row], 0)
        gap = np.where(is_seen, distance[:, row], 1)
        away = np.where(
            (gap > 0)[:, None],
            (members.position[neighbour] - members.position) / np.where(gap > 0, gap, 1)[:, None],
            chance,
        )
        near = np.maximum(gap, CLOSEST * rules.distance)
        force = rules.strength * rules.distance * (near - rules.distance) / (near * near)
        total += np.where(is_seen[:, None], away * force[:, None], 0)
        if rules.follow > 0:
            total += np.where(
                is_seen[:, None],
                (members.velocity[neighbour] - members.velocity)
                * (rules.follow / rules.nearest / SETTLING_S),
                0,
            )
    return total


def _desires(members: Members, rules: Rules, goal: Floats | None) -> Floats:
    """Accelerations (N, 3) towards the goal, and in a formation (all but the first) towards the place beside
    and behind the member ahead.
    """
    in_formation = rules.formation is not None
    wish = np.zeros_like(members.position)
    if goal is not None:
        fastest = rules.max_speed * (LEADING if in_formation else 1)
        wish = (_limited((goal - members.position) / SETTLING_S, fastest) - members.velocity) / SETTLING_S
    if rules.formation is None or len(wish) < 2:
        return wish
    rank = np.arange(1, len(wish))
    ahead = np.maximum(rank - 2, 0)
    missing = (
        members.position[ahead]
        + _beside(members.forward[:1], rank % 2 == 1, rules.formation)
        - members.position[1:]
    )
    wanted = _limited(members.velocity[ahead] + missing / SETTLING_S, rules.max_speed)
    wish[1:] = (wanted - members.velocity[1:]) / RESPONSE_S
    return wish


def _beside(forward: Floats, is_left: Bools, formation: tuple[float, float]) -> Floats:
    """From a member to the place beside and behind it, on the level: (n, 3).

    All members use the first member's direction, so that arms are straight.
    """
    beside, behind = formation
    level = vector.unit(forward * np.array([1.0, 0, 1]))
    left = np.stack([level[:, 2], np.zeros(len(level)), -level[:, 0]], -1)
    place: Floats = left * np.where(is_left, beside, -beside)[:, None] - level * behind
    return place


def _limited(vectors: Floats, most: float) -> Floats:
    """The vectors, none longer than `most`."""
    size = vector.length(vectors)
    return vectors * np.where(size > most, most / np.where(size > 0, size, 1), 1)[:, None]


def _at_least(velocity: Floats, least: float, forward: Floats) -> Floats:
    """The velocities, none slower than `least`; a member that stands still starts forward."""
    size = vector.length(velocity)
    faster = np.where(
        (size > 0)[:, None], velocity * (least / np.where(size > 0, size, 1))[:, None], forward * least
    )
    return np.where((size < least)[:, None], faster, velocity)
