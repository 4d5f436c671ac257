"""KF6 non-uniform rational B-splines (FAQ Q17): keys at uneven times and with weights; SciPy in homogeneous
coordinates is the independent answer.
"""

import numpy as np
import pytest
from scipy.interpolate import BSpline, CubicSpline
from scipy.spatial.transform import Rotation
from statwalk.errors import ContentError
from statwalk.maths import nurbs
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from text_character import from_text, place

BONE = "Root --- - - - -\nArm Root 2 1 0 0\n"
TIMES = np.array([0.0, 0.25, 1.0, 1.5, 3.0, 3.5])
WEIGHTS = np.array([1.0, 2.0, 0.5, 4.0, 1.0, 1.5])
PLACES = np.array([[0.0, 0, 0], [0.1, 0.3, 0], [0.2, -0.1, 0.4], [0.5, 0, 0], [0.6, 0.2, 0.2], [0.3, 0.1, 0]])
ANGLES = np.array([0.0, 40, -20, 30, 60, 20])
MOMENTS = np.linspace(0, 3.5, 141)
KNOTS = np.concatenate([[-0.75, -0.5, -0.25], TIMES, [4.0, 4.5, 5.0]])


def file_text(command: str, values: np.ndarray, weights: np.ndarray) -> str:
    return "\n".join(
        f"#time {time}\n{command} Arm {' '.join(map(str, value))}\n#weight Arm {weight}"
        for time, value, weight in zip(TIMES, values, weights, strict=True)
    )


def scipys(values: np.ndarray, weights: np.ndarray, moments=MOMENTS) -> np.ndarray:
    """The NURBS with knots at the key times; one control more at each end, so that the ends are met."""
    plain = [BSpline(KNOTS, np.eye(8), 3)(moment) for moment in (0.0, 3.5)]
    before = values[0] + plain[0][2] / plain[0][0] * (values[0] - values[1])
    after = values[-1] + plain[1][5] / plain[1][7] * (values[-1] - values[-2])
    controls = np.vstack([before, values, after])
    own = np.concatenate([weights[1:2], weights, weights[-2:-1]])[:, None]
    curve = BSpline(KNOTS, np.hstack([own * controls, own]), 3)(moments)
    return curve[:, :-1] / curve[:, -1:]


def shown(tmp_path, interpolation: str, weights: np.ndarray, moments=MOMENTS) -> np.ndarray:
    text = file_text("#translate", PLACES, weights)
    character = from_text(tmp_path, BONE, move=(text, f"interpolation: {interpolation}"))
    poses = character.clip("move").sample(moments)
    return np.array([place(character, poses.take(row), "Arm") for row in range(len(moments))])


@pytest.mark.parametrize("weights", [np.ones(6), WEIGHTS])
def test_places_are_scipys_in_homogeneous_coordinates(tmp_path, weights):
    np.testing.assert_allclose(shown(tmp_path, "nurbs", weights), scipys(PLACES, weights), atol=1e-6)


def test_through_keys_at_uneven_times_it_is_scipys_natural_spline(tmp_path):
    expected = CubicSpline(TIMES, PLACES, bc_type="natural")(MOMENTS)
    np.testing.assert_allclose(shown(tmp_path, "nurbs through", np.ones(6)), expected, atol=1e-6)


def test_through_weighted_keys_it_meets_each_key_at_its_time(tmp_path):
    np.testing.assert_allclose(shown(tmp_path, "nurbs through", WEIGHTS, TIMES), PLACES, atol=1e-6)


def test_even_motion_through_keys_at_uneven_times_stays_even(tmp_path):
    text = "\n".join(f"#time {time}\n#translate Arm {time} 0 0" for time in TIMES)
    character = from_text(tmp_path, BONE, move=(text, "interpolation: nurbs through"))
    np.testing.assert_allclose(
        character.clip("move").sample(MOMENTS).translation[:, 1, 0], MOMENTS, atol=1e-6
    )


def test_a_heavier_key_draws_the_curve_nearer(tmp_path):
    def miss(weight: float) -> float:
        weights = np.array([1, 1, weight, 1, 1, 1.0])
        return float(np.abs(shown(tmp_path, "nurbs", weights, TIMES[2:3]) - PLACES[2]).max())

    assert miss(10) < 0.3 * miss(1) < 0.1 * miss(0.1) * 3


def turns(tmp_path, interpolation: str, weights: np.ndarray, moments, angles) -> Rotation:
    text = file_text("#rotate", angles[:, None] * [0, 0, 1], weights)
    character = from_text(tmp_path, BONE, move=(text, f"interpolation: {{rotation: {interpolation}}}"))
    return Rotation.from_quat(character.clip("move").sample(moments).rotation[:, 1])


def test_rotations_about_one_axis_follow_the_nurbs_of_the_angle(tmp_path):
    measured = turns(tmp_path, "nurbs", WEIGHTS, MOMENTS, ANGLES).as_rotvec()
    expected = np.radians(scipys(ANGLES[:, None], WEIGHTS)) * [0, 0, 1]
    np.testing.assert_allclose(measured, expected, atol=1e-6)


