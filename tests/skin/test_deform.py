"""Compiled kernels and NumPy give the same vertices, for every model there is."""

import numpy as np
import pytest
from numpy_skin import posed
from reference_poses import MODELS, character
from statwalk.rig.evaluate import world_from_local


@pytest.mark.parametrize("model", MODELS)
def test_the_vertices_of_every_model_agree(model):
    source = character(model)
    pose = next(iter(source.clips.values())).sample(0.4) if source.clips else source.bind_pose
    world = world_from_local(source.skeleton, pose)
    expected = posed(source.surface, world, pose.weights)
    flat = np.empty((2, source.surface.positions.size), np.float32)
    source.surface.pose_into(
        world, pose.weights, flat[0], flat[1], np.empty((len(source.parts), 6), np.float32)
    )
    size = max(1, float(np.abs(expected[0]).max(initial=0)))
    positions, normals = flat.reshape(2, -1, 3).swapaxes(1, 2)
    assert positions == pytest.approx(expected[0], abs=1e-6 * size)
    assert normals == pytest.approx(expected[1], abs=1e-5)
