"""KF8 motion capture: markers give back the directions of bones; a walk on another body walks upright,
faces +Z, bends its knees forward and stands on the ground; noise goes, without a
delay.
"""

from dataclasses import replace
from functools import cache
from pathlib import Path

import captures
import numpy as np
import pytest
import statwalk
from paths import ASSETS, GLTF, needs_assets
from playing import role_of, text_of
from scipy.signal import butter, sosfiltfilt
from statwalk.character.character import Character
from statwalk.errors import ContentError, MachineError
from statwalk.files.bvh import read_bvh
from statwalk.files.trc.trc_file import read_trc
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.evaluate import world_from_local
from text_character import from_text

WALK = ASSETS / "bvh" / "cmu_12_01_walk.bvh"
MARKERS = {
    "Hips": "Hips",
    "LeftUpLeg": "LHip",
    "RightUpLeg": "RHip",
    "LeftLeg": "LKNE",
    "RightLeg": "RKNE",
    "LeftFoot": "LANK",
    "RightFoot": "RANK",
    "LeftToeBase": "LTOE",
    "RightToeBase": "RTOE",
    "Neck1": "Neck",
    "Head": "Head",
    "LeftArm": "LShoulder",
    "RightArm": "RShoulder",
    "LeftForeArm": "LElbow",
    "RightForeArm": "RElbow",
    "LeftHand": "LWrist",
    "RightHand": "RWrist",
}
BONES = {
    "LeftUpperLeg": ("LHip", "LKNE"),
    "LeftLowerLeg": ("LKNE", "LANK"),
    "RightLowerLeg": ("RKNE", "RANK"),
    "LeftFoot": ("LANK", "LTOE"),
    "LeftUpperArm": ("LShoulder", "LElbow"),
    "RightLowerArm": ("RElbow", "RWrist"),
}


@cache
def hero() -> Character:
    """A body of other proportions and names, its arms hanging, that faces +Z."""
    names = {
        "Hips": "pelvis",
        "LeftUpLeg": "thigh_l",
        "LeftLeg": "calf_l",
        "LeftFoot": "foot_l",
        "LeftArm": "upperarm_l",
    }
    names |= {
        left.replace("Left", "Right"): name[:-1] + "r" for left, name in names.items() if "Left" in left
    }
    text = (
        captures.walk(names)
        .replace("OFFSET 0 -40 0", "OFFSET 0 -25 2")
        .replace("OFFSET 28 0 0", "OFFSET 3 -28 0")
    )
    return read_bvh(text.encode(), "hero", scale=0.02)


def places(character: Character, clip: Clip, times: np.ndarray) -> dict[str, np.ndarray]:
    world = world_from_local(character.skeleton, clip.sample(times))[..., 3].astype(np.float64)
    return {name: world[:, row] for row, name in enumerate(character.skeleton.names)}


