"""Crowds whose poses, with offsets on top, are worked out in lanes, tick by tick, from poses drawn by
chance.
"""

import lane_kernels
import numpy as np
import slow_inertialize
from scipy.spatial.transform import Rotation
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.simd.aligned import zeros
from statwalk.motion.layer_lanes import LayerMasks
from statwalk.motion.layers import Mask
from statwalk.stage.state.pose_offsets import PoseOffsets, Transitions, offset_size
from statwalk.stage.steps import offset_begin, offset_lanes

DT = 1 / 60
JOINTS, WEIGHTS, ACTORS, LAYERS = 4, 2, 21, 3
REST, SIZE = rest(JOINTS, WEIGHTS), offset_size(JOINTS, WEIGHTS)
MASKS = [
    Mask(np.arange(JOINTS), np.arange(WEIGHTS)),
    Mask(np.array([1, 2, 3]), np.array([1])),
    Mask(np.array([3]), np.zeros(0, int)),
]
LAYER_MASKS = LayerMasks.of(MASKS, JOINTS, WEIGHTS)
NEVER = -1.0


def poses(rng, actors=ACTORS):
    turns = Rotation.random(actors * JOINTS, random_state=rng).as_quat().reshape(actors, JOINTS, 4)
    parts = rng.normal(size=(2, actors, JOINTS, 3))
    return Pose(
        *(
            a.astype(np.float32)
            for a in (parts[0], turns, 1 + 0.1 * parts[1], rng.normal(size=(actors, WEIGHTS)))
        )
    )


def nudged(pose, rng):
    """The poses a tick later, moved a little."""
    return slow_inertialize.add(
        pose, rng.normal(size=(len(pose.rotation), SIZE)).astype(np.float32) * np.float32(0.03)
    )


class Crowd:
    """Actors with offsets in lanes, as a tick has them."""

    def __init__(self, shown, before, layers=LAYERS, masks=LAYER_MASKS):
        self.shown, self.before, self.masks = PoseBuffer.of(REST, shown), PoseBuffer.of(REST, before), masks
        self.offsets = PoseOffsets.none(self.shown.count, layers, SIZE)
        self.scratch = zeros(16 * offset_lanes.scratch_size(layers)).reshape(-1, 16)
        self.way = np.zeros((self.shown.count, 3))

    def tick(self, new, following, seconds, quintic=None, way=None):
        quintic = np.zeros(seconds.shape, bool) if quintic is None else quintic
        coming, ahead = PoseBuffer.of(REST, new), PoseBuffer.of(REST, following)
        buffers = self.before.values, self.shown.values, coming.values, ahead.values
        block = 0
        while True:
            asked = (
                self.offsets,
                Transitions(seconds, quintic),
                self.masks,
                *buffers,
                self.way,
                DT,
                block,
                self.scratch,
            )
            block = offset_begin.begin(*asked)
            if block == len(coming.values):
                break
            self.offsets = self.offsets.grown()
        self.way = np.zeros_like(self.way) if way is None else way.copy()
        lane_kernels.pass_time(self.offsets, DT, self.way)
        lane_kernels.add(self.offsets, self.masks, coming.values, self.scratch)
        self.before, self.shown = self.shown, coming
        return self.shown.poses()


def life(rng, ticks, actors=ACTORS):
    """What comes at each tick: new poses, those a tick later, transitions (one layer of an actor) and
    ways.
    """
    pose = poses(rng, actors)
    for _ in range(ticks):
        layer = rng.integers(3 * LAYERS, size=(actors, 1))
        seconds = np.where(np.arange(LAYERS) == layer, rng.uniform(0.05, 0.2, (actors, LAYERS)), NEVER)
        pose = Pose(
            *(
                np.where(_of_rows(seconds, a), b, a)
                for a, b in zip(nudged(pose, rng), poses(rng, actors), strict=True)
            )
        )
        yield (
            pose,
            nudged(pose, rng),
            seconds,
            rng.uniform(size=seconds.shape) < 0.5,
            rng.normal(size=(actors, 3)),
        )


def _of_rows(seconds, array):
    return (seconds[:, 0] > 0).reshape(-1, *(1,) * (array.ndim - 1))


def lived(rows, ticks=40, seed=5):
    """The actors of some rows of a crowd, after so many ticks."""
    rng = np.random.default_rng(seed)
    shown, before = poses(rng), poses(rng)
    crowd = Crowd(shown.take(rows), before.take(rows))
    for pose, following, *rest_ in life(rng, ticks):
        crowd.tick(pose.take(rows), following.take(rows), *(array[rows] for array in rest_))
    return crowd
