"""Offsets that die out: laws of the decay, and what is shown through a transition."""

import numpy as np
import pytest
import slow_inertialize
from scipy.spatial.transform import Rotation
from statwalk.maths.pose import Pose

DT = 1 / 60
RNG = np.random.default_rng(11)
START, RATE = RNG.normal(size=(2, 1, 50)).astype(np.float32)
RATE *= 5


def decay(seconds, duration=0.3, start=START, rate=RATE, quintic=False):
    times = np.asarray(seconds, np.float64)
    rows = [np.repeat(array, len(times), 0) for array in (start, rate)]
    return slow_inertialize.decay(
        *rows, times, np.full(len(times), duration), np.full(len(times), quintic)
    ).astype(np.float64)


both = pytest.mark.parametrize("quintic", [False, True])


@both
def test_the_offset_starts_where_it_was(quintic):
    assert decay([0.0], quintic=quintic) == pytest.approx(START, abs=1e-5)


@both
def test_it_starts_with_its_velocity(quintic):
    assert np.diff(decay([0.0, 1e-4], quintic=quintic), axis=0) / 1e-4 == pytest.approx(RATE, abs=0.05)


@both
def test_it_ends_at_nothing_and_stays_there(quintic):
    assert not decay([0.3, 0.4, 9], quintic=quintic).any()


@both
def test_it_ends_without_velocity(quintic):
    assert np.abs(decay([0.299], quintic=quintic)).max() / 1e-3 < 0.2


def test_position_and_velocity_are_continuous():
    x = decay(np.arange(0, 0.3, 1e-3))
    assert np.abs(np.diff(x, 2, axis=0)).max() / 1e-6 < 1.05 * 6 * (
        np.abs(START).max() / 0.09 + np.abs(RATE).max() / 0.3
    )


def test_of_all_ways_to_end_at_rest_it_has_the_least_acceleration():
    """Whatever is added to it that keeps its ends costs more (calculus of variations); here, bumps of
    t²(1−t)².
    """
    times = np.linspace(0, 1, 1001)
    one, none = np.ones((1, 1), np.float32), np.zeros((1, 1), np.float32)
    x, bump = decay(times, 1.0, one, 3 + none)[:, 0], times**2 * (1 - times) ** 2
    costs = [(np.diff((x + amount * bump)[::5], 2) ** 2).sum() for amount in (-3, -1, 0, 1, 3)]
    assert np.argmin(costs) == 2


def bollo(x0, v0, t1, t):
    """The quintic of *Inertialization* (GDC 2018, "Initial acceleration"), coefficient by coefficient."""
    a0 = (-8 * v0 * t1 - 20 * x0) / t1**2
    a = -(a0 * t1**2 + 6 * v0 * t1 + 12 * x0) / (2 * t1**5)
    b = (3 * a0 * t1**2 + 16 * v0 * t1 + 30 * x0) / (2 * t1**4)
    c = -(3 * a0 * t1**2 + 12 * v0 * t1 + 20 * x0) / (2 * t1**3)
    return a * t**5 + b * t**4 + c * t**3 + a0 / 2 * t**2 + v0 * t + x0


def test_the_quintic_is_bollos():
    times = np.linspace(0, 0.3, 40)
    assert decay(times, quintic=True) == pytest.approx(bollo(START, RATE, 0.3, times[:, None]), abs=1e-5)


def test_each_actor_has_its_own_curve():
    rows = [np.repeat(array, 2, 0) for array in (START, RATE)]
    mixed = slow_inertialize.decay(*rows, np.full(2, 0.1), np.full(2, 0.3), np.array([False, True]))
    assert mixed.tolist() == np.concatenate([decay([0.1]), decay([0.1], quintic=True)]).tolist()


def test_from_rest_it_never_passes_zero():
    assert (
        decay(np.linspace(0, 1, 101), 1.0, np.ones((1, 1), np.float32), np.zeros((1, 1), np.float32)).min()
        >= 0
    )


def pose_of(rng, actors=1, joints=3, weights=2):
    turns = Rotation.random(actors * joints, random_state=rng).as_quat().reshape(actors, joints, 4)
    parts = rng.normal(size=(2, actors, joints, 3))
    return Pose(
        *(
            a.astype(np.float32)
            for a in (parts[0], turns, 1 + 0.1 * parts[1], rng.normal(size=(actors, weights)))
        )
    )


def test_add_undoes_difference():
    a, b = pose_of(RNG, 4), pose_of(RNG, 4)
    got = slow_inertialize.add(b, slow_inertialize.difference(a, b))
    angles = (
        Rotation.from_quat(got.rotation.reshape(-1, 4)).inv() * Rotation.from_quat(a.rotation.reshape(-1, 4))
    ).magnitude()
    assert angles.max() < 1e-5
    assert got.translation == pytest.approx(a.translation, abs=1e-5)
    assert got.weights == pytest.approx(a.weights, abs=1e-5)


def moved(pose, velocity, seconds):
    """The pose after moving at `velocity` (1, D)."""
    return slow_inertialize.add(pose, (velocity * seconds).astype(np.float32))


def test_on_the_tick_of_a_transition_position_and_velocity_carry_on():
    shown, new = pose_of(RNG), pose_of(RNG)
    old_velocity, new_velocity = RNG.normal(size=(2, 1, slow_inertialize.size(shown)))
    before, following = moved(shown, old_velocity, -DT), moved(new, new_velocity, DT)
    start, rate = slow_inertialize.transition(before, shown, new, following, DT)
    now = slow_inertialize.add(new, slow_inertialize.decay(start, rate, np.array([DT]), np.array([0.2])))
    step = slow_inertialize.difference(now, shown) / DT
    # what is left is half a tick of the decay's own acceleration
    acceleration = np.abs(4 * start / 0.04) + np.abs(6 * rate / 0.2)
    assert (np.abs(step - old_velocity) <= 0.75 * acceleration * DT + 1e-3).all()


def test_after_the_transition_only_the_new_motion_is_shown():
    shown, new = pose_of(RNG), pose_of(RNG)
    start, rate = slow_inertialize.transition(shown, shown, new, new, DT)
    assert not slow_inertialize.decay(start, rate, np.array([0.2]), np.array([0.2])).any()


def test_a_turn_of_almost_half_a_circle_does_not_flip_its_side():
    """Offsets of 179.9° and 180.1° a tick later are neighbours, not opposites."""

    def about_y(degrees):
        turn = Rotation.from_euler("y", degrees, degrees=True).as_quat()[None, None].astype(np.float32)
        return Pose(
            np.zeros((1, 1, 3), np.float32),
            turn,
            np.ones((1, 1, 3), np.float32),
            np.zeros((1, 0), np.float32),
        )

    _, rate = slow_inertialize.transition(about_y(180.1), about_y(179.9), about_y(0), about_y(0), DT)
    assert np.abs(rate).max() == pytest.approx(np.radians(0.2) / DT, rel=1e-2)
