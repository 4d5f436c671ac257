from dataclasses import replace

import khronos
import numpy as np
import pytest
from paths import needs_assets
from reference_poses import MODELS, character
from statwalk.files.gltf import read_model
from statwalk.files.gltf.write import model_glb
from statwalk.motion.clip import Channel, Clip
from tiny_model import model

OWN_FAULTS = ("SKIN_NO_COMMON_ROOT",)  # what a source has wrong and a writer cannot know better
PACKED = [name for name in MODELS if name.endswith(".gltf") or name.startswith("Kenney")]


def written(source):
    return read_model(model_glb(source), source.name)


def same_vertices(left, right, clip=None, time=0.0):
    poses = [c.clips[clip].sample(time) if clip else c.bind_pose for c in (left, right)]
    ours, theirs = (
        {(p.node, p.primitive): p for p in c.vertices(pose)}
        for c, pose in zip((left, right), poses, strict=True)
    )
    return ours.keys() == theirs.keys() and all(
        np.allclose(ours[k].positions, theirs[k].positions, atol=1e-5) for k in ours
    )


def test_a_written_model_reads_the_same():
    source = read_model(model(), "tiny")
    assert same_vertices(source, written(source), "Bend", 0.7)


def test_joints_keep_their_names_and_parents():
    source = read_model(model(), "tiny")
    assert written(source).skeleton.names == source.skeleton.names


@needs_assets
@pytest.mark.parametrize(
    "name",
    [
        "RobotExpressive.glb",
        "synthetic/morph_and_skin.glb",
        "AssetGenerator/Animation_Skin/Animation_Skin_10.gltf",
    ],
)
def test_real_models_read_the_same(name):
    source = character(name)
    clip = next(iter(source.clips), None)
    assert same_vertices(source, written(source), clip, 0.4)


@pytest.fixture(scope="module")
def errors_written():
    return khronos.errors_by_name({name: model_glb(character(name)) for name in MODELS})


@pytest.fixture(scope="module")
def errors_packed():
    return khronos.errors_by_name({name: character(name).model_glb for name in PACKED})


@pytest.mark.parametrize("name", MODELS)
def test_the_validator_finds_no_error(errors_written, name):
    assert [error for error in errors_written[name] if not error.startswith(OWN_FAULTS)] == []


@needs_assets
@pytest.mark.parametrize("name", PACKED)
def test_packed_models_have_no_error(errors_packed, name):
    assert [error for error in errors_packed[name] if not error.startswith(OWN_FAULTS)] == []


@pytest.fixture
def curved():
    source = read_model(model(), "tiny")
    times = np.array([0, 0.5, 1], np.float32)
    channel = Channel(
        1, "translation", times, np.array([[0, 0, 0], [0, 2, 0], [0, 0, 0]], np.float32), "BSPLINE"
    )
    return replace(source, clips={"Curve": Clip("Curve", (channel,), 1.0, source.bind_pose)})


@pytest.mark.parametrize("time", [0.0, 0.25, 0.613, 1.0])
def test_b_splines_are_written_as_keys_near_the_curve(curved, time):
    ours, theirs = curved.clips["Curve"].sample(time), written(curved).clips["Curve"].sample(time)
    assert theirs.translation == pytest.approx(ours.translation, abs=1e-3)


def test_baked_clips_have_no_error(curved):
    assert khronos.errors(model_glb(curved)) == []


def test_turns_are_written_at_unit_length():
    assert khronos.errors(model_glb(read_model(model(), "tiny"))) == []
