"""Weights of a shell for bones: each point on its nearest bone (DS3, DS4), or smooth by bone heat."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np

from statwalk.maths.arrays import Floats
from statwalk.skin.binding.bone_distance import BoneLines, distances, sight
from statwalk.skin.binding.bone_heat import heat_weights
from statwalk.skin.binding.shell import Shell
from statwalk.skin.binding.volume import Volume

Weighting = Literal["heat", "nearest"]


def bind(
    shell: Shell,
    volume: Volume,
    bones: BoneLines,
    joints: int,
    weighting: Weighting = "heat",
    progress: Callable[[float], None] = lambda _: None,
) -> Floats:
    """Returns the weights (N,joints) of the points of a shell, which sum to 1."""
    if weighting == "heat" and len(shell.triangles):
        return heat_weights(shell, sight(shell.points, bones, volume), bones.joint, joints, progress)
    weights = np.zeros((len(shell.points), joints))
    nearest = bones.joint[distances(shell.points, bones).argmin(1)]
    weights[np.arange(len(nearest)), nearest] = 1
    return weights
