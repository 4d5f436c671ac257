"""KF9 principles of motion (FAQ Q1): what a program can do for the animator, in files and in Python."""

import numpy as np
import pytest
from builders import character as tiny
from paths import MACHINES
from playing import role_of, text_of
from scipy.spatial.transform import Rotation
from statwalk.character.made_clips import sides_of
from statwalk.errors import ContentError, MachineError
from statwalk.files.character_file import load_character_file
from statwalk.maths.easing import EASINGS
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip, Marker
from statwalk.motion.principles.anticipate import anticipate
from statwalk.motion.principles.ease import ease
from statwalk.motion.principles.exaggerate import exaggerate
from statwalk.motion.principles.retime import retime, to_frames
from statwalk.motion.principles.sides import Sides, partner_name
from statwalk.motion.principles.squash import squash
from statwalk.motion.principles.twinning import twinning
from text_character import from_text

TIMES = np.array([0, 0.4, 1, 2], np.float32)
PLACES = np.array([[0, 0, 0], [1, 0, 2], [3, -1, 0], [2, 2, 2]], np.float32)
MOMENTS = np.linspace(0, 2, 21)
ANGLES = np.array([0.0, 50, -30, 40])


def turns(angles=ANGLES, axis="z") -> np.ndarray:
    return Rotation.from_euler(axis, angles[:, None], degrees=True).as_quat().astype(np.float32)


def clip_of(*channels: Channel, **more) -> Clip:
    return Clip("move", channels, 2.0, rest(2), **more)


MOVE = clip_of(Channel(0, "translation", TIMES, PLACES), markers=(Marker("left", 1.0),))


@pytest.mark.parametrize("kind", ["LINEAR", "CUBICSPLINE", "BSPLINE_THROUGH", "NURBS", "STEP"])
def test_retime_shows_every_pose_at_its_new_time(kind):
    values = np.stack([PLACES, PLACES, PLACES], 1) if kind == "CUBICSPLINE" else PLACES
    clip = clip_of(Channel(0, "translation", TIMES, values, kind), markers=(Marker("left", 1.0),))
    fast = retime(clip, 2.0)
    assert (fast.duration, fast.markers) == (1.0, (Marker("left", 0.5),))
    np.testing.assert_allclose(
        fast.sample(MOMENTS / 2).translation, clip.sample(MOMENTS).translation, atol=2e-6
    )


def test_a_length_in_frames():
    assert to_frames(MOVE, 12).duration == 0.5
    assert to_frames(MOVE, 12, 30).duration == 0.4


@pytest.mark.parametrize("name", EASINGS)
def test_ease_maps_time_by_the_easing(name):
    eased = ease(MOVE, name)
    wanted = MOVE.sample(2 * EASINGS[name](MOMENTS / 2)).translation
    np.testing.assert_allclose(eased.sample(MOMENTS).translation, wanted, atol=5e-3)
    (marker,) = eased.markers
    np.testing.assert_allclose(2 * EASINGS[name](marker.time / 2), 1.0, atol=1e-9)


def test_an_eased_clip_starts_and_ends_at_rest():
    places = ease(MOVE, "smoothstep").sample(np.array([0, 0.02, 1.98, 2])).translation[:, 0]
    assert np.abs(places[1] - places[0]).max() < 0.01 > np.abs(places[3] - places[2]).max()


def test_held_keys_stay_held_when_eased():
    door = clip_of(Channel(0, "translation", TIMES, PLACES, "STEP"))
    shown = ease(door, "ease-in").sample(MOMENTS).translation[:, 0]
    assert {tuple(row) for row in shown} == {tuple(row) for row in PLACES}


def test_exaggeration_scales_about_the_mean_over_time():
    clip = clip_of(
        Channel(0, "translation", np.array([0, 2], np.float32), PLACES[:2]),
        Channel(1, "rotation", np.array([0, 2], np.float32), turns(np.array([-20.0, 40]))),
    )
    bold = exaggerate(clip, 1.5).sample(MOMENTS)
    plain = clip.sample(MOMENTS)
    middle = plain.translation[:-1, 0].mean(0)
    # the mean of all frames but the last lies half a frame before the middle of a line
    np.testing.assert_allclose(
        bold.translation[:, 0] - middle, 1.5 * (plain.translation[:, 0] - middle), atol=0.03
    )
    angle = Rotation.from_quat(bold.rotation[:, 1]).as_euler("xyz", degrees=True)[:, 2]
    np.testing.assert_allclose(angle, 10 + 1.5 * np.linspace(-30, 30, 21), atol=0.3)


def test_exaggeration_0_is_the_mean_pose_and_1_the_clip():
    still = exaggerate(MOVE, 0).sample(MOMENTS).translation
    assert np.ptp(still, axis=0).max() < 1e-6
    np.testing.assert_allclose(
        exaggerate(MOVE, 1).sample(MOMENTS).translation, MOVE.sample(MOMENTS).translation, atol=1e-5
    )


