"""Measures touches among 1,000 actors, and a flock of 1,000: `python benchmarks/world.py`.

The sense step is complete: it places colliders on the joints of all actors, fills the grid, and finds
contacts and events. Its peers get the positions, and only find near pairs: NumPy over all pairs, SciPy's k-d
tree. A flock's step is sight, forces and limits; its peers only find the seven nearest neighbours, without a
field of view. All run in turn, and the least time of all rounds counts.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from rounds import Job, least, show
from scipy.spatial import cKDTree
from statwalk.character.role import Role
from statwalk.machine.definition.machine_definition import (
    EventDefinition,
)
from statwalk.machine.definition.sense_definition import ColliderDefinition, TouchDefinition
from statwalk.rig.model_buffer import ModelBuffer
from statwalk.services.library.load import load
from statwalk.stage.stage import Stage
from statwalk.stage.steps.contact_events import touched
from statwalk.world.flock import Members, Rules, flown
from statwalk.world.obstacles import NO_OBSTACLES

ACTORS, ROUNDS = 1000, 40
RADIUS, NEAREST = 0.4, 7


def crowd() -> Stage:
    """Returns a stage of walkers on 45 by 45 metres, each with a sphere on its hips that senses
    other spheres.
    """
    walker = load("faq-walker")
    assert isinstance(walker, Role)
    definition = replace(
        walker.definition,
        events={**walker.definition.events, "HIT": EventDefinition(0)},
        colliders={"body": ColliderDefinition("sphere", 0, "Root", radius=RADIUS)},
        senses={"HIT": TouchDefinition("body", "body", "enter", 0)},
    )
    chance = np.random.default_rng(1)
    stage = Stage()
    places = [((x, 0.0, z), angle) for x, z, angle in chance.uniform((0, 0, -3), (45, 45, 3), (ACTORS, 3))]
    for actor in stage.add_many(Role.build("crowd", walker.character, definition, "Root"), places):
        stage.hold(actor, "FORWARD")
    stage.step(90)
    return stage


def swarm() -> tuple[Members, Rules]:
    """Returns a flock after two seconds of flight."""
    chance = np.random.default_rng(1)
    rules = Rules(distance=1, reach=5, sight_cos=-0.7, nearest=NEAREST, max_speed=4, min_speed=1, wander=4)
    members = Members(
        chance.uniform(0, 10, (ACTORS, 3)), chance.normal(size=(ACTORS, 3)), np.tile([0.0, 0, 1], (ACTORS, 1))
    )
    for _ in range(120):
        members = flown(
            members, rules, np.full(3, 5.0), NO_OBSTACLES, chance.uniform(-1, 1, (ACTORS, 3)), 1 / 60
        )
    return members, rules


def touching_jobs(stage: Stage) -> dict[str, Job]:
    """Returns the sense step and its peers."""
    contacts, (cast,) = stage.state.contacts, stage.casts
    places, model = cast.position, ModelBuffer.room(cast.role.colliders.joints, ACTORS)
    looked_at = replace(cast, model=model)
    return {
        "statwalk": lambda: model.fill(cast.shown) or (touched(contacts, [looked_at]) and None),
        "scipy cKDTree.query_pairs": lambda: (
            cKDTree(places).query_pairs(2 * RADIUS, output_type="ndarray").size and None
        ),
        "NumPy, all pairs": lambda: (
            np.argwhere(np.triu(squares(places) <= 4 * RADIUS * RADIUS, 1)).size and None
        ),
    }


def flocking_jobs(members: Members, rules: Rules) -> dict[str, Job]:
    """Returns a step of the flock and its peers."""
    chance = np.zeros((ACTORS, 3))
    places = members.position
    return {
        "statwalk": lambda: flown(members, rules, np.full(3, 5.0), NO_OBSTACLES, chance, 1 / 60) and None,
        "scipy cKDTree.query": lambda: cKDTree(places).query(places, NEAREST + 1) and None,
        "NumPy, all pairs": lambda: np.argpartition(squares(places), NEAREST, axis=1).size and None,
    }


def squares(places: np.ndarray) -> np.ndarray:
    """Returns the squares (N, N) of all distances."""
    differences = places[:, None] - places[None]
    return np.asarray((differences * differences).sum(-1))


def main() -> None:
    """Prints the tables."""
    stage = crowd()
    show(
        f"sense step, {ACTORS:,} actors, {len(stage.state.contacts.touching):,} contacts",
        least(touching_jobs(stage), ROUNDS),
    )
    show(f"step of a flock, {ACTORS:,} members", least(flocking_jobs(*swarm()), ROUNDS))


if __name__ == "__main__":
    main()
