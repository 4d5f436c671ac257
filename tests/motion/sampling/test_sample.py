"""Sampling against hand-computed cases, SciPy, and the formulas of glTF 2.0, appendix C."""

import numpy as np
import pytest
from scipy.interpolate import BSpline
from scipy.spatial.transform import Rotation, Slerp
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip, duration_of
from statwalk.motion.keys.packed_keys import tracks_of

TIMES = np.array([0.5, 1.0, 2.0], np.float32)
VALUES = np.array([[0, 0, 0], [1, 2, 3], [3, 2, 1]], np.float32)
TURNS = Rotation.from_rotvec([[0, 0, 0], [0, 1, 0], [2, 1, 0]])


def clip_of(*channels, joints=2, weights=0, loop=False):
    return Clip("clip", channels, duration_of(channels), rest(joints, weights), loop=loop)


def translation(interpolation, values=VALUES, **options):
    return clip_of(Channel(1, "translation", TIMES, np.asarray(values, np.float32), interpolation), **options)


@pytest.mark.parametrize(
    ("time", "key"), [(-1, 0), (0, 0), (0.5, 0), (0.99, 0), (1.0, 1), (1.99, 1), (2.0, 2), (9, 2)]
)
def test_step_holds_the_key_passed_last(time, key):
    assert (translation("STEP").sample(time).translation[1] == VALUES[key]).all()


@pytest.mark.parametrize(
    ("time", "x"), [(-1, 0), (0.25, 0), (0.75, 0.5), (1.0, 1), (1.5, 2), (2.0, 3), (7, 3)]
)
def test_linear_is_straight_and_holds_its_ends(time, x):
    assert translation("LINEAR").sample(time).translation[1, 0] == pytest.approx(x)


def test_joints_without_a_channel_rest():
    assert not translation("LINEAR").sample(1.0).translation[0].any()


def test_loop_takes_time_modulo_the_duration():
    clip = translation("LINEAR")
    assert (clip.sample(2.0 + 1.5, loop=True).translation == clip.sample(1.5).translation).all()


def test_before_zero_a_loop_is_near_its_end():
    clip = translation("LINEAR")
    assert (clip.sample(-0.5, loop=True).translation == clip.sample(1.5).translation).all()


def test_rotations_slerp_like_scipy():
    times = np.linspace(0.5, 2, 31)
    clip = clip_of(Channel(0, "rotation", TIMES, TURNS.as_quat().astype(np.float32)))
    wanted = Slerp(TIMES.astype(float), TURNS)(times)
    assert (wanted.inv() * Rotation.from_quat(clip.sample(times).rotation[:, 0])).magnitude().max() < 1e-6


def test_rotations_take_the_shorter_arc():
    keys = np.array(
        [[0, 0, 0, 1], [0, -np.sin(0.25), 0, -np.cos(0.25)]], np.float32
    )  # the second is a turn of 0.5, with the other sign
    clip = clip_of(Channel(0, "rotation", np.array([0, 1], np.float32), keys))
    assert Rotation.from_quat(clip.sample(0.5).rotation[0]).magnitude() == pytest.approx(0.25, abs=1e-6)


def test_rotation_keys_are_normalised():
    keys = np.array([[0, 0, 0, 3], [0, 2, 0, 0]], np.float32)
    clip = clip_of(Channel(0, "rotation", np.array([0, 1], np.float32), keys))
    assert np.linalg.norm(clip.sample([0, 0.3, 1]).rotation[:, 0], axis=-1) == pytest.approx(1, abs=1e-6)


def hermite(values, time):
    """glTF 2.0, appendix C.5, word for word."""
    k = 0 if time < 1 else 1
    td = float(TIMES[k + 1] - TIMES[k])
    t = (time - float(TIMES[k])) / td
    (_, v0, b0), (a1, v1, _) = values[k], values[k + 1]
    return (
        (2 * t**3 - 3 * t**2 + 1) * v0
        + td * (t**3 - 2 * t**2 + t) * b0
        + (3 * t**2 - 2 * t**3) * v1
        + td * (t**3 - t**2) * a1
    )


@pytest.mark.parametrize("time", [0.5, 0.6, 0.99, 1.0, 1.3, 1.9])
def test_cubicspline_is_gltfs(time):
    values = np.random.default_rng(5).normal(size=(3, 3, 3)).astype(np.float32)
    assert translation("CUBICSPLINE", values).sample(time).translation[1] == pytest.approx(
        hermite(values, time), abs=1e-5
    )


def test_cubicspline_rotations_are_normalised_after_the_cubic():
    values = np.random.default_rng(6).normal(size=(3, 3, 4)).astype(np.float32)
    wanted = hermite(values, 1.3)
    got = clip_of(Channel(0, "rotation", TIMES, values, "CUBICSPLINE")).sample(1.3).rotation[0]
    assert got == pytest.approx(wanted / np.linalg.norm(wanted), abs=1e-5)


