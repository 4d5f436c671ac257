"""three.js and pygltflib read what statwalk writes, and find the vertices where statwalk puts them."""

import numpy as np
import pygltflib
import pytest
import three_reader
from ground_truth.truth import character
from statwalk import Character, Pose
from statwalk.files.glb.recording import Recorded, recording_glb
from statwalk.files.glb.template import FrameTemplate, PosedCast, stage_worlds
from where import needs_assets

MODELS = ["RobotExpressive.glb", "Quaternius_Fox.glb", "KayKit_Knight.glb", "CesiumMan.glb", "BoxAnimated.glb"]
RATE, TICKS, TICK = 60, 31, 20
PLACE, HEADING = np.array([1.5, 0.0, -2.0]), 0.7


def ordered(points: np.ndarray) -> np.ndarray:
    """Each coordinate by size: readers list meshes in orders of their own."""
    return np.sort(np.asarray(points, np.float64), axis=0)


def recorded(source: Character) -> Recorded:
    clip = next(iter(source.clips.values()))
    poses = clip.sample(np.arange(TICKS) / RATE, loop=True)
    return Recorded("one", source, poses, np.tile(PLACE, (TICKS, 1)), np.full(TICKS, HEADING), 0)


def posed(one: Recorded) -> PosedCast:
    row = slice(TICK, TICK + 1)
    return PosedCast(Pose(*(array[row] for array in one.poses)), one.root_position[row], one.heading[row])


def expected(one: Recorded) -> np.ndarray:
    world = stage_worlds(one.character, posed(one))[0]
    parts = one.character.surface.posed_parts(world, one.poses.weights[TICK])
    return np.concatenate([part.positions for part in parts])


def size(points: np.ndarray) -> float:
    return float(np.ptp(points, axis=0).max())


def by_pygltflib(data: bytes) -> np.ndarray:
    """The positions of a posed frame; its nodes stand still, so they are the world's."""
    document = pygltflib.GLTF2.load_from_bytes(data)
    found = []
    for primitive in (primitive for mesh in document.meshes for primitive in mesh.primitives):
        accessor = document.accessors[primitive.attributes.POSITION]
        view = document.bufferViews[accessor.bufferView]
        start = (view.byteOffset or 0) + (accessor.byteOffset or 0)
        found.append(np.frombuffer(document.binary_blob(), "<f4", 3 * accessor.count, start).reshape(-1, 3))
    return np.concatenate(found)


@pytest.fixture(params=MODELS)
def one(request) -> Recorded:
    return recorded(character(request.param))


@needs_assets
def test_three_finds_a_frames_vertices(one):
    data = FrameTemplate([(one.character, 1)]).frame(TICK, "0" * 16, [posed(one)])
    wanted = expected(one)
    np.testing.assert_allclose(ordered(three_reader.vertices(data)[0]), ordered(wanted), atol=2e-6 * size(wanted) + 1e-6)


@needs_assets
def test_pygltflib_finds_a_frames_vertices(one):
    data = FrameTemplate([(one.character, 1)]).frame(TICK, "0" * 16, [posed(one)])
    wanted = expected(one)
    np.testing.assert_allclose(ordered(by_pygltflib(data)), ordered(wanted), atol=2e-6 * size(wanted) + 1e-6)


@needs_assets
def test_three_plays_a_recording(one):
    """Within the recording's own bound: keys that do not matter are dropped."""
    data, wanted = recording_glb([one], RATE), expected(one)
    found = three_reader.vertices(data, seconds=TICK / RATE)[0]
    np.testing.assert_allclose(ordered(found), ordered(wanted), atol=2e-3 * size(wanted))
