"""Flocks on a stage: all actors of a role that has `flock:` are the members of one (FL1).

After the machines have done their tick, the flight takes the place of the way that their motions went, and sets parameters for the next
tick: a member's speed can drive its blend space, its climbing another.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.authored.flockdefinition import FlockDefinition, GoalDefinition
from statwalk.maths.arrays import Floats
from statwalk.maths.elementary import atan2, cos, sincos
from statwalk.motion.root import relative
from statwalk.stage.cast import Cast
from statwalk.stage.hash import chance_keys, mix
from statwalk.world.flock import Members, Rules, flown
from statwalk.world.obstacles import Obstacles

TURN = 2 * np.pi
MOST_OBSTACLES = 128
"""that a flock keeps out of: its own first, then others' colliders"""


class Flight(NamedTuple):
    """How the members of one flock fly."""

    role: str
    ids: NDArray[np.int64]
    """(N,) rising"""
    velocity: Floats
    """(N, 3) metres per second"""
    forward: Floats
    """(N, 3) unit"""


Flights = tuple[Flight, ...]


def flocks(
    flights: Flights, before: Sequence[Cast], after: Sequence[Cast], clock: tuple[float, int, int]
) -> tuple[Flights, tuple[Cast, ...]]:
    """How all flocks fly after a tick, and the casts with their members where they have flown to. `clock` is dt, tick, seed."""
    known = {flight.role: flight for flight in flights}
    found = [_flown(known.get(new.role.name), old, new, after, clock) for old, new in zip(before, after, strict=True)]
    return tuple(flight for flight, _ in found if flight), tuple(cast for _, cast in found)


def _flown(
    flight: Flight | None, before: Cast, after: Cast, casts: Sequence[Cast], clock: tuple[float, int, int]
) -> tuple[Flight | None, Cast]:
    definition = after.role.definition.flock
    if definition is None:
        return None, after
    dt, tick, seed = clock
    members = _members(flight, before, definition)
    goal = None if definition.goal is None else _goal(definition.goal, tick * dt)
    chance = _chance(seed, tick, after.ids)
    moved = flown(members, rules_of(definition), goal, _obstacles(definition, after, casts), chance, dt)
    heading = _turned(before.heading, moved, definition, dt)
    way = relative(_place(before.position, before.heading), _place(moved.position, heading))
    placed = replace(after, position=moved.position, heading=heading, way=way)
    settled = _settled(placed, definition, moved, (heading - before.heading) / dt)
    parameters = settled.machine.parameters
    hashed = replace(settled, hash=mix(settled.hash, [moved.position, heading, moved.velocity, moved.forward, parameters]))
    return Flight(after.role.name, after.ids, moved.velocity, moved.forward), hashed


def _members(flight: Flight | None, cast: Cast, definition: FlockDefinition) -> Members:
    """Where the members are; who is new flies on as it looks, at the least speed."""
    sine, cosine = sincos(cast.heading)
    forward = np.stack([sine, np.zeros_like(sine), cosine], -1)
    velocity = forward * definition.min_speed
    if flight is not None and len(flight.ids):
        row = flight.ids.searchsorted(cast.ids).clip(max=len(flight.ids) - 1)
        known = (flight.ids[row] == cast.ids)[:, None]
        velocity, forward = np.where(known, flight.velocity[row], velocity), np.where(known, flight.forward[row], forward)
    return Members(cast.position, velocity, forward)


def rules_of(definition: FlockDefinition) -> Rules:
    """The rules of a flock as the world takes them."""
    return Rules(
        distance=definition.distance,
        reach=definition.reach,
        sight_cos=float(cos(definition.sight_deg / 2 * (TURN / 360))) if definition.sight_deg < 360 else -1.0,
        nearest=definition.nearest,
        strength=definition.strength,
        min_speed=definition.min_speed,
        max_speed=definition.max_speed,
        max_acceleration=definition.max_acceleration,
        wander=definition.wander,
        follow=definition.follow,
        formation=definition.formation,
    )


def _goal(goal: GoalDefinition, seconds: float) -> Floats:
    """Where the goal (3,) is at a moment."""
    sine, cosine = sincos(TURN * (seconds / goal.seconds % 1))
    return np.array(goal.center) + goal.radius * np.array([float(cosine), 0.0, -float(sine)])


def _chance(seed: int, tick: int, ids: NDArray[np.int64]) -> Floats:
    """Numbers −1…1 (N, 3) of seed, actor and tick alone."""
    keys = mix(chance_keys(seed, ids), [np.full(len(ids), tick)])
    words = np.stack([mix(keys, [np.full(len(ids), axis)]) for axis in range(3)], -1)
    return (words >> np.uint64(11)).astype(np.float64) / 2.0**52 - 1


def _obstacles(definition: FlockDefinition, flock: Cast, casts: Sequence[Cast]) -> Obstacles:
    """Those that the machine names, and the colliders of others that the flock avoids, where they are now."""
    own = definition.obstacles
    found = Obstacles(
        np.array([one.center for one in own]).reshape(-1, 3),
        np.array([one.radius for one in own], np.float64),
        np.array([one.normal for one in own]).reshape(-1, 3),
        np.array([one.kind == "plane" for one in own], bool),
    )
    for cast in casts if definition.avoid else ():
        if cast.role.name != flock.role.name:
            found = Obstacles._make(np.concatenate(pair) for pair in zip(found, _avoided(definition, cast), strict=True))
    return Obstacles._make(array[:MOST_OBSTACLES] for array in found)


def _avoided(definition: FlockDefinition, cast: Cast) -> Obstacles:
    colliders = cast.role.colliders
    placed = colliders.placed(cast.shown, cast.position, cast.heading)
    row, column = (placed.is_there & np.array([name in definition.avoid for name in colliders.names], bool)).nonzero()
    return Obstacles(placed.center[row, column], placed.radius[row, column], placed.normal[row, column], colliders.is_plane[column])


def _turned(heading: Floats, members: Members, definition: FlockDefinition, dt: float) -> Floats:
    """Headings (N,) that follow the flight, no faster than they may turn."""
    level = members.velocity[:, 0] * members.velocity[:, 0] + members.velocity[:, 2] * members.velocity[:, 2]
    wanted = np.where(level > 0, atan2(members.velocity[:, 0], members.velocity[:, 2]), heading)
    missing = (wanted - heading) / TURN
    missing = (missing - np.floor(missing + 0.5)) * TURN
    most = definition.max_turn_deg * (TURN / 360) * dt
    turned: Floats = heading + missing.clip(-most, most)
    return turned


def _place(position: Floats, heading: Floats) -> Floats:
    return np.stack([position[:, 0], position[:, 2], heading], -1)


def _settled(cast: Cast, definition: FlockDefinition, members: Members, turning: Floats) -> Cast:
    """With the parameters that the flight sets, within their bounds."""
    if not definition.sets:
        return cast
    velocity = members.velocity
    speed = np.sqrt(velocity[:, 0] * velocity[:, 0] + velocity[:, 1] * velocity[:, 1] + velocity[:, 2] * velocity[:, 2])
    measured = {"speed": speed, "climb": velocity[:, 1], "turn": turning}
    parameters = cast.machine.parameters.copy()
    for name, parameter in definition.sets.items():
        column = cast.role.parameter(parameter)
        bounds = cast.role.machine.parameters[column]
        parameters[:, column] = measured[name].clip(bounds.minimum, bounds.maximum)
    return replace(cast, machine=cast.machine._replace(parameters=parameters))
