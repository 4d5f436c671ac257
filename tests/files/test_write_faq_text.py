from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
import statwalk
from reference_poses import MODELS, character
from statwalk.character.character import Character
from statwalk.files.bvh.write_bvh import one_word_names
from statwalk.files.held_parts import TURNED_LIMITS, carriers
from statwalk.files.model_formats import CHARACTER_TEXT
from statwalk.files.write_faq_text import write_faq_files
from statwalk.maths.clamp_table import JointLimit
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.joint_types import axis_limits, joint
from statwalk.rig.limits import excess
from whole_character import whole


def back(source: Character, folder: Path) -> Character:
    """The character, written and read again."""
    for name, data in write_faq_files(source, "back").items():
        (folder / name).write_bytes(data)
    loaded = statwalk.load(folder / "back.yaml")
    assert isinstance(loaded, Character)
    return loaded


SMALL = [name for name in MODELS if "/" not in name and len(character(name).skeleton) < 60][::3]


@pytest.mark.parametrize("name", SMALL)
def test_joints_are_where_they_were_in_every_clip(name: str, tmp_path: Path) -> None:
    source = character(name)
    source = replace(source, clips=dict(islice(source.clips.items(), 2)))
    read = back(source, tmp_path)
    assert list(read.clips) == list(source.clips)
    joints = [joint for joint in range(len(source.skeleton)) if joint not in carriers(source)]
    names = one_word_names(source.skeleton.names)
    rows = [read.skeleton.index(names[joint]) for joint in joints]
    size = np.ptp(world_from_local(source.skeleton, source.bind_pose)[..., 3], 0).max()
    for clip in source.clips:
        times = np.arange(0, source.clips[clip].duration, 1 / 60)
        here = world_from_local(read.skeleton, read.clips[clip].sample(times))[:, rows, :, 3]
        there = world_from_local(source.skeleton, source.clips[clip].sample(times))[:, joints, :, 3]
        assert np.abs(here - there).max() < 2e-3 * max(size, 1e-3)


def test_the_files_are_the_character_the_skeleton_and_the_clips() -> None:
    files = write_faq_files(whole(), "w")
    assert list(files) == ["w.yaml", "w.skeleton.txt", "w.Bend.txt", "w.Curves.txt"]
    assert b"loop: true" in files["w.yaml"]


def limited(source: Character, **limits: JointLimit) -> Character:
    return replace(source, limits=limits)


def excess_of(source: Character, clip: str) -> np.ndarray:
    """By how much the joints of a clip leave their limits: radians and metres (T, L)."""
    rows = {source.skeleton.index(name): limit for name, limit in source.limits.items()}
    return np.stack(excess(rows, source.bind_pose, source.clips[clip].sample(np.linspace(0, 0.5, 9))))


HINGE = joint("revolute", {"angle": (-0.1, 0.2)}, axis=(1, 0.2, 0))
BALL = joint("spherical", {"swing_x": (-0.1, 0.2), "swing_z": (-0.1, 0.1), "twist": (-0.05, 0.05)})
AXES = axis_limits(((-0.1, 0.2), (0.0, 0.1), (-0.3, 0.3)), ((0.0, 0.0),) * 3)


def test_limits_of_each_axis_are_the_faqs_table(tmp_path: Path) -> None:
    mammal = limited(statwalk.load("faq-printed").character, Head=AXES)
    assert b"Head" in write_faq_files(mammal, "m")["m.limits.txt"]
    (read,) = back(mammal, tmp_path).limits.values()
    np.testing.assert_allclose(read.angles, AXES.angles, atol=1e-12)
    assert read.slide == AXES.slide


def test_joints_with_turned_axes_are_limited_in_the_same_places(tmp_path: Path) -> None:
    """A stride leaves the limits by the same angles, though the bones of the file have other axes."""
    walker = statwalk.load("faq-walker").character
    source = limited(
        replace(walker, clips={"walk": walker.clips["walk"]}),
        **{"Left.hand": HINGE, "Left.lowerarm": HINGE, "Right.upperleg": BALL},
    )
    read = back(source, tmp_path)
    assert read.limits.keys() == source.limits.keys()
    left = excess_of(source, "walk")
    assert (left[0].max(0) > 0.05).sum() >= 2
    np.testing.assert_allclose(excess_of(read, "walk"), left, atol=2e-4)


def test_limits_of_each_axis_of_turned_joints_are_a_loss(tmp_path: Path) -> None:
    source = limited(statwalk.load("faq-walker").character, Head=AXES)
    assert back(replace(source, clips={}), tmp_path).limits == {}
    lost = {loss.part: loss.names for loss in CHARACTER_TEXT.losses(source)}
    assert lost[TURNED_LIMITS] == ("Head",)


def test_a_bone_leads_to_each_of_several_children(tmp_path: Path) -> None:
    read = back(replace(statwalk.load("faq-walker").character, clips={}), tmp_path)
    assert any(".to." in name for name in read.skeleton.names)
