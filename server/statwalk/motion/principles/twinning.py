"""Twinning: how alike left and right move at the same moment. Twins look stiff; an animator offsets them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.motion.clip import Clip
from statwalk.motion.principles.exaggerate import mean
from statwalk.motion.principles.resample import PER_SECOND
from statwalk.motion.principles.sides import Sides

TWINS = 0.9
_STILL = 1e-3


class Twin(NamedTuple):
    """How two partners move: `alike` 1: the same at the same moment, 0: nothing in common, -1: opposite."""

    left: str
    right: str
    alike: float
    swing: float
    """radians, the root of the mean square of both joints' turns from their mean"""

    @property
    def is_twinned(self) -> bool:
        """Returns whether an animator would call the pair twinned: alike to 0.9 or more."""
        return self.alike >= TWINS


def twinning(clip: Clip, sides: Sides) -> tuple[Twin, ...]:
    """Returns a report on each pair of partners that move, the most alike first: the correlation of the one
    joint's turns from its mean with the other's, seen in the mirror.
    """
    count = int(np.ceil(clip.duration * PER_SECOND)) + 1
    poses = clip.sample(np.linspace(0, clip.duration, count))
    twins = []
    for row, other in sides.pairs:
        own = _turns(poses.rotation[:, row].astype(np.float64))
        theirs = _turns(sides.turned(row, poses.rotation[:, other]))
        size = float((own * own).sum()), float((theirs * theirs).sum())
        swing = float(np.sqrt((size[0] + size[1]) / (2 * count)))
        if swing > _STILL:
            norm = float(np.sqrt(size[0] * size[1]))
            alike = float((own * theirs).sum()) / norm if norm > 0 else 0.0
            twins.append(Twin(sides.names[row], sides.names[other], alike, swing))
    return tuple(sorted(twins, key=lambda twin: -twin.alike))


def _turns(rotations: Floats) -> Floats:
    """Rotation vectors (K, 3) from the mean."""
    middle = mean(rotations, is_turn=True)
    return quat.to_rotation_vector(quat.mul(quat.conjugate(middle)[None], rotations))