def directions(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    way = end - start
    return way / np.linalg.norm(way, axis=-1, keepdims=True)


@needs_assets
def test_markers_of_a_walk_give_back_its_bone_directions() -> None:
    walk = statwalk.load(WALK, scale=0.0564)
    assert isinstance(walk, Character)
    times = np.arange(100) / 30 + 0.1
    known = places(walk, next(iter(walk.clips.values())), times)
    tracks = np.stack([known[joint] for joint in MARKERS], 1)
    solved = read_trc(captures.trc(list(MARKERS.values()), tracks).encode(), "walk")
    found = places(solved, solved.clips["walk"], np.arange(100) / 30)
    at = {marker: known[joint] for joint, marker in MARKERS.items()}
    for bone, (start, end) in BONES.items():
        row = solved.skeleton.index(bone)
        child = solved.skeleton.names[solved.skeleton.parent.tolist().index(row)]
        assert np.abs(directions(found[bone], found[child]) - directions(at[start], at[end])).max() < 1e-5


@needs_assets
def test_rule_12_places_a_knee_that_was_not_seen() -> None:
    walk = statwalk.load(WALK, scale=0.0564)
    assert isinstance(walk, Character)
    known = places(walk, next(iter(walk.clips.values())), np.arange(100) / 30 + 0.1)
    tracks = np.stack([known[joint] for joint in MARKERS], 1)
    tracks[30:60, list(MARKERS).index("LeftLeg")] = np.nan
    solved = read_trc(captures.trc(list(MARKERS.values()), tracks).encode(), "walk")
    found = places(solved, solved.clips["walk"], np.arange(100) / 30)
    assert (
        np.abs(found["LeftLowerLeg"] - found["LeftUpperLeg"] - (known["LeftLeg"] - known["LeftUpLeg"])).max()
        < 0.04
    )
    assert "rule 12" in solved.notes[0]


@pytest.mark.parametrize("heading", [0.0, 70.0, 180.0])
def test_a_walk_on_another_body_is_upright_and_faces_forward(heading: float) -> None:
    walk = read_bvh(captures.walk(heading=heading).encode(), "walk")
    clip, report = statwalk.retarget(walk.clips["walk"], walk, hero())
    at = places(hero(), clip, np.linspace(0, clip.duration, 20))
    assert at["pelvis"][0, ::2] == pytest.approx([0, 0], abs=1e-5)
    assert at["pelvis"][-1, 2] > 0.5
    assert abs(at["pelvis"][-1, 0]) < 0.05
    assert (at["Head"][:, 1] > at["pelvis"][:, 1] + 0.9).all()
    assert (at["LeftHand"][:, 1] < at["upperarm_l"][:, 1] - 0.8).all()
    for knee, hip, foot in (("calf_l", "thigh_l", "foot_l"), ("calf_r", "thigh_r", "foot_r")):
        assert (at[knee][:, 2] - (at[hip][:, 2] + at[foot][:, 2]) / 2 > -1e-4).all()
    assert report.missing == ()
    assert report.root == "pelvis"


def test_the_soles_stay_on_the_ground_and_limbs_keep_their_lengths() -> None:
    walk = read_bvh(captures.walk().encode(), "walk")
    clip, _ = statwalk.retarget(walk.clips["walk"], walk, hero())
    times = np.linspace(0, clip.duration, 31)
    ground = min(part.positions[:, 1].min() for part in hero().vertices(hero().bind_pose))
    lowest = [
        min(part.positions[:, 1].min() for part in hero().vertices(clip.sample(time))) for time in times
    ]
    assert min(lowest) > ground - 0.02
    assert max(lowest) < ground + 0.06
    at = places(hero(), clip, times)
    rest = hero().bind_pose.translation[hero().skeleton.index("calf_l")]
    assert np.linalg.norm(at["calf_l"] - at["thigh_l"], axis=-1) == pytest.approx(
        np.linalg.norm(rest), rel=1e-4
    )


@needs_assets
@pytest.mark.parametrize(
    "model", ["RobotExpressive.glb", "KayKit_Knight.glb", "Quaternius_PlatformerCharacter.glb"]
)
def test_the_cmu_walk_stands_on_the_ground_on_real_models(model: str) -> None:
    walk, target = statwalk.load(WALK), statwalk.load(GLTF / model)
    assert isinstance(walk, Character)
    assert isinstance(target, Character)
    clip, report = statwalk.retarget(next(iter(walk.clips.values())), walk, target)
    at = places(target, clip, np.linspace(0, clip.duration, 40))
    hips, head = report.bones["Hips"][1], report.bones["Head"][1]
    height = at[head][:, 1] - at[hips][:, 1]
    assert (height > 0.85 * np.linalg.norm(at[head] - at[hips], axis=-1)).all()
    ankles = np.minimum(at[report.bones["LeftFoot"][1]][:, 1], at[report.bones["RightFoot"][1]][:, 1])
    rest = world_from_local(target.skeleton, target.bind_pose)[
        target.skeleton.index(report.bones["LeftFoot"][1]), 1, 3
    ]
    assert np.abs(ankles - rest).max() < 0.12 * at[head][:, 1].mean()
    assert at[hips][-1, 2] > abs(at[hips][-1, 0]) * 5


def test_skeletons_without_known_names_are_refused_with_the_bones_to_name() -> None:
    odd = read_bvh(captures.walk({"LeftUpLeg": "q1", "RightUpLeg": "q2", "Hips": "q3"}).encode(), "odd")
    with pytest.raises(ContentError, match=r"do not tell .*Hips"):
        statwalk.retarget(odd.clips["odd"], odd, hero())
    named = {"Hips": "q3", "LeftUpperLeg": "q1", "RightUpperLeg": "q2"}
    clip, report = statwalk.retarget(odd.clips["odd"], odd, hero(), bones=named)
    assert report.missing == ()
    assert clip.duration == pytest.approx(1)


def test_a_filter_is_scipys_without_delay_and_takes_spikes_out() -> None:
    times = np.arange(200) / 100
    calm = np.sin(2 * np.pi * times)
    noisy = calm + 0.2 * np.sin(2 * np.pi * 30 * times)
    values = np.stack([noisy, np.zeros(200), np.zeros(200)], -1)
    clip = Clip("c", (Channel(0, "translation", times, values),), times[-1], hero().bind_pose)
    found = statwalk.filtered(clip, low_pass=6).channels[0].values[:, 0]
    answer = sosfiltfilt(butter(2, 6, fs=100, output="sos"), noisy, padlen=50)
    assert np.abs(found - answer)[30:-30].max() < 1e-3
    assert np.abs(found - calm)[30:-30].max() < 0.03
    wild = values.copy()
    wild[57] += 5
    tame = statwalk.filtered(
        Clip("c", (Channel(0, "translation", times, wild),), 1.99, hero().bind_pose), spikes=True
    )
    assert np.abs(tame.channels[0].values[57, 0] - noisy[57]) < 0.5


JITTER = """
clips:
  calm: {of: walk, loop: true, filter: {low_pass: 2}}
  tame: {of: walk, filter: {spikes: true}}
"""


def shaken(rate: int = 60) -> Clip:
    """A cycle of two seconds, once a second to and fro, with a tremor of 12 Hz."""
    times = np.arange(2 * rate + 1) / rate
    x = np.sin(np.pi * times) + 0.05 * np.sin(24 * np.pi * times)
    channel = Channel(0, "translation", times.astype(np.float32), np.stack([x, 0 * x, 0 * x], -1))
    return Clip("shaken", (channel,), 2.0, hero().bind_pose, loop=True)


def test_a_loop_is_filtered_across_its_seam() -> None:
    calm = statwalk.filtered(shaken(), low_pass=4)
    moments = np.arange(240) / 120
    x = calm.sample(moments, loop=True).translation[:, 0, 0]
    assert np.abs(x - np.sin(np.pi * moments)).max() < 0.01  # the tremor of 0.05 is gone, nothing is late
    around = np.concatenate([x, x[:2]])
    assert np.abs(np.diff(around, 2)).max() < 3 * (np.pi / 120) ** 2  # no corner, also not at the seam


def test_a_curve_is_filtered_and_a_held_key_stays() -> None:
    times = np.array([0, 0.5, 1, 1.5, 2], np.float32)
    values = np.array([[0, 0, 0], [1, 0, 0], [-1, 0, 0], [1, 0, 0], [0, 0, 0]], np.float32)
    curve = Channel(0, "translation", times, values, "BSPLINE_THROUGH")
    held = Channel(1, "scale", times, np.abs(values) + 1, "STEP")
    clip = Clip("c", (curve, held), 2.0, hero().bind_pose)
    calm = statwalk.filtered(clip, low_pass=0.5)
    moments = np.linspace(0, 2, 81)
    before, after = clip.sample(moments), calm.sample(moments)
    assert np.ptp(after.translation[:, 0, 0]) < 0.7 * np.ptp(before.translation[:, 0, 0])
    np.testing.assert_array_equal(after.scale[:, 1], before.scale[:, 1])


def test_any_clip_of_a_machine_is_filtered_by_its_file() -> None:
    role = role_of(text_of("state | GO\nSTAND | -", JITTER, "\nstates:\n  STAND: {motion: calm}\n"))
    source = role.character.clip("walk")
    wanted = statwalk.filtered(replace(source, loop=True), low_pass=2)
    moments = np.linspace(0, source.duration, 50)
    for made, own in zip(role.character.clip("calm").sample(moments), wanted.sample(moments), strict=True):
        np.testing.assert_array_equal(made, own)
    assert role.character.clip("tame").duration == source.duration


def test_a_character_file_filters_its_clips(tmp_path: Path) -> None:
    keys = "".join(f"#time {k / 30}\n#rotate Arm 0 0 {20 * (k % 2)}\n" for k in range(31))
    character = from_text(
        tmp_path,
        "Root --- - - - -\nArm Root 2 1 0 0\n",
        move=(keys, "filter: {low_pass: 3}}\n  raw: {of: move, filter: {spikes: false}"),
    )
    turns = character.clip("move").sample(np.linspace(0.2, 0.8, 60)).rotation[:, 1]
    angles = np.degrees(2 * np.arctan2(turns[:, 2], turns[:, 3]))
    assert np.abs(angles - 10).max() < 1


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("walks: {of: walk, filter: {low_pass: -1}}", "line 21: .*from 0 to 1000"),
        ("walks: {of: walk, filter: {low: 6}}", "line 21: .*low_pass"),
        ("walks: {of: walk, filter: {spikes: perhaps}}", "line 21: "),
    ],
)
def test_a_wrong_filter_is_refused_with_its_line(line: str, words: str) -> None:
    with pytest.raises(MachineError, match=words):
        role_of(text_of(more=f"clips:\n  {line}"))
