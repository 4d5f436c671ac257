import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp
from statwalk.files.gltf.keys import reduce_keys

TICKS = np.arange(200)


def back(keys, values):
    """The values at every tick, interpolated by NumPy from the kept keys."""
    if keys.interpolation == "STEP":
        return values[keys.ticks[np.searchsorted(keys.ticks, TICKS, "right") - 1]]
    return np.stack(
        [np.interp(TICKS, keys.ticks, values[keys.ticks, axis]) for axis in range(values.shape[1])], -1
    )


def wandering(seed):
    steps = np.random.default_rng(seed).normal(size=(200, 3)) * 0.02
    return np.cumsum(steps, axis=0)


@pytest.mark.parametrize("tolerance", [0.3, 0.05, 1e-3])
@pytest.mark.parametrize("seed", range(5))
def test_no_tick_is_further_off_than_the_bound(seed, tolerance):
    values = wandering(seed)
    keys = reduce_keys(values[:, None], np.array([tolerance]))[0]
    assert np.abs(back(keys, values) - values).max() <= tolerance * 1.000001


def test_a_straight_line_needs_its_ends():
    values = np.outer(TICKS, [1.0, -2, 0.5])
    assert reduce_keys(values[:, None], np.array([1e-6]))[0].ticks.tolist() == [0, 199]


def test_a_corner_is_a_key():
    values = np.abs(TICKS - 80.0)[:, None]
    assert reduce_keys(values[:, None], np.array([1e-6]))[0].ticks.tolist() == [0, 80, 199]


def test_what_stays_within_the_bound_has_one_key():
    values = 1e-6 * np.sin(TICKS)[:, None]
    assert reduce_keys(values[:, None], np.array([1e-3]))[0].ticks.tolist() == [0]


def test_what_jumps_between_values_is_stepped():
    values = np.floor(TICKS / 50.0)[:, None]
    keys = reduce_keys(values[:, None], np.array([1e-3]))[0]
    assert (keys.interpolation, keys.ticks.tolist()) == ("STEP", [0, 50, 100, 150])


@pytest.mark.parametrize("seed", range(3))
def test_turns_come_back_by_slerp(seed):
    turns = Rotation.from_rotvec(wandering(seed))
    quaternions = turns.as_quat() * np.random.default_rng(seed).choice(
        [-1, 1], (200, 1)
    )  # either sign is the same turn
    ticks = reduce_keys(quaternions[:, None], np.array([0.05]), turns=True)[0].ticks
    assert len(ticks) < 150
    assert (Slerp(ticks, turns[ticks])(TICKS).inv() * turns).magnitude().max() <= 0.0501


def test_each_channel_has_a_bound_of_its_own():
    values = np.stack([wandering(1), wandering(1)], axis=1)
    coarse, fine = reduce_keys(values, np.array([0.2, 0.001]))
    assert len(coarse.ticks) < len(fine.ticks)


def test_one_tick_is_one_key():
    assert reduce_keys(np.ones((1, 1, 3)), np.array([1e-3]))[0].ticks.tolist() == [0]
