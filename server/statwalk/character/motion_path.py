"""Arcs: the path of a joint through a clip."""

from __future__ import annotations

import numpy as np

from statwalk.character.character import Character
from statwalk.maths.arrays import Floats

PER_SECOND, MOST_POSES = 60, 2000


def motion_path(character: Character, clip: str, joint: str) -> tuple[Floats, Floats]:
    """Returns times (N,) in seconds and the positions (N, 3) of a joint in the character's space, metres: 60
    a second, 2,000 at most.

    :raises UnknownNameError: when the character has no such clip or joint.
    """
    motion, row = character.clip(clip), character.skeleton.index(joint)
    count = int(np.clip(np.ceil(motion.duration * PER_SECOND), 1, MOST_POSES - 1)) + 1
    times = np.linspace(0, motion.duration, count)
    return times, character.world(motion.sample(times))[:, row, :3, 3].astype(np.float64)
