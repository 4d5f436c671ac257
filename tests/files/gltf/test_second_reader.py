"""What is written, read by three.js: its vertices are where ours are."""

import subprocess

import khronos
import numpy as np
import pytest
from paths import ASSETS, ROOT
from reference_poses import character
from scipy.spatial import cKDTree
from statwalk.files.gltf import read_model
from statwalk.files.gltf.recording import recording_glb
from statwalk.files.gltf.recording_draft import Recorded
from statwalk.files.gltf.template import FrameTemplate, PosedCast
from statwalk.files.gltf.write import model_glb
from tiny_model import model

READER, PACKAGES = ROOT / "tests" / "support" / "threereader.mjs", ROOT / "static" / "node_modules"
TICK, RATE = 18, 60
SHARED = [
    "RobotExpressive.glb",
    "Quaternius_Fox.glb",
    "Quaternius_PlatformerCharacter.glb",
    "synthetic/morph_and_skin.glb",
]
NAMES = SHARED if ASSETS.is_dir() else ["faq-walker/walker.glb", "geese/goose/goose.glb", "swarm/bee/bee.glb"]


def threes(folder, data, time=0.0):
    """(V,3) as three.js has them."""
    path = folder / "written.glb"
    path.write_bytes(data)
    command = [khronos.node(), READER, PACKAGES, path, str(time)]
    return np.frombuffer(subprocess.run(command, capture_output=True, check=True).stdout, "<f4").reshape(
        -1, 3
    )


def ours(source, pose):
    return np.concatenate([part.positions for part in source.vertices(pose)])


def furthest(left, right):
    """The distance of the vertex that is furthest from any of the other set, either way; of the figure's
    size.
    """
    distance = max(cKDTree(left).query(right)[0].max(), cKDTree(right).query(left)[0].max())
    return distance / np.ptp(right, axis=0).max()


@pytest.fixture(params=["tiny", *NAMES])
def source(request):
    return read_model(model(), "tiny") if request.param == "tiny" else character(request.param)


def test_a_written_model(source, tmp_path):
    clip = next(iter(source.clips.values()))
    time = clip.duration * 0.4
    assert furthest(threes(tmp_path, model_glb(source), time), ours(source, clip.sample(time))) < 1e-5


def test_a_frame(source, tmp_path):
    poses = next(iter(source.clips.values())).sample(np.array([0.3]))
    data = FrameTemplate([(source, 1)], images=True).frame(
        1, "", [PosedCast(poses, np.zeros((1, 3)), np.zeros(1))]
    )
    assert furthest(threes(tmp_path, data), ours(source, poses.take(0))) < 1e-6


def test_a_recording(source, tmp_path):
    poses = next(iter(source.clips.values())).sample(np.arange(30) / RATE)
    data = recording_glb([Recorded("one", source, poses, np.zeros((30, 3)), np.zeros(30))], RATE)
    assert furthest(threes(tmp_path, data, TICK / RATE), ours(source, poses.take(TICK))) < 1e-3
