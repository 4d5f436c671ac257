"""Flocks on a stage: all actors of a role with `flock:` are the members of one flock (FL1).

After the tick of the machines, the flight replaces the root motion of the members, and sets parameters for
the next tick: a member's speed can drive one blend space, its climbing another.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from statwalk.machine.definition.flock_definition import FlockDefinition, GoalDefinition
from statwalk.machine.settings import parameter_indices
from statwalk.maths.arrays import Floats
from statwalk.maths.elementary import atan2, cos, sincos
from statwalk.maths.random import actor_keys, signed_chances
from statwalk.motion.root import relative
from statwalk.rig.model_buffer import ModelBuffer
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.flights import Flight, Flights
from statwalk.stage.state.hashing import mix
from statwalk.world.flock import Members, Rules, flown
from statwalk.world.obstacles import Obstacles

TURN = 2 * np.pi
MOST_OBSTACLES = 128
"""the most obstacles of a flock: its own first, then colliders of other actors"""


def flocks(
    flights: Flights, before: Sequence[Cast], after: Sequence[Cast], clock: tuple[float, int, int]
) -> tuple[Flights, tuple[Cast, ...]]:
    """Returns the flights of all flocks after a tick, and the casts with the members at their new places.

    `clock`: dt, tick, seed.
    """
    if all(cast.role.definition.flock is None for cast in after):
        return (), tuple(after)
    flight_of = {flight.role: flight for flight in flights}
    flown_casts = [
        _flown(flight_of.get(new.role.name), old, new, after, clock)
        for old, new in zip(before, after, strict=True)
    ]
    return tuple(flight for flight, _ in flown_casts if flight), tuple(cast for _, cast in flown_casts)


def _flown(
    flight: Flight | None, before: Cast, after: Cast, casts: Sequence[Cast], clock: tuple[float, int, int]
) -> tuple[Flight | None, Cast]:
    definition = after.role.definition.flock
    if definition is None:
        return None, after
    dt, tick, seed = clock
    members = _members(flight, before, definition)
    goal = None if definition.goal is None else _goal(definition.goal, tick * dt)
    chance = signed_chances(actor_keys(seed, after.ids), tick, 3)
    moved = flown(members, _rules_of(definition), goal, _obstacles(definition, after, casts), chance, dt)
    heading = _turned(before.heading, moved, definition, dt)
    root_delta = relative(_place(before.position, before.heading), _place(moved.position, heading))
    placed = replace(after, position=moved.position, heading=heading, root_delta=root_delta)
    settled = _settled(placed, definition, moved, (heading - before.heading) / dt)
    parameters = settled.machine.parameters
    hashed = replace(
        settled, hash=mix(settled.hash, [moved.position, heading, moved.velocity, moved.forward, parameters])
    )
    return Flight(after.role.name, after.ids, moved.velocity, moved.forward), hashed


def _members(flight: Flight | None, cast: Cast, definition: FlockDefinition) -> Members:
    """The members at the tick before; a new member flies straight ahead, at the least speed."""
    sine, cosine = sincos(cast.heading)
    forward = np.stack([sine, np.zeros_like(sine), cosine], -1)
    velocity = forward * definition.min_speed
    if flight is not None and len(flight.ids):
        row = flight.ids.searchsorted(cast.ids).clip(max=len(flight.ids) - 1)
        is_known = (flight.ids[row] == cast.ids)[:, None]
        velocity, forward = (
            np.where(is_known, flight.velocity[row], velocity),
            np.where(is_known, flight.forward[row], forward),
        )
    return Members(cast.position, velocity, forward)


def _rules_of(definition: FlockDefinition) -> Rules:
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
    """The place of the goal (3,) at a moment."""
    sine, cosine = sincos(TURN * (seconds / goal.seconds % 1))
    return np.array(goal.center) + goal.radius * np.array([float(cosine), 0.0, -float(sine)])


def _obstacles(definition: FlockDefinition, flock: Cast, casts: Sequence[Cast]) -> Obstacles:
    """The obstacles of the machine, and the present colliders of other actors that the flock avoids."""
    own = definition.obstacles
    obstacles = Obstacles(
        np.array([obstacle.center for obstacle in own]).reshape(-1, 3),
        np.array([obstacle.radius for obstacle in own], np.float64),
        np.array([obstacle.normal for obstacle in own]).reshape(-1, 3),
        np.array([obstacle.kind == "plane" for obstacle in own], bool),
    )
    for cast in casts if definition.avoid else ():
        if cast.model is not None and cast.role.name != flock.role.name:
            avoided = _avoided(definition, cast, cast.model)
            obstacles = Obstacles._make(np.concatenate(pair) for pair in zip(obstacles, avoided, strict=True))
    return Obstacles._make(array[:MOST_OBSTACLES] for array in obstacles)


def _avoided(definition: FlockDefinition, cast: Cast, model: ModelBuffer) -> Obstacles:
    colliders = cast.role.colliders
    placed = colliders.placed(model, cast.position, cast.heading)
    row, column = (
        placed.is_there & np.array([name in definition.avoid for name in colliders.names], bool)
    ).nonzero()
    return Obstacles(
        placed.center[row, column],
        placed.radius[row, column],
        placed.normal[row, column],
        colliders.is_plane[column],
    )


def _turned(heading: Floats, members: Members, definition: FlockDefinition, dt: float) -> Floats:
    """Headings (N,) that turn towards the flight, no faster than `max_turn_deg` allows."""
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
    """The cast with the parameters that the flight sets, within their bounds."""
    if not definition.sets:
        return cast
    velocity = members.velocity
    speed = np.sqrt(
        velocity[:, 0] * velocity[:, 0] + velocity[:, 1] * velocity[:, 1] + velocity[:, 2] * velocity[:, 2]
    )
    measured = {"speed": speed, "climb": velocity[:, 1], "turn": turning}
    parameters = cast.machine.parameters.copy()
    for name, parameter in definition.sets.items():
        column = parameter_indices(cast.role.machine, parameter)[0]
        bounds = cast.role.machine.parameters[column]
        parameters[:, column] = measured[name].clip(bounds.minimum, bounds.maximum)
    return replace(cast, machine=cast.machine._replace(parameters=parameters))
