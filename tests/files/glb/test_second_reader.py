"""What is written, read by three.js: its vertices are where ours are."""

import subprocess

import khronos
import numpy as np
import pytest
from ground_truth.truth import character
from scipy.spatial import cKDTree
from statwalk.files.glb import read_model
from statwalk.files.glb.recording import Recorded, recording_glb
from statwalk.files.glb.template import FrameTemplate, PosedCast
from statwalk.files.glb.write import model_glb
from tinymodel import model
from where import ROOT, needs_assets

READER, PACKAGES = ROOT / "tests" / "threereader.mjs", ROOT / "static" / "node_modules"
TICK, RATE = 18, 60
NAMES = ["RobotExpressive.glb", "Quaternius_Fox.glb", "Quaternius_PlatformerCharacter.glb", "synthetic/morph_and_skin.glb"]


def threes(folder, data, time=0.0):
    """(V,3) as three.js has them."""
    path = folder / "written.glb"
    path.write_bytes(data)
    command = [khronos.node(), READER, PACKAGES, path, str(time)]
    return np.frombuffer(subprocess.run(command, capture_output=True, check=True).stdout, "<f4").reshape(-1, 3)


def ours(source, pose):
    return np.concatenate([part.positions for part in source.vertices(pose)])


def furthest(left, right):
    """The distance of the vertex that is furthest from any of the other set, either way; of the figure's size."""
    distance = max(cKDTree(left).query(right)[0].max(), cKDTree(right).query(left)[0].max())
    return distance / np.ptp(right, axis=0).max()


@pytest.fixture(params=["tiny", *(pytest.param(name, marks=needs_assets) for name in NAMES)])
def source(request):
    return read_model(model(), "tiny") if request.param == "tiny" else character(request.param)


def test_a_written_model(source, tmp_path):
    clip = next(iter(source.clips.values()))
    time = clip.duration * 0.4
    assert furthest(threes(tmp_path, model_glb(source), time), ours(source, clip.sample(time))) < 1e-5


def test_a_frame(source, tmp_path):
    poses = next(iter(source.clips.values())).sample(np.array([0.3]))
    data = FrameTemplate([(source, 1)], images=True).frame(1, "", [PosedCast(poses, np.zeros((1, 3)), np.zeros(1))])
    assert furthest(threes(tmp_path, data), ours(source, poses.take(0))) < 1e-6


def test_a_recording(source, tmp_path):
    poses = next(iter(source.clips.values())).sample(np.arange(30) / RATE)
    data = recording_glb([Recorded("one", source, poses, np.zeros((30, 3)), np.zeros(30))], RATE)
    assert furthest(threes(tmp_path, data, TICK / RATE), ours(source, poses.take(TICK))) < 1e-3