def test_cubicspline_holds_its_ends():
    values = np.random.default_rng(7).normal(size=(3, 3, 3)).astype(np.float32)
    pose = translation("CUBICSPLINE", values).sample([0.0, 5.0])
    assert pose.translation[:, 1] == pytest.approx(values[[0, 2], 1])


def test_bspline_is_scipys_between_inner_keys():
    keys = np.random.default_rng(8).normal(size=(8, 3)).astype(np.float32)
    clip = clip_of(Channel(0, "translation", np.arange(8, dtype=np.float32), keys, "BSPLINE"))
    times = np.linspace(1, 6, 40)
    wanted = BSpline(np.arange(-2, 10), keys.astype(float), 3)(times)
    assert clip.sample(times).translation[:, 0] == pytest.approx(wanted, abs=1e-5)


@pytest.mark.parametrize("loop", [False, True])
def test_bspline_through_meets_its_keys(loop):
    keys = np.random.default_rng(9).normal(size=(6, 3)).astype(np.float32)
    keys[-1] = keys[0]
    times = np.arange(6, dtype=np.float32)
    clip = clip_of(Channel(0, "translation", times, keys, "BSPLINE_THROUGH"), loop=loop)
    assert clip.sample(times).translation[:, 0] == pytest.approx(keys, abs=1e-5)


@pytest.mark.parametrize("interpolation", ["BSPLINE", "BSPLINE_THROUGH"])
def test_a_looping_bspline_has_no_seam(interpolation):
    keys = np.array([[0, 0, 0], [1, 0, 0], [0, 2, 0], [-1, 0, 0], [0, 0, 0]], np.float32)
    clip = clip_of(Channel(0, "translation", np.arange(5, dtype=np.float32), keys, interpolation), loop=True)
    near = clip.sample([4 - 2e-3, 4 - 1e-3, 0.0, 1e-3], loop=True).translation[:, 0]
    velocities = np.diff(near, axis=0) / 1e-3
    assert velocities[0] == pytest.approx(velocities[2], abs=0.02)


def test_rotation_bspline_through_meets_its_keys():
    keys = Rotation.from_rotvec(np.random.default_rng(3).normal(size=(6, 3)) * 0.2)
    times = np.arange(6, dtype=np.float32)
    clip = clip_of(Channel(0, "rotation", times, keys.as_quat().astype(np.float32), "BSPLINE_THROUGH"))
    assert (keys.inv() * Rotation.from_quat(clip.sample(times).rotation[:, 0])).magnitude().max() < 1e-5


def test_weights_go_to_their_columns():
    channel = Channel(0, "weights", TIMES, np.array([[0, 1], [1, 0], [1, 1]], np.float32), weight_first=1)
    assert clip_of(channel, weights=4).sample(0.75).weights == pytest.approx([0, 0.5, 0.5, 0])


def test_channels_with_different_times_each_keep_their_own():
    slow = Channel(
        0, "translation", np.array([0, 3], np.float32), np.array([[0, 0, 0], [3, 0, 0]], np.float32)
    )
    fast = Channel(1, "translation", TIMES, VALUES)
    pose = clip_of(slow, fast).sample([0.75, 2.5])
    assert pose.translation[..., 0] == pytest.approx(np.array([[0.75, 0.5], [2.5, 3.0]]))


def test_one_actor_and_a_thousand_get_the_same_bits():
    rng = np.random.default_rng(1)
    turns = Rotation.random(120, random_state=4).as_quat().reshape(3, 40, 4).astype(np.float32)
    clip = clip_of(*(Channel(j, "rotation", TIMES, turns[:, j]) for j in range(40)), joints=40)
    times = rng.uniform(0, 2.5, 1000)
    crowd = clip.sample(times)
    assert all((clip.sample(times[i]).rotation == crowd.rotation[i]).all() for i in range(0, 1000, 37))


def test_an_empty_clip_is_the_rest_pose():
    clip = Clip("still", (), 0.0, rest(3))
    assert clip.sample(5.0, loop=True).scale.shape == (3, 3)
    assert not tracks_of((), loop=False)


def test_one_key_with_tangents_holds_its_value():
    keys = np.array([[[5, 5, 5], [1, 2, 3], [5, 5, 5]]], np.float32)
    clip = Clip(
        "one key",
        (Channel(0, "translation", np.array([0.5], np.float32), keys, "CUBICSPLINE"),),
        0.5,
        rest(2),
    )
    assert clip.sample([0, 0.5, 2]).translation[:, 0].tolist() == [[1, 2, 3]] * 3
