"""FL1 flocks and swarms (FAQ Q34): particles that keep to limits, see few, hold a distance, and fly around
what is in the way.
"""

import numpy as np
import pytest
from statwalk.services.library.load_scene import load_scene
from statwalk.world import grid
from statwalk.world.flock import Members, Rules, flown
from statwalk.world.obstacles import NO_OBSTACLES, Obstacles

DT = 1 / 60
AHEAD = np.array([0.0, 0, 1])


def members(*positions, velocity=(0, 0, 0)):
    place = np.array(positions, float)
    return Members(
        place, np.tile(np.array(velocity, float), (len(place), 1)), np.tile(AHEAD, (len(place), 1))
    )


def after(flock, rules, ticks=1, goal=None, obstacles=NO_OBSTACLES, chance=None):
    chance = np.zeros_like(flock.position) if chance is None else chance
    for _ in range(ticks):
        flock = flown(flock, rules, goal, obstacles, chance, DT)
    return flock


def push(distance, **rules):
    """Acceleration of a member along Z, towards another so far ahead (metres per second squared)."""
    flock = after(
        members((0, 0, 0), (0, 0, distance)),
        Rules(distance=1, strength=4, max_acceleration=1e6, max_speed=1e6, **rules),
    )
    return float(flock.velocity[0, 2] / DT)


@pytest.mark.parametrize(
    ("distance", "force"),
    [(0.5, -8), (1, 0), (2, 1), (4, 0.75)],
    ids=["too near", "as wanted", "too far", "farther"],
)
def test_a_preferred_distance_by_inverse_square_forces(distance, force):
    # 4·(r − 1)/r²: what is wanting, scaled by the inverse square
    assert push(distance) == pytest.approx(force)


def test_beyond_the_maximum_distance_nobody_counts():
    assert push(4.9, reach=5) > 0
    assert push(5.1, reach=5) == 0


def test_two_come_to_the_preferred_distance():
    goal = np.array([0.0, 0, 0.5])  # between them, it also takes the speed out of them
    flock = after(members((0, 0, -1), (0, 0, 2)), Rules(distance=1, strength=40, max_speed=2), 600, goal)
    assert np.linalg.norm(flock.position[1] - flock.position[0]) == pytest.approx(1, abs=0.1)


def test_what_is_out_of_the_field_of_view_is_ignored():
    behind = after(members((0, 0, 0), (0, 0, -2)), Rules(sight_cos=0.0))
    assert not behind.velocity[0].any()
    assert behind.velocity[1, 2] > 0


def test_near_ones_hide_far_ones():
    crowd = members((0, 0, 0), (0, 0, 0.5), (0, 0, 0.6), (3, 0, 0))
    alone = members((0, 0, 0), (0, 0, 0.5), (0, 0, 0.6))
    rules = Rules(nearest=2)
    np.testing.assert_array_equal(after(crowd, rules).velocity[0], after(alone, rules).velocity[0])
    assert after(crowd, Rules(nearest=3)).velocity[0, 0] > 0


def test_speed_and_acceleration_keep_to_their_limits():
    chance = np.random.default_rng(1)
    flock = members(*chance.uniform(-1, 1, (60, 3)), velocity=(1, 0, 0))
    rules = Rules(distance=0.5, strength=50, min_speed=0.5, max_speed=3, max_acceleration=6, wander=20)
    for _ in range(120):
        later = after(flock, rules, chance=chance.uniform(-1, 1, (60, 3)), goal=np.array([5.0, 0, 0]))
        speed = np.linalg.norm(later.velocity, axis=1)
        assert speed.max() <= 3 + 1e-9
        assert speed.min() >= 0.5 - 1e-9
        assert (np.linalg.norm(later.velocity - flock.velocity, axis=1) <= 6 * DT + 0.5 + 1e-9).all()
        flock = later


def test_a_goal_is_reached():
    flock = after(members((0, 0, 0)), Rules(max_speed=4), 600, np.array([6.0, 3, -5]))
    np.testing.assert_allclose(flock.position[0], [6, 3, -5], atol=0.05)


def test_nobody_flies_through_a_sphere_or_a_plane():
    wall = Obstacles(
        np.array([[0.0, 0, 5], [0, -1, 0]]),
        np.array([2.0, 0]),
        np.array([[0.0, 0, 0], [0, 1, 0]]),
        np.array([False, True]),
    )
    chance = np.random.default_rng(4)
    flock = members(*chance.uniform(-1, 1, (40, 3)), velocity=(0, 0, 3))
    for _ in range(300):
        flock = after(flock, Rules(max_speed=8, max_acceleration=40), 1, np.array([0.0, -3, 12]), wall)
        assert np.linalg.norm(flock.position - wall.center[0], axis=1).min() >= 2 - 1e-6
        assert flock.position[:, 1].min() >= -1 - 1e-9
    assert (flock.position[:, 2] > 7).mean() > 0.9


def test_two_in_the_same_place_part_where_chance_leads():
    chance = np.array([[1.0, 0, 0], [-1, 0, 0]])
    flock = after(members((0, 0, 0), (0, 0, 0)), Rules(), chance=chance)
    assert flock.velocity[0, 0] * flock.velocity[1, 0] < 0


def test_how_the_work_is_divided_changes_no_bit(monkeypatch):
    chance = np.random.default_rng(7)
    flock = members(*chance.uniform(-3, 3, (90, 3)), velocity=(0, 0, 1))
    whole = after(flock, Rules(sight_cos=-0.3), 30)
    monkeypatch.setattr(grid, "BLOCK", 40)
    for one, other in zip(whole, after(flock, Rules(sight_cos=-0.3), 30), strict=True):
        np.testing.assert_array_equal(one, other)


def flight(name, ticks, seed=None):
    scene = load_scene(name)
    stage = scene.open()
    if seed is not None:
        stage.seed = seed
    stage.step(ticks)
    return stage


def test_geese_form_a_wedge_that_turns_with_the_first():
    stage = flight("geese", 900)
    cast = stage.casts[0]
    first, others = cast.position[0], cast.position[1:]
    sine, cosine = np.sin(cast.heading[0]), np.cos(cast.heading[0])
    away = others - first
    left, ahead = away[:, 0] * cosine - away[:, 2] * sine, away[:, 0] * sine + away[:, 2] * cosine
    assert (ahead < 0).all()  # nobody before the first
    assert (left[::2] > 0).all()  # one arm on the left
    assert (left[1::2] < 0).all()
    assert (np.diff(ahead[::2]) < 0).all()  # in order, each behind the one ahead
    assert (np.diff(ahead[1::2]) < 0).all()
    assert abs(np.ptp(cast.position[:, 1])) < 0.5


def test_a_goose_beats_its_wings_as_its_speed_says():
    stage = flight("geese", 300)
    cast = stage.casts[0]
    speed = np.linalg.norm(stage.state.flights[0].velocity, axis=1)
    np.testing.assert_allclose(cast.machine.parameters[:, 0], speed.clip(0, 10))


def test_the_same_seed_gives_the_same_flight_and_another_one_another():
    assert flight("swarm", 60).hash == flight("swarm", 60).hash
    assert flight("swarm", 60).hash != flight("swarm", 60, seed=9).hash


def test_a_flight_is_the_same_after_going_back():
    stage = flight("geese", 100)
    head = stage.hash
    stage.seek(30)
    stage.step(70)
    assert stage.hash == head
