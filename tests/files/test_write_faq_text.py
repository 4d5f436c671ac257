from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np
import pytest
import statwalk
from reference_poses import MODELS, character
from statwalk.character.character import Character
from statwalk.files.bvh.write_bvh import one_word_names
from statwalk.files.held_parts import carriers
from statwalk.files.write_faq_text import write_faq_files
from statwalk.rig.evaluate import world_from_local
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


def test_a_bone_leads_to_each_of_several_children(tmp_path: Path) -> None:
    source = next(read for read in map(character, MODELS) if len(read.skeleton) > 8)
    read = back(replace(source, clips={}), tmp_path)
    assert any(".to." in name for name in read.skeleton.names)
