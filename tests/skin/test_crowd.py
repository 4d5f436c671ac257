"""One mesh in many poses: sixteen side by side give what NumPy gives one by one."""

import numpy as np
import pytest
from numpy_skin import posed
from paths import MACHINES
from reference_poses import MODELS, character
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.services.library.load import load

ARM = load(MACHINES / "elbow").character


def poses_of(source, count):
    """Poses of the first clip at different times; at rest without clips."""
    clips = list(source.clips.values())
    times = np.linspace(0, clips[0].duration, count) if clips else np.zeros(count)
    rows = [clips[0].sample(float(time)) if clips else source.bind_pose for time in times]
    return Pose(*(np.stack(parts) for parts in zip(*rows, strict=True)))


def check(source, poses):
    vertices = source.crowd_vertices(poses)
    for actor in range(len(poses.rotation)):
        pose = Pose(*(part[actor] for part in poses))
        expected = posed(source.surface, world_from_local(source.skeleton, pose), pose.weights)
        found = vertices.values[actor // 16, :, :, actor % 16].T
        size = max(1, float(np.abs(expected[0]).max(initial=0)))
        assert found[:3] == pytest.approx(expected[0], abs=1e-6 * size)
        assert found[3:] == pytest.approx(expected[1], abs=1e-5)


@pytest.mark.parametrize("model", MODELS)
def test_the_vertices_of_every_model_agree(model):
    source = character(model)
    check(source, poses_of(source, 19))


@pytest.mark.parametrize("way", ["rigid", "parts", "dual-quaternion"])
def test_every_way_of_skinning_gives_the_vertices_of_each_pose(way):
    poses = poses_of(ARM, 17)
    vertices = ARM.crowd_vertices(poses, way)
    for actor in (0, 16):
        expected = ARM.vertices(Pose(*(part[actor] for part in poses)), way)
        for found, part in zip(vertices.parts(actor), expected, strict=True):
            assert found[:3] == part[:3]
            np.testing.assert_allclose(found.positions, part.positions, atol=1e-6)
            np.testing.assert_allclose(found.normals, part.normals, atol=1e-5)


def test_a_pose_of_extreme_size_is_finite_and_leaves_the_others_alone():
    poses = poses_of(ARM, 3)
    poses.scale[1] = 1e25
    vertices = ARM.crowd_vertices(poses)
    assert np.isfinite(vertices.values).all()
    (expected,) = ARM.vertices(Pose(*(part[2] for part in poses)))
    np.testing.assert_allclose(vertices.parts(2)[0].positions, expected.positions, atol=1e-6)


def test_an_actor_that_is_not_there_is_an_error():
    with pytest.raises(IndexError, match="actor 3 of 3"):
        ARM.crowd_vertices(poses_of(ARM, 3)).parts(3)
