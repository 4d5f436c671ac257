"""Feet that stay where they stand: faq-walker's transitions, measured with the foot lock and without it,
between walk and run, and on the stairs and the slope of terrain.

The measure of slides and sinks is `stage/measure/slide.py`, which knows nothing of the foot lock: it looks at
the skin that is shown. The rooms are what was measured, rounded up.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from paths import MACHINES
from statwalk.character.feet import feet_of
from statwalk.character.role import Role
from statwalk.services.library.load import load_role
from statwalk.stage.measure import measure
from statwalk.stage.measure.measure import Measured, measure_cells
from statwalk.stage.measure.subject import Subject
from statwalk.stage.stage import Stage

WALKER, TERRAIN = load_role(MACHINES / "faq-walker"), load_role(MACHINES / "terrain")
LAYERS = load_role(MACHINES / "walker-layers")
FREE = Role.build("free", WALKER.character, replace(WALKER.definition, foot_lock=0.0), "Root")
HELD = {"WALK/STOP": 0.003, "WALK/JUMP": 0.001, "STAT/LEFT": 0.001, "STAT/CROUCH": 0.001}
HELD |= {"WALK/LEFT": 0.005, "WALK/RIGHT": 0.004, "STWK/STOP": 0.007, "TLFT/STOP": 0.001, "TRGT/LEFT": 0.004}
"""metres: the farthest slide in any contact, from ten phases and through interruptions"""
ON_STAIRS = {
    "JUMP/END": {"slide": 0.003, "sink": 0.001, "jump": 1.0, "joint": 1.2},
    "FLY/END": {"slide": 0.001, "sink": 0.001, "jump": 0.8, "joint": 1.2},
    "TLFT/FORWARD": {"slide": 0.008, "sink": 0.005, "jump": 1.1, "joint": 1.7},
    "TRGT/FORWARD": {"slide": 0.008, "sink": 0.005, "jump": 1.1, "joint": 1.9},
    "TRGT/LEFT": {"slide": 0.006, "sink": 0.004, "jump": 1.2, "joint": 1.7},
    "STWK/STOP": {"slide": 0.004, "sink": 0.003, "jump": 1.1, "joint": 1.6},
    "TLFT/STOP": {"slide": 0.006, "sink": 0.005, "jump": 1.2, "joint": 1.7},
    "TRGT/STOP": {"slide": 0.003, "sink": 0.005, "jump": 1.2, "joint": 1.4},
    "WALK/STOP": {"slide": 0.005, "sink": 0.004, "jump": 1.0, "joint": 1.1},
    "WALK/LEFT": {"slide": 0.011, "sink": 0.005, "jump": 1.1, "joint": 2.0},
}
RUNNER = {"STAND/GO": 0.006, "MOVE/STOP": 0.004, "MOVE/HURRY": 0.004, "RUN/STOP": 0.003, "RUN/EASE": 0.005}
"""metres: slides of walker-layers; without the foot lock up to 807 mm"""
SINK, KNEE = 0.005, 0.002


def measured(role: Role, cell: str) -> Measured:
    """The figures of one cell."""
    subject = Subject(role)
    (wanted,) = [place for place in subject.cells if subject.name(place) == cell]
    return next(iter(measure_cells(subject, [wanted])))


@pytest.mark.parametrize("cell", HELD)
def test_feet_hold_the_ground_through_a_transition(cell: str) -> None:
    figures = measured(WALKER, cell).figures
    assert figures["slide"].worst <= HELD[cell]
    assert figures["sink"].worst <= SINK
    assert figures["knee"].worst <= KNEE


def test_a_turn_is_not_half_on_the_spot_and_half_round_a_curve(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measure, "LATER", (57,))  # he is slow then: 92 mm where both turns were mixed
    assert measured(WALKER, "WALK/RIGHT").figures["slide"].worst <= 0.015


@pytest.mark.parametrize("cell", ON_STAIRS)
def test_feet_hold_the_stairs_and_the_slope_through_a_transition(cell: str) -> None:
    figures = measured(TERRAIN, cell).figures
    assert {name for name, most in ON_STAIRS[cell].items() if figures[name].worst > most} == set()


@pytest.mark.parametrize("cell", RUNNER)
def test_feet_hold_the_ground_between_walk_and_run(cell: str) -> None:
    figures = measured(LAYERS, cell).figures
    assert figures["slide"].worst <= RUNNER[cell]
    assert figures["sink"].worst <= SINK
    assert figures["jump"].worst <= 1.2
    assert figures["joint"].worst <= 1.6


def test_without_the_foot_lock_the_same_feet_slide() -> None:
    assert measured(FREE, "WALK/JUMP").figures["slide"].worst > 0.1


def soles_over_ground(steps: int) -> np.ndarray:
    """(T, 2, 2) for each tick and foot of a walk over the terrain: the height of the lowest point of the sole
    above the ground below it, and how fast it moves, in metres and m/s.
    """
    stage = Stage(seed=1)
    actor, feet = stage.add(TERRAIN), feet_of(TERRAIN.character)
    stage.hold(actor, "FORWARD")
    rows, before = [], None
    for _ in range(steps):
        stage.step()
        points = [foot.skin.at(np.asarray(actor.world)[:, :3]) for foot in feet]
        heights = [sole[:, 1] - [height_at(x, z) for x, _, z in sole] for sole in points]
        lowest = [int(height.argmin()) for height in heights]
        moved = before if before is not None else points
        speeds = [
            float(np.linalg.norm(now[k] - then[k])) * stage.rate
            for now, then, k in zip(points, moved, lowest, strict=True)
        ]
        rows.append([[height.min(), speed] for height, speed in zip(heights, speeds, strict=True)])
        before = points
    return np.array(rows)


def height_at(x: float, z: float) -> float:
    """The height of the terrain, from its file's numbers."""
    inside = [
        piece
        for piece in TERRAIN.definition.ground
        if piece.corner[0] <= x <= piece.opposite[0] and piece.corner[1] <= z <= piece.opposite[1]
    ]
    heights = [0.0]
    for piece in inside:
        share = (z - piece.corner[1]) / (piece.opposite[1] - piece.corner[1])
        end = piece.height if piece.end_height is None else piece.end_height
        heights.append(piece.height + share * (end - piece.height))
    return max(heights)


