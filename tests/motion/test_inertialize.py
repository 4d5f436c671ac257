"""Offsets that die out: laws of the decay, and what is shown through a transition."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk.maths.pose import Pose
from statwalk.motion import inertialize

DT = 1 / 60
RNG = np.random.default_rng(11)
START, RATE = RNG.normal(size=(2, 1, 50)).astype(np.float32)
RATE *= 5


def decay(seconds, duration=0.3, start=START, rate=RATE):
    times = np.asarray(seconds, np.float64)
    rows = [np.repeat(array, len(times), 0) for array in (start, rate)]
    return inertialize.decay(*rows, times, np.full(len(times), duration)).astype(np.float64)


def test_the_offset_starts_where_it_was():
    assert decay([0.0]) == pytest.approx(START, abs=1e-5)


def test_it_starts_with_its_velocity():
    assert np.diff(decay([0.0, 1e-4]), axis=0) / 1e-4 == pytest.approx(RATE, abs=0.05)


def test_it_ends_at_nothing_and_stays_there():
    assert not decay([0.3, 0.4, 9]).any()


def test_it_ends_without_velocity():
    assert np.abs(decay([0.299])).max() / 1e-3 < 0.2


def test_position_and_velocity_are_continuous():
    x = decay(np.arange(0, 0.3, 1e-3))
    assert np.abs(np.diff(x, 2, axis=0)).max() / 1e-6 < 1.05 * 6 * (np.abs(START).max() / 0.09 + np.abs(RATE).max() / 0.3)


def test_of_all_ways_to_end_at_rest_it_has_the_least_acceleration():
    """Whatever is added to it that keeps its ends costs more (calculus of variations); here, bumps of t²(1−t)²."""
    times = np.linspace(0, 1, 1001)
    one, none = np.ones((1, 1), np.float32), np.zeros((1, 1), np.float32)
    x, bump = decay(times, 1.0, one, 3 + none)[:, 0], times**2 * (1 - times) ** 2
    costs = [(np.diff((x + amount * bump)[::5], 2) ** 2).sum() for amount in (-3, -1, 0, 1, 3)]
    assert np.argmin(costs) == 2


def test_from_rest_it_never_passes_zero():
    assert decay(np.linspace(0, 1, 101), 1.0, np.ones((1, 1), np.float32), np.zeros((1, 1), np.float32)).min() >= 0


def pose_of(rng, actors=1, joints=3, weights=2):
    turns = Rotation.random(actors * joints, random_state=rng).as_quat().reshape(actors, joints, 4)
    parts = rng.normal(size=(2, actors, joints, 3))
    return Pose(*(a.astype(np.float32) for a in (parts[0], turns, 1 + 0.1 * parts[1], rng.normal(size=(actors, weights)))))


def test_add_undoes_difference():
    a, b = pose_of(RNG, 4), pose_of(RNG, 4)
    got = inertialize.add(b, inertialize.difference(a, b))
    angles = (Rotation.from_quat(got.rotation.reshape(-1, 4)).inv() * Rotation.from_quat(a.rotation.reshape(-1, 4))).magnitude()
    assert angles.max() < 1e-5
    assert got.translation == pytest.approx(a.translation, abs=1e-5)
    assert got.weights == pytest.approx(a.weights, abs=1e-5)


def moved(pose, velocity, seconds):
    """The pose after moving at `velocity` (1, D)."""
    return inertialize.add(pose, (velocity * seconds).astype(np.float32))


def test_on_the_tick_of_a_transition_position_and_velocity_carry_on():
    shown, new = pose_of(RNG), pose_of(RNG)
    old_velocity, new_velocity = RNG.normal(size=(2, 1, inertialize.size(shown)))
    before, following = moved(shown, old_velocity, -DT), moved(new, new_velocity, DT)
    start, rate = inertialize.transition(before, shown, new, following, DT)
    now = inertialize.add(new, inertialize.decay(start, rate, np.array([DT]), np.array([0.2])))
    step = inertialize.difference(now, shown) / DT
    # what is left is half a tick of the decay's own acceleration
    acceleration = np.abs(4 * start / 0.04) + np.abs(6 * rate / 0.2)
    assert (np.abs(step - old_velocity) <= 0.75 * acceleration * DT + 1e-3).all()


def test_after_the_transition_only_the_new_motion_is_shown():
    shown, new = pose_of(RNG), pose_of(RNG)
    start, rate = inertialize.transition(shown, shown, new, new, DT)
    assert not inertialize.decay(start, rate, np.array([0.2]), np.array([0.2])).any()


def test_a_turn_of_almost_half_a_circle_does_not_flip_its_side():
    """Offsets of 179.9° and 180.1° a tick later are neighbours, not opposites."""

    def about_y(degrees):
        turn = Rotation.from_euler("y", degrees, degrees=True).as_quat()[None, None].astype(np.float32)
        return Pose(np.zeros((1, 1, 3), np.float32), turn, np.ones((1, 1, 3), np.float32), np.zeros((1, 0), np.float32))

    _, rate = inertialize.transition(about_y(180.1), about_y(179.9), about_y(0), about_y(0), DT)
    assert np.abs(rate).max() == pytest.approx(np.radians(0.2) / DT, rel=1e-2)
