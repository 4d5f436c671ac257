"""Feet on the stairs and the slope of terrain, over whole crossings; the rooms are what was measured, rounded
up. The measure (`crossings.py`) looks at the skin that is shown, and knows nothing of the foot lock.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from crossings import Crossing, crossing, heights_at, jumps, skin_depth, slide
from paths import MACHINES
from statwalk.character.feet import Foot, feet_of
from statwalk.character.role import Role
from statwalk.rig.evaluate import world_from_local
from statwalk.services.library.load import load_role
from statwalk.stage.measure.limbs import hands_of
from statwalk.stage.stage import Stage

TERRAIN = load_role(MACHINES / "terrain")
GROUND = TERRAIN.definition.ground
LEVEL = Role.build("level", TERRAIN.character, replace(TERRAIN.definition, ground=()), "Root")
WAYS = {
    "up": ((0, 0, 0), 0.0),
    "down": ((0, 0, 8.9), np.pi),
    "up, aslant": ((-0.5, 0, 0), np.radians(20)),
    "down, aslant": ((0.6, 0, 8.9), np.pi + np.radians(12)),
}
SKIN = 0.003
BODY, JOINT = 2.5, 3.0
SLIDE = 0.015
TOUCHES = 0.004
"""metres: a foot that rises is still for a tick too"""


@cache
def walk(way: str) -> Crossing:
    return crossing(TERRAIN, *WAYS[way], ticks=420)


@cache
def level_walk() -> Crossing:
    return crossing(LEVEL, (0, 0, 0), 0.0, ticks=400)


@pytest.mark.parametrize("way", WAYS)
def test_no_skin_is_inside_steps_or_slope(way: str) -> None:
    depth = skin_depth(TERRAIN, walk(way))
    assert depth.max() < SKIN


@pytest.mark.parametrize("way", WAYS)
def test_feet_do_not_slide_on_steps_and_slope(way: str) -> None:
    assert max(slide(TERRAIN, walk(way), foot) for foot in feet_of(TERRAIN.character)) < SLIDE


@pytest.mark.parametrize("way", WAYS)
def test_no_joint_jumps_over_steps_and_slope(way: str) -> None:
    body, joint = jumps(TERRAIN, walk(way), level_walk())
    assert body < BODY
    assert joint < JOINT


@pytest.mark.parametrize("way", WAYS)
def test_the_root_rises_smoothly_over_stairs(way: str) -> None:
    height = walk(way).root
    assert np.ptp(height) == pytest.approx(0.48, abs=0.01)
    assert np.abs(np.diff(height, 2)).max() * 3600 < 10  # m/s²


def standing_soles(way: str, first: float, last: float) -> np.ndarray:
    """(N, K) how much higher above the ground the points of a sole are than at rest, of feet that touch it,
    and have stood still for two ticks, whole, between `first` and `last` along z.
    """
    found = []
    for foot in feet_of(TERRAIN.character):
        points = foot.skin.at(walk(way).world).astype(np.float64)
        still = np.linalg.norm(np.diff(points, axis=0), axis=-1).max(1) < 1e-3
        still[1:] &= still[:-1]  # a heel that has come down stands for a tick before the toes follow
        inside = (points[1:, :, 2] > first).all(1) & (points[1:, :, 2] < last).all(1)
        heights = over_ground(foot, points[1:][still & inside])
        found.append(heights[heights.min(1) < TOUCHES])
    return np.concatenate(found)


def over_ground(foot: Foot, points: np.ndarray) -> np.ndarray:
    at_rest = foot.skin.at(world_from_local(TERRAIN.character.skeleton, TERRAIN.character.bind_pose))[:, 1]
    return points[..., 1] - heights_at(GROUND, points[..., 0], points[..., 2]) - (at_rest - at_rest.min())


@pytest.mark.parametrize(("way", "first", "last"), [("down", 4.5, 7.3), ("up", 4.5, 7.3), ("up", 2.5, 4.3)])
def test_a_foot_lies_on_the_slope_and_the_landing_as_on_the_floor(
    way: str, first: float, last: float
) -> None:
    soles = standing_soles(way, first, last)
    assert len(soles) > 10
    assert np.abs(soles).max() < 0.006


@pytest.mark.parametrize("way", WAYS)
def test_a_foot_on_the_stairs_has_a_tread_below_it(way: str) -> None:
    soles = standing_soles(way, 1.4, 2.5)
    assert len(soles) > 5
    assert ((np.abs(soles) < 0.006).mean(1) > 0.4).all()


@pytest.mark.parametrize(("z", "share"), [(5.5, 1.0), (1.65, 0.9)])
@pytest.mark.parametrize("ticks", [1, 60])
def test_an_actor_that_starts_on_the_slope_or_a_stair_stands_there_at_once(
    z: float, share: float, ticks: int
) -> None:
    """At z = 1.65 its toes would overlap the next stair: its feet stand a little behind."""
    stage = Stage(seed=1)
    actor = stage.add(TERRAIN, (0, 0, z))
    stage.step(ticks)
    for foot in feet_of(TERRAIN.character):
        soles = over_ground(foot, foot.skin.at(np.asarray(actor.world)[:, :3]))
        assert soles.min() > -0.006
        assert (np.abs(soles) < 0.006).mean() >= share


def test_going_back_over_the_stairs_gives_the_same_feet() -> None:
    stage = Stage(seed=1)
    stage.hold(stage.add(TERRAIN), "FORWARD")
    stage.step(180)
    then = stage.hash
    stage.seek(90)
    stage.seek(180)
    assert stage.hash == then


def jump(role: Role) -> np.ndarray:
    """(T, 3, 3) the root and the hands in a jump out of a walk, until the actor has stood up."""
    stage = Stage(seed=1)
    actor = stage.add(role)
    stage.hold(actor, "FORWARD")
    stage.step(80)
    stage.release(actor, "FORWARD")
    stage.send(actor, "JUMP")
    shots, states = [], set()
    for _ in range(110):
        stage.step()
        states.add(actor.state)
        shots.append(np.asarray(actor.world)[[0, *hands_of(role.character)], :3, 3])
    assert {"FLY", "LAND", "CRCH", "STUP"} <= states
    return np.array(shots)


def test_a_jump_on_high_ground_is_the_jump_on_the_floor() -> None:
    high = replace(GROUND[0], corner=(-100.0, -100.0), opposite=(100.0, 100.0), height=0.48)
    role = Role.build("high", TERRAIN.character, replace(TERRAIN.definition, ground=(high,)), "Root")
    assert np.abs(jump(role) - jump(LEVEL) - (0, 0.48, 0)).max() < 0.005


def test_ground_without_pieces_near_changes_little() -> None:
    far = replace(GROUND[0], corner=(100.0, 100.0), opposite=(101.0, 101.0))
    role = Role.build("far", TERRAIN.character, replace(TERRAIN.definition, ground=(far,)), "Root")
    there = crossing(role, (0, 0, 0), 0.0, ticks=200)
    away = np.abs(there.world - level_walk().world[:200])[..., 3].max()
    assert away < 0.015  # a heel stands a little earlier