def test_anticipation_goes_against_the_move_first():
    jump = clip_of(Channel(0, "translation", np.array([0, 2], np.float32), PLACES[[0, 3]]))
    ready = anticipate(jump, 0.5, 0.4)
    assert ready.duration == 2.4
    start, deepest, gone = ready.sample(np.array([0, 0.4, 0.8])).translation[:, 0]
    np.testing.assert_allclose(start, PLACES[0], atol=1e-6)
    np.testing.assert_allclose(deepest, -0.5 * PLACES[3] * 0.2, atol=1e-5)
    np.testing.assert_allclose(gone, PLACES[3] * 0.2, atol=1e-5)


def test_anticipation_of_a_turn_turns_the_other_way():
    clip = clip_of(Channel(1, "rotation", np.array([0, 2], np.float32), turns(np.array([0.0, 80]))))
    shown = Rotation.from_quat(anticipate(clip, 1.0, 0.5).sample(np.array([0.5, 1, 2.5])).rotation[:, 1])
    np.testing.assert_allclose(shown.as_euler("xyz", degrees=True)[:, 2], [-20, 20, 80], atol=1e-3)


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_squash_keeps_the_volume(axis):
    ball = squash(clip_of(), 0, {0: 1, 0.2: 0.4, 0.5: 1.8, 1: 1}, axis)
    scale = ball.sample(np.linspace(0, 1, 2001)).scale[:, 0].astype(np.float64)
    np.testing.assert_allclose(scale.prod(-1), 1, atol=1e-6)
    np.testing.assert_allclose(ball.sample(0.2).scale[0, "xyz".index(axis)], 0.4, atol=1e-6)


def test_squash_of_a_skinned_character_keeps_its_volume():
    knight = load_character_file(MACHINES / "faq-walker" / "walker.glb")
    clip = squash(knight.clip("stand"), 0, {0: 0.6})
    frames = knight.world(clip.sample(0.0))[:, :3, :3].astype(np.float64)
    plain = knight.world(knight.clip("stand").sample(0.0))[:, :3, :3].astype(np.float64)
    np.testing.assert_allclose(np.linalg.det(frames), np.linalg.det(plain), atol=1e-6)


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("Left.upperarm", "Right.upperarm"),
        ("mixamorig:LeftHand", "mixamorig:RightHand"),
        ("hand_l", "hand_r"),
        ("L_Foot", "R_Foot"),
        ("upperarm.r", "upperarm.l"),
        ("DEF-thigh.R.001", "DEF-thigh.L.001"),
        ("Spine", "Spine"),
        ("Clavicle", "Clavicle"),
    ],
)
def test_partners_by_name(name, other):
    assert (partner_name(name), partner_name(other)) == (other, name)


def figure() -> tuple[Clip, Sides]:
    """Hips, two arms whose own axes point in different directions, and a left horn without partner."""
    pose = rest(4)
    pose.translation[:] = [[0, 1, 0], [0.2, 0.4, 0], [-0.2, 0.4, 0], [0.1, 0.8, 0]]
    pose.rotation[1] = Rotation.from_euler("xyz", [20, 70, -30], degrees=True).as_quat()
    pose.rotation[2] = Rotation.from_euler("xyz", [-80, 10, 40], degrees=True).as_quat()
    frames = Rotation.from_quat(pose.rotation).as_matrix()
    names, parent = ("hips", "arm.L", "arm.R", "horn.L"), np.array([-1, 0, 0, 0])
    arm = Rotation.from_quat(pose.rotation[1]) * Rotation.from_quat(turns(axis="x"))
    clip = Clip("wave", (Channel(1, "rotation", TIMES, arm.as_quat().astype(np.float32)),), 2.0, pose)
    return clip, Sides.of(names, parent, pose, frames)


def test_a_mirrored_arm_turns_from_its_own_rest_as_the_mirror_shows():
    clip, sides = figure()
    left = Rotation.from_quat(clip.sample(MOMENTS).rotation[:, 1])
    away = (left * Rotation.from_quat(clip.rest.rotation[1]).inv()).as_matrix()
    flip = np.diag([-1.0, 1, 1])
    expected = Rotation.from_matrix(flip @ away @ flip) * Rotation.from_quat(clip.rest.rotation[2])
    right = Rotation.from_quat(sides.clip(clip).sample(MOMENTS).rotation[:, 2])
    assert (right * expected.inv()).magnitude().max() < 1e-5


def test_mirroring_twice_gives_the_clip_back_and_names_what_has_no_partner():
    clip, sides = figure()
    twice = sides.clip(sides.clip(clip)).sample(MOMENTS)
    for array, own in zip(twice, clip.sample(MOMENTS), strict=True):
        np.testing.assert_allclose(array, own, atol=1e-6)
    assert sides.alone == ("horn.L",)


def test_a_shipped_walk_mirrored_is_half_a_step_later():
    """The walk's last half mirrors its first (FAQ Q16)."""
    walker = load_character_file(MACHINES / "faq-walker" / "walker.glb")
    walk, sides = walker.clip("walk"), sides_of(walker)
    moments = np.linspace(0, walk.duration / 2, 9)
    mirrored, later = sides.clip(walk).sample(moments), walk.sample(moments + walk.duration / 2)
    apart = Rotation.from_quat(mirrored.rotation.reshape(-1, 4)) * (
        Rotation.from_quat(later.rotation.reshape(-1, 4)).inv()
    )
    assert apart.magnitude().max() < 0.15