def test_rotations_are_the_cumulative_product_with_the_rational_basis():
    keys = Rotation.from_euler(
        "xyz", [[0.0, 0, 0], [30, 20, 0], [10, -20, 40], [0, 0, 20], [-20, 30, 10]], True
    )
    times, weights, moment = np.array([0, 0.5, 2, 2.5, 4]), np.array([1, 2, 0.5, 3, 1.0]), 1.1
    knots = np.concatenate([[-1.5, -1, -0.5], times, [5.5, 7, 8.5]])
    pulls = np.concatenate([[2], weights, [3]]) * BSpline(knots, np.eye(7), 3)(moment)
    pulls /= pulls.sum()
    expected = keys[0]  # control 1 of the curve; the segment from 0.5 s to 2 s has the controls 1 to 4
    for k in range(1, 4):
        turn = (keys[k - 1].inv() * keys[k]).as_rotvec()
        expected = expected * Rotation.from_rotvec(turn * pulls[k + 1 :].sum())
    values = keys.as_quat().astype(np.float32)
    channel = Channel(0, "rotation", times, values, "NURBS", key_weights=weights)
    clip = Clip("turn", (channel,), 4.0, rest(1))
    measured = Rotation.from_quat(clip.sample(moment).rotation[0])
    assert (measured * expected.inv()).magnitude() < 1e-6


def test_rotations_through_the_keys_meet_them(tmp_path):
    met = turns(tmp_path, "nurbs through", np.sqrt(WEIGHTS), TIMES, ANGLES / 2).as_rotvec()
    np.testing.assert_allclose(met, np.radians(ANGLES / 2)[:, None] * [0, 0, 1], atol=2e-6)


def test_a_weight_draws_a_growing_bone_too(tmp_path):
    lengths = 1 + PLACES[:, :1]
    text = file_text("#length", lengths, WEIGHTS)
    character = from_text(tmp_path, BONE, move=(text, "interpolation: nurbs"))
    poses = character.clip("move").sample(MOMENTS)
    tip = poses.translation[:, character.skeleton.index("Arm.end"), 0]
    np.testing.assert_allclose(tip, scipys(lengths, WEIGHTS)[:, 0], atol=1e-6)


HAND = BONE + "Hand Arm 1 1 0 0\n"


def test_each_bone_and_property_may_have_a_curve_of_its_own(tmp_path):
    text = file_text("#translate", PLACES, WEIGHTS)
    rows = text.split("\n")
    text = "\n".join(
        row if row.startswith("#time") else f"{row}\n{row.replace(' Arm', ' Hand')}" for row in rows
    )
    bones = "bones: {Hand: linear, Arm: {rotation: slerp, translation: nurbs}}"
    character = from_text(tmp_path, HAND, move=(text, f"interpolation: {{translation: hold, {bones}}}"))
    poses = character.clip("move").sample(MOMENTS)
    arm, hand = (poses.translation[:, character.skeleton.index(bone)] for bone in ("Arm", "Hand"))
    np.testing.assert_allclose(arm, scipys(PLACES, WEIGHTS), atol=1e-6)
    straight = np.stack([np.interp(MOMENTS, TIMES, axis) for axis in PLACES.T], -1)
    np.testing.assert_allclose(hand - [2, 0, 0], straight, atol=1e-6)


@pytest.mark.parametrize(
    ("how", "words"),
    [
        ("{bones: {Arn: nurbs}}", "bone.*'Arn'; did you mean Arm"),
        ("{bones: {Arm: nurb}}", "interpolation.*'nurb'"),
        ("{bones: {Arm: {turn: nurbs}}}", "turn"),
        ("{bones: nurbs}", "mapping|keys|names"),
    ],
)
def test_a_wrong_interpolation_is_refused_with_its_line(tmp_path, how, words):
    with pytest.raises(ContentError, match=words) as error:
        from_text(tmp_path, BONE, move=(file_text("#translate", PLACES, WEIGHTS), f"interpolation: {how}"))
    assert error.value.place == "line 4"


def test_a_closed_curve_is_scipys_periodic_spline():
    keys = np.concatenate([PLACES[:-1], PLACES[:1]])
    clip = Clip("ring", (Channel(0, "translation", TIMES, keys, "NURBS_THROUGH"),), 3.5, rest(1), loop=True)
    expected = CubicSpline(TIMES, keys, bc_type="periodic")(MOMENTS)
    np.testing.assert_allclose(clip.sample(MOMENTS).translation[:, 0], expected, atol=1e-6)


def test_channels_of_every_kind_sample_side_by_side():
    """Sixteen joints share a group of lanes; a curve in one lane leaves the others alone."""
    kinds = ("STEP", "LINEAR", "BSPLINE", "NURBS")
    channels = [
        Channel(joint, "translation", TIMES, (PLACES * (joint + 1)).astype(np.float32), kinds[joint % 4])
        for joint in range(8)
    ]
    together = Clip("all", tuple(channels), 3.5, rest(9)).sample(MOMENTS).translation
    for channel in channels:
        alone = Clip("one", (channel,), 3.5, rest(9)).sample(MOMENTS).translation
        np.testing.assert_array_equal(together[:, channel.joint], alone[:, channel.joint])
    assert not together[:, 8].any()


def test_equal_weights_and_even_times_are_the_uniform_b_spline():
    times, ones = np.arange(6.0), np.ones(6)
    channels = (
        Channel(0, "translation", times, PLACES, "NURBS", key_weights=ones),
        Channel(1, "translation", times, PLACES, "BSPLINE"),
    )
    moved = Clip("both", channels, 5.0, rest(2)).sample(np.linspace(0, 5, 101)).translation
    np.testing.assert_allclose(moved[:, 0], moved[:, 1], atol=1e-6)


def test_knots_repeat_the_first_and_the_last_interval():
    np.testing.assert_array_equal(nurbs.knots(TIMES), KNOTS)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("#weight Arm 2", "should follow the key of Arm"),
        ("#rotate Arm 0 0 0\n#weight Arm 0", "should be 0.001 to 1000"),
        ("#rotate Arm 0 0 0\n#weight Arm nan", "line 2"),
    ],
)
def test_a_wrong_weight_is_refused_with_its_line(tmp_path, text, words):
    with pytest.raises(ContentError, match=words):
        from_text(tmp_path, BONE, move=(text, "interpolation: nurbs"))
