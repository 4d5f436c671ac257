"""KF8 motion capture: markers give back the directions of bones; a walk on another body walks upright,
faces +Z, bends its knees forward and stands on the ground.
"""

from functools import cache

import builders
import captures
import numpy as np
import pytest
import statwalk
from bone_places import directions, places
from paths import ASSETS, GLTF, needs_assets
from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.bvh import read_bvh
from statwalk.files.trc.trc_file import read_trc
from statwalk.rig.evaluate import world_from_local

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


def test_a_clip_of_another_character_is_refused() -> None:
    walk = read_bvh(captures.walk().encode(), "walk")
    with pytest.raises(ContentError, match="its source tiny has 3: give the character whose clip it is"):
        statwalk.retarget(walk.clips["walk"], builders.character(), hero())


def test_skeletons_without_known_names_are_refused_with_the_bones_to_name() -> None:
    odd = read_bvh(captures.walk({"LeftUpLeg": "q1", "RightUpLeg": "q2", "Hips": "q3"}).encode(), "odd")
    with pytest.raises(ContentError, match=r"do not tell .*Hips"):
        statwalk.retarget(odd.clips["odd"], odd, hero())
    named = {"Hips": "q3", "LeftUpperLeg": "q1", "RightUpperLeg": "q2"}
    clip, report = statwalk.retarget(odd.clips["odd"], odd, hero(), bones=named)
    assert report.missing == ()
    assert clip.duration == pytest.approx(1)