def test_twinning_tells_a_clap_from_a_walk():
    clip, sides = figure()
    twin = sides.clip(clip).channels[0]
    same = Clip("clap", (*clip.channels, twin), 2.0, clip.rest)
    (report,) = twinning(same, sides)
    assert (report.left, report.right) == ("arm.L", "arm.R")
    assert report.alike > 0.999
    assert report.is_twinned
    walker = load_character_file(MACHINES / "faq-walker" / "walker.glb")
    legs = {pair.left: pair.alike for pair in twinning(walker.clip("walk"), sides_of(walker))}
    assert legs["Left.upperleg"] < -0.5


CLIPS = """
clips:
  march: {of: walk, seconds: 0.5}
  strut: {of: march, exaggerate: {factor: 1.5, joints: [arm]}, loop: false}
"""


def test_a_machine_plays_clips_that_its_file_makes():
    states = "\nstates:\n  STAND: {motion: strut}\n"
    table = "state | GO\nSTAND | -"
    role = role_of(text_of(table, CLIPS, states))
    assert role.machine.duration[0] == 0.5
    assert role.character.clip("strut").duration == 0.5
    plain, bold = tiny().clip("walk").sample(0.25), role.character.clip("strut").sample(0.125)
    np.testing.assert_allclose(bold.translation[0], plain.translation[0], atol=1e-5)
    twist = [Rotation.from_quat(pose.rotation[2]).magnitude() for pose in (bold, plain)]
    np.testing.assert_allclose(twist[0] / twist[1], 1.5, atol=0.01)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("march: {of: wlak}", "line 21: no clip is called 'wlak'; did you mean walk"),
        ("walk: {of: hop}", "already"),
        ("march: {speed: 2}", "of: walk"),
        ("march: {of: walk, speed: 0}", "from 0.001 to 1000"),
        ("march: {of: walk, ease: sudden}", "no easing is called 'sudden'"),
        ("march: {of: walk, frames: {rate: 30}}", "`count` is missing"),
        ("march: {of: walk, exaggerate: {factor: 2, joints: [arn]}}", "did you mean arm"),
        ("march: {of: walk, squash: {joint: arm, stretch: {}}}", "1 to 1000 factors"),
        ("march: {of: walk, anticipate: {amount: 1, seconds: 0}}", "from 0.001 to 10"),
    ],
)
def test_a_wrong_clip_is_refused_with_its_line(line, words):
    with pytest.raises(MachineError, match=words):
        role_of(text_of(more=f"clips:\n  {line}"))


def test_a_character_file_makes_clips_too(tmp_path):
    text = "#time 0\n#rotate Arm 0 0 0\n#time 1\n#rotate Arm 0 0 60"
    character = from_text(
        tmp_path,
        "Root --- - - - -\nArm Root 2 1 0 0\n",
        move=(text, "seconds: 2}\n  slow: {of: move, speed: 0.5, ease: ease-in-out"),
    )
    assert [character.clip(name).duration for name in ("move", "slow")] == [2.0, 4.0]


def test_a_wrong_clip_of_a_character_file_names_its_line(tmp_path):
    text = "#rotate Arm 0 0 0"
    with pytest.raises(ContentError, match="line 5: no clip is called 'mov'"):
        from_text(
            tmp_path, "Root --- - - - -\nArm Root 2 1 0 0\n", move=(text, "loop: false}\n  b: {of: mov")
        )


@pytest.mark.parametrize(
    ("joint", "stretch", "words"),
    [(2, {0: 1}, "has 2 joints"), (-1, {0: 1}, "has 2 joints"), (0, {np.nan: 1.0}, "times from 0")],
)
def test_an_impossible_squash_is_refused(joint, stretch, words):
    with pytest.raises(ContentError, match=words):
        squash(clip_of(), joint, stretch)


@pytest.mark.parametrize(
    "changed",
    [
        lambda joint: exaggerate(MOVE, 1.3, [joint]),
        lambda joint: anticipate(MOVE, 0.3, 0.2, [joint]),
        lambda joint: squash(MOVE, joint, {0: 1}),
    ],
)
@pytest.mark.parametrize("joint", ["hips", 2, -1, 0.5])
def test_what_is_no_row_of_a_joint_is_refused(changed, joint):
    with pytest.raises(ContentError, match=r"has 2 joints, from 0; none is .*skeleton\.index"):
        changed(joint)


@pytest.mark.parametrize("rate", [0, -1, np.nan])
def test_a_rate_of_frames_is_above_0(rate):
    with pytest.raises(ContentError, match="frames a second"):
        to_frames(MOVE, 12, rate)


def test_sides_mirror_clips_of_their_own_character():
    _, sides = figure()
    with pytest.raises(ContentError, match="moves 2 joints, these sides have 4"):
        sides.clip(MOVE)
