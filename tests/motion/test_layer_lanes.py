"""Layers in lanes against the NumPy form, and their laws: no weight leaves bits, masks hold, any lane gives
the same bits.
"""

import lane_kernels
import numpy as np
import pytest
import slow_layers
from scipy.spatial.transform import Rotation
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.motion import layer_lanes
from statwalk.motion.layers import Mask

JOINTS, WEIGHTS, ACTORS = 5, 3, 21
REST = rest(JOINTS, WEIGHTS)
MASKS = [Mask(np.arange(JOINTS), np.arange(WEIGHTS)), Mask(np.array([1, 3]), np.array([2]))]
LAYER_MASKS = layer_lanes.LayerMasks.of(MASKS, JOINTS, WEIGHTS)
RNG = np.random.default_rng(17)


def poses(actors=ACTORS):
    turns = Rotation.random(actors * JOINTS, random_state=RNG).as_quat().reshape(actors, JOINTS, 4)
    parts = RNG.normal(size=(2, actors, JOINTS, 3))
    return Pose(
        *(
            a.astype(np.float32)
            for a in (parts[0], turns, 1 + 0.1 * parts[1], RNG.normal(size=(actors, WEIGHTS)))
        )
    )


UNDER, OVER, FIRST = poses(), poses(), poses()
WEIGHT = RNG.uniform(size=ACTORS)
WEIGHT[[0, 5, 20]], WEIGHT[[1, 18]] = 0, 1


def overridden(under, over, _first, weight, layer):
    buffer = PoseBuffer.of(REST, under)
    lane_kernels.override(
        buffer.values, PoseBuffer.of(REST, over).values, columns(weight, layer), LAYER_MASKS, layer
    )
    return buffer


def added(under, over, first, weight, layer):
    buffer, others = PoseBuffer.of(REST, under), [PoseBuffer.of(REST, pose).values for pose in (over, first)]
    lane_kernels.additive(buffer.values, *others, columns(weight, layer), LAYER_MASKS, layer)
    return buffer


def columns(weight, layer):
    found = np.full((len(weight), len(MASKS)), np.nan)
    found[:, layer] = weight
    return found


MODES = {
    overridden: lambda u, o, _, w, layer: slow_layers.override(u, o, w, MASKS[layer]),
    added: lambda u, o, f, w, layer: slow_layers.additive(u, o, f, w, MASKS[layer]),
}
modes = pytest.mark.parametrize("lay", MODES)
layers = pytest.mark.parametrize("layer", range(len(MASKS)))


@modes
@layers
def test_sixteen_at_a_time_give_what_numpy_gives(lay, layer):
    found, expected = (
        lay(UNDER, OVER, FIRST, WEIGHT, layer).poses(),
        MODES[lay](UNDER, OVER, FIRST, WEIGHT, layer),
    )
    for ours, theirs in zip(found, expected, strict=True):
        assert ours == pytest.approx(theirs, abs=3e-6)


@modes
def test_without_weight_not_a_bit_changes(lay):
    found = lay(UNDER, OVER, FIRST, WEIGHT, 0).poses(np.array([0, 5, 20]))
    assert all((ours == theirs).all() for ours, theirs in zip(found, UNDER.take([0, 5, 20]), strict=True))


@modes
def test_what_a_mask_leaves_out_keeps_its_bits(lay):
    found = lay(UNDER, OVER, FIRST, np.ones(ACTORS), 1).poses()
    for before, after in zip(UNDER[:3], found[:3], strict=True):
        assert (before[:, [0, 2, 4]] == after[:, [0, 2, 4]]).all()
        assert (before[:, [1, 3]] != after[:, [1, 3]]).any((1, 2)).all()
    assert (UNDER.weights[:, :2] == found.weights[:, :2]).all()


@modes
def test_rotations_stay_of_unit_length(lay):
    assert np.linalg.norm(lay(UNDER, OVER, FIRST, WEIGHT, 0).poses().rotation, axis=-1) == pytest.approx(
        1, abs=1e-6
    )


def test_with_all_its_weight_a_layer_is_what_is_shown():
    found = overridden(UNDER, OVER, FIRST, np.ones(ACTORS), 0).poses()
    assert (found.translation == OVER.translation).all()
    assert (found.weights == OVER.weights).all()


@modes
@pytest.mark.parametrize("rows", [[18], [3, 18, 7], list(range(20, -1, -1))])
def test_a_lane_and_its_neighbours_do_not_matter(lay, rows):
    crowd = lay(UNDER, OVER, FIRST, WEIGHT, 0).take(np.array(rows)).rows()
    own = lay(*(pose.take(rows) for pose in (UNDER, OVER, FIRST)), WEIGHT[rows], 0).rows()
    assert own.tobytes() == crowd.tobytes()


@modes
def test_lanes_without_an_actor_rest(lay):
    buffer = lay(UNDER, OVER, FIRST, WEIGHT, 0)
    buffer.count = 32
    assert all((ours == theirs).all() for ours, theirs in zip(buffer.actor(30), REST, strict=True))