def test_the_walker_climbs_stairs_and_comes_down_the_slope() -> None:
    stage = Stage(seed=1)
    actor = stage.add(TERRAIN)
    stage.hold(actor, "FORWARD")
    stage.step(220)
    assert actor.matrix[1, 3] == pytest.approx(0.48, abs=0.01)
    stage.step(220)
    assert actor.matrix[1, 3] == pytest.approx(0.0, abs=0.01)


def test_a_foot_that_stands_on_the_terrain_is_on_its_ground() -> None:
    soles = soles_over_ground(420)
    stands = soles[..., 1] < 0.05
    assert stands.sum() > 300
    assert np.quantile(np.abs(soles[..., 0][stands]), 0.95) < 0.012


def test_an_actor_has_the_same_hash_alone_and_in_a_crowd() -> None:
    def played(count: int) -> str:
        stage = Stage(seed=3)
        actors = [stage.add(WALKER, (2.0 * number, 0.0, 0.0)) for number in range(count)]
        for event, ticks in (("FORWARD", 70), ("STOP", 40), ("LEFT", 30)):
            stage.send(actors[0], event)
            stage.step(ticks)
        return actors[0].hash

    assert played(1) == played(20)


def test_going_back_and_on_again_gives_the_same_feet() -> None:
    stage = Stage(seed=1)
    actor = stage.add(WALKER)
    stage.send(actor, "FORWARD")
    stage.step(80)
    stage.send(actor, "STOP")
    stage.step(60)
    then = stage.hash
    stage.seek(85)
    stage.seek(140)
    assert stage.hash == then
