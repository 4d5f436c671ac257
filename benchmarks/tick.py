"""Measures a tick for 1, 100 and 1,000 actors of 67 joints: `python benchmarks/tick.py`.

statwalk runs the whole tick: states, transitions and their blends, root motion, poses, history, hash. The
peers only pose: a simple loop over joints in NumPy (find the keys, slerp, multiply with the parent), SciPy's
Slerp for the rotations alone, and three.js's mixer with its world matrices. NumPy and SciPy pose one actor;
for a crowd their time is multiplied.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
from models import figure
from rounds import Three, least, show
from scipy.spatial.transform import Rotation, Slerp
from statwalk.character.role import Role
from statwalk.maths import quat
from statwalk.motion.clip import Channel, Clip
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage

ROUNDS = 12
MACHINE = """
character: figure.glb
initial: STAND
defaults: {blend: 0.3}
states:
  STAND: {motion: clip 0, loop: true}
  WALK: {motion: clip 1, loop: true}
table: |
  state | GO   | STOP
  STAND | WALK | -
  WALK  | -    | STAND
"""


def joint_by_joint(role: Role, clip: Clip) -> Callable[[], None]:
    """Returns one tick of one actor, joint by joint."""
    channels = {(channel.joint, channel.path): channel for channel in clip.channels}
    parents, time = role.character.skeleton.parent, 0.0

    def tick() -> None:
        nonlocal time
        time = (time + 1 / 60) % clip.duration
        worlds: list[np.ndarray] = []
        for joint, parent in enumerate(parents):
            local = np.eye(4)
            if (joint, "rotation") in channels:
                start, end, part = between(channels[joint, "scale"], time)
                local[:3, :3] = quat.to_matrix(quat.slerp(*between(channels[joint, "rotation"], time))) * (
                    start + (end - start) * part
                )
                start, end, part = between(channels[joint, "translation"], time)
                local[:3, 3] = start + (end - start) * part
            worlds.append(local if parent < 0 else worlds[parent] @ local)

    return tick


def between(channel: Channel, time: float) -> tuple[np.ndarray, np.ndarray, float]:
    """Returns the keys before and after a time, and the fraction between them."""
    key = min(int(np.searchsorted(channel.times, time, "right")) - 1, len(channel.times) - 2)
    part = (time - channel.times[key]) / (channel.times[key + 1] - channel.times[key])
    return channel.values[key].astype(float), channel.values[key + 1].astype(float), float(part)


def scipy_slerp(clip: Clip) -> Callable[[], None]:
    """Returns one tick that samples the rotations of one actor."""
    rotations = [channel for channel in clip.channels if channel.path == "rotation"]
    slerps = [
        Slerp(channel.times.astype(float), Rotation.from_quat(channel.values.astype(float)))
        for channel in rotations
    ]

    def tick() -> None:
        for slerp in slerps:
            slerp(0.37)

    return tick


def crowd(role: Role, actors: int) -> Stage:
    """Returns a stage on which half of the actors walk, at different phases."""
    stage = Stage()
    for number in range(actors):
        actor = stage.add(role, position=(number % 32, 0, number // 32))
        if number % 2 == 0:
            stage.send(actor, "GO")
        if number % 50 == 0:
            stage.step()
    stage.step(120)
    return stage


def main() -> None:
    """Prints the tables."""
    with tempfile.TemporaryDirectory() as temporary, Three() as three:
        folder = Path(temporary)
        model = folder / "figure.glb"
        model.write_bytes(figure(100))
        (folder / "machine.yaml").write_text(MACHINE)
        role = load_role(folder)
        clip = role.character.clip("clip 1")
        for actors in (1, 100, 1000):
            jobs = {
                "statwalk": crowd(role, actors).step,
                "NumPy, joint by joint": joint_by_joint(role, clip),
                "SciPy Slerp": scipy_slerp(clip),
                "three.js mixer + world": three.job("pose", path=str(model), actors=actors),
            }
            seconds = least(jobs, ROUNDS)
            for single_actor_peer in ("NumPy, joint by joint", "SciPy Slerp"):
                seconds[single_actor_peer] *= actors
            show(
                f"tick of {actors} actors of {len(role.character.skeleton)} joints: "
                f"{seconds['statwalk'] / actors * 1e6:.2f} us each",
                seconds,
            )


if __name__ == "__main__":
    main()
