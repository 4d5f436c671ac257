"""Who touches whom among 1,000, and how a flock of 1,000 flies; `python benchmarks/world.py`.

The sense step is all of it: colliders placed on the joints of all actors, the grid, contacts, events. Its peers are given the places and
only look for the pairs that are near: NumPy over all pairs, SciPy's k-d tree. A flock's step is sight, forces and limits; its peers only
look for the seven nearest of each, without a field of view. All in turn, the least time of all rounds counts.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from rounds import Job, least, show
from scipy.spatial import cKDTree
from statwalk.loading import load
from statwalk.machine.authored.definition import ColliderDefinition, EventDefinition, TouchDefinition
from statwalk.stage.meeting.touch import touched
from statwalk.stage.role import Role
from statwalk.stage.stage import Stage
from statwalk.world.flock import Members, Rules, flown
from statwalk.world.obstacles import NO_OBSTACLES

ACTORS, ROUNDS = 1000, 40
RADIUS, NEAREST = 0.4, 7


def crowd() -> Stage:
    """Walkers on 45 metres by 45, each with a sphere on its hips that feels those of the others."""
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
    places = [((x, 0.0, z), turn) for x, z, turn in chance.uniform((0, 0, -3), (45, 45, 3), (ACTORS, 3))]
    for actor in stage.add_many(Role.build("crowd", walker.character, definition, "Root"), places):
        stage.hold(actor, "FORWARD")
    stage.step(90)
    return stage


def swarm() -> tuple[Members, Rules]:
    """A flock that has flown for two seconds."""
    chance = np.random.default_rng(1)
    rules = Rules(distance=1, reach=5, sight_cos=-0.7, nearest=NEAREST, max_speed=4, min_speed=1, wander=4)
    members = Members(chance.uniform(0, 10, (ACTORS, 3)), chance.normal(size=(ACTORS, 3)), np.tile([0.0, 0, 1], (ACTORS, 1)))
    for _ in range(120):
        members = flown(members, rules, np.full(3, 5.0), NO_OBSTACLES, chance.uniform(-1, 1, (ACTORS, 3)), 1 / 60)
    return members, rules


def touching_jobs(stage: Stage) -> dict[str, Job]:
    """The sense step and its peers."""
    state = stage.state
    places = state.casts[0].position
    return {
        "statwalk": lambda: touched(state.contacts, state.casts) and None,
        "scipy cKDTree.query_pairs": lambda: cKDTree(places).query_pairs(2 * RADIUS, output_type="ndarray").size and None,
        "NumPy, all pairs": lambda: np.argwhere(np.triu(squares(places) <= 4 * RADIUS * RADIUS, 1)).size and None,
    }


def flocking_jobs(members: Members, rules: Rules) -> dict[str, Job]:
    """A step of the flock and its peers."""
    chance = np.zeros((ACTORS, 3))
    places = members.position
    return {
        "statwalk": lambda: flown(members, rules, np.full(3, 5.0), NO_OBSTACLES, chance, 1 / 60) and None,
        "scipy cKDTree.query": lambda: cKDTree(places).query(places, NEAREST + 1) and None,
        "NumPy, all pairs": lambda: np.argpartition(squares(places), NEAREST, axis=1).size and None,
    }


def squares(places: np.ndarray) -> np.ndarray:
    """(N, N) squares of all distances."""
    away = places[:, None] - places[None]
    return np.asarray((away * away).sum(-1))


def main() -> None:
    """Print the tables."""
    stage = crowd()
    show(f"sense step, {ACTORS:,} actors, {len(stage.state.contacts.touching):,} contacts", least(touching_jobs(stage), ROUNDS))
    show(f"step of a flock, {ACTORS:,} members", least(flocking_jobs(*swarm()), ROUNDS))


if __name__ == "__main__":
    main()
