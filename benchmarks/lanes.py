"""Measures each step of poses in lanes for actors of 67 joints, on one thread, relative to np.copyto of the
same bytes: `python benchmarks/lanes.py`.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
from rounds import Job, least
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.simd.aligned import zeros
from statwalk.motion import layer_lanes
from statwalk.motion.layers import Mask
from statwalk.rig.model_buffer import JointList, ModelBuffer
from statwalk.rig.skeleton import Skeleton
from statwalk.stage.state.pose_offsets import PoseOffsets, Transitions, offset_size
from statwalk.stage.steps import offset_begin, offset_lanes

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))
import lane_kernels

JOINTS, DT, ROUNDS = 67, 1 / 60, 9
ACTORS = (16, 1024)
REST = rest(JOINTS)
PARENTS = np.array([-1, *(min(joint, joint // 2 + 3) - 1 for joint in range(1, JOINTS))], np.int32)


class Measured(NamedTuple):
    """A step, and the number of float32 channels of an actor that it reads and writes."""

    job: Job
    channels: int


def poses(count: int, seed: int) -> PoseBuffer:
    """Returns random poses."""
    chance = np.random.default_rng(seed)
    drawn = [chance.normal(size=(count, *array.shape)).astype(np.float32) for array in REST]
    drawn[1] /= np.linalg.norm(drawn[1], axis=-1, keepdims=True)
    return PoseBuffer.of(REST, Pose(*drawn))


def steps(count: int) -> dict[str, Measured]:
    """Returns every step for `count` actors, by name."""
    under, over, first, following = (poses(count, seed) for seed in range(4))
    masks = layer_lanes.LayerMasks.of([Mask(np.arange(JOINTS), np.arange(0))], JOINTS, 0)
    weights, way = np.full((count, 1), 0.5), np.zeros((count, 3))
    scratch = zeros(16 * offset_lanes.scratch_size(1)).reshape(-1, 16)
    size = offset_size(JOINTS, 0)
    none, fading = (PoseOffsets.none(count, 1, size, len(under.values) + 1) for _ in range(2))
    transitions = Transitions(np.full((count, 1), 0.2), np.zeros((count, 1), bool))
    buffers = over.values, under.values, first.values, following.values

    def begin(offsets: PoseOffsets) -> None:
        offset_begin.begin(offsets, transitions, masks, *buffers, way, DT, 0, scratch)

    begin(fading)
    shown, hashes, never = poses(count, 5), np.zeros(count, np.uint64), PoseOffsets.none(count, 1, size, 1)
    lane_kernels.pass_time(fading, DT, way)
    original = shown.values.copy()

    def add() -> None:
        lane_kernels.add(fading, masks, shown.values, scratch)
        np.copyto(shown.values, original)  # without it the values would grow from call to call

    model = ModelBuffer.room(JointList.of(Skeleton(tuple(map(str, range(JOINTS))), PARENTS)), count)
    pose, used = 10 * JOINTS, 10 * JOINTS
    return {
        "override": Measured(
            lambda: lane_kernels.override(under.values, over.values, weights, masks, 0), 3 * pose
        ),
        "additive": Measured(
            lambda: lane_kernels.additive(under.values, over.values, first.values, weights, masks, 0),
            4 * pose,
        ),
        "offsets begin": Measured(lambda: begin(none), 4 * pose + 2 * size),
        "offsets add (and a copy)": Measured(add, 4 * pose + 2 * size),
        "offsets: none under way": Measured(lambda: lane_kernels.add(never, masks, shown.values, scratch), 1),
        "clocks pass": Measured(lambda: lane_kernels.pass_time(never, DT, way), 1),
        "model space": Measured(lambda: model.fill(under), pose + 12 * JOINTS),
        "hash of poses": Measured(
            lambda: lane_kernels.rehash(hashes, under.values, used, never, scratch), pose
        ),
        "hash of poses and offsets": Measured(
            lambda: lane_kernels.rehash(hashes, under.values, used, fading, scratch), pose + 2 * size
        ),
    }


def copied(channels: int, count: int) -> Job:
    """Returns np.copyto with as many bytes read and written as `count` actors of `channels` need."""
    target, source = (zeros(max(channels * count // 2, 16)) for _ in range(2))
    return lambda: np.copyto(target, source)


def main() -> None:
    """Prints the tables."""
    for count in ACTORS:
        measured = steps(count)
        seconds = least({name: step.job for name, step in measured.items()}, ROUNDS)
        copies = least({name: copied(step.channels, count) for name, step in measured.items()}, 3)
        print(
            f"{count} actors of {JOINTS} joints: nanoseconds an actor, multiples of np.copyto of the same "
            "bytes"
        )
        for name, value in seconds.items():
            print(f"  {name:28} {value / count * 1e9:8.1f} ns {value / copies[name]:8.1f} x")


if __name__ == "__main__":
    main()
