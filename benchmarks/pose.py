"""Measures poses of 67 joints from a clip to world matrices, for 1, 100 and 1,000 actors: `python
benchmarks/pose.py`.

three.js plays the same clip of the same file with its mixer and updateMatrixWorld, one actor after another.
First the script measures the sampling of the tick, without matrices, into a pose buffer: with all channels of
67 joints, and with 29 rotations, as in a walk.
"""

from __future__ import annotations

import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from models import figure
from rounds import Three, least, show
from statwalk.files.gltf import read_model
from statwalk.maths.pose import Pose
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.simd.aligned import zeros
from statwalk.motion.clip import Clip
from statwalk.motion.root import STANDING
from statwalk.motion.single import Single
from statwalk.motion.tables.build import tables_of
from statwalk.rig.evaluate import world_from_local

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "support"))
import lane_kernels

ROUNDS = 15


def thinned(clip: Clip, joints: int) -> Clip:
    """Returns the clip with only the rotations of the first `joints` joints."""
    rotations = tuple(
        channel for channel in clip.channels if channel.path == "rotation" and channel.joint < joints
    )
    return replace(clip, channels=rotations)


def sampled(title: str, clips: list[Clip], rest: Pose) -> None:
    """Prints nanoseconds an actor, for one actor and for a crowd that plays all clips."""
    tables = tables_of([Single(clip, STANDING) for clip in clips], rest)
    memory = np.empty(tables.most_members), zeros(tables.memory)
    for actors in (1, 1000):
        states = (np.arange(actors) % len(clips)).reshape(-1, 1)
        times, parameters = np.random.default_rng(1).random((actors, 1)), np.zeros((actors, 1))
        buffer = PoseBuffer.at_rest(rest, actors)

        def play(
            arguments: tuple = (tables, states, times, 0, False, parameters, *memory, buffer.values),
        ) -> None:
            lane_kernels.sample_all(*arguments)

        seconds = least({"statwalk": play}, ROUNDS)["statwalk"]
        print(f"{title}, {actors} actors sampled into their buffer: {seconds / actors * 1e9:.0f} ns each")


def main() -> None:
    """Prints the tables."""
    data = figure(100)
    character = read_model(data, "figure")
    clips = list(character.clips.values())
    sampled("29 rotations of 67 joints", [thinned(clip, 29) for clip in clips], character.bind_pose)
    sampled("670 channels of 67 joints", clips, character.bind_pose)
    clip = character.clip("clip 0")
    with tempfile.TemporaryDirectory() as folder, Three() as three:
        path = Path(folder) / "figure.glb"
        path.write_bytes(data)
        for actors in (1, 100, 1000):
            times = (0.37 * np.arange(actors)) % 1

            def statwalk_job(times: np.ndarray = times) -> None:
                world_from_local(character.skeleton, clip.sample(times))

            jobs = {
                "statwalk": statwalk_job,
                "three.js mixer + world": three.job("pose", path=str(path), actors=actors),
            }
            seconds = least(jobs, ROUNDS)
            show(
                f"pose of {actors} actors: statwalk {seconds['statwalk'] / actors * 1e6:.2f} us each", seconds
            )


if __name__ == "__main__":
    main()
