"""FF5 BVH, written: assimp reads what we write, and its joints are where ours are."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
from assimp import needs_assimp
from reference_poses import MODELS, character
from statwalk.character.character import Character
from statwalk.files.bvh import read_bvh
from statwalk.files.bvh.write_bvh import write_bvh
from statwalk.files.gltf import read_model
from statwalk.motion.clip import Clip
from statwalk.rig.evaluate import world_from_local

OF_ONE_FRAME = "M2M_rig_human.glb"
"""its only frame is left out by assimp"""
NAMES = [name for name in MODELS if name.endswith(".glb") and "/" not in name and name != OF_ONE_FRAME]


def places(read: Character, clip: Clip, times: np.ndarray) -> dict[str, np.ndarray]:
    worlds = world_from_local(read.skeleton, clip.sample(times))[..., 3]
    return {name: worlds[:, row] for row, name in enumerate(read.skeleton.names)}


@needs_assimp
@pytest.mark.parametrize("name", NAMES)
def test_assimp_reads_the_same_motion(name: str, tmp_path: Path) -> None:
    (tmp_path / "ours.bvh").write_bytes(write_bvh(character(name)))
    subprocess.run(
        ["assimp", "export", tmp_path / "ours.bvh", tmp_path / "theirs.glb", "-fglb2"],
        check=True,
        capture_output=True,
    )
    ours = read_bvh((tmp_path / "ours.bvh").read_bytes(), "x")
    theirs = read_model((tmp_path / "theirs.glb").read_bytes(), "x")
    (clip,) = ours.clips.values()
    (motion,) = theirs.clips.values()
    times = np.linspace(0, min(clip.duration, motion.duration), 30)
    here, there = places(ours, clip, times), places(theirs, motion, times)
    compared = [name for name in here if not name.endswith(".end")]
    assert compared
    size = max(np.ptp(np.concatenate(list(here.values())), 0).max(), 1e-6)
    assert max(np.abs(here[name] - there[name]).max() for name in compared) < 1e-3 * size
