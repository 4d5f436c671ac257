"""Layers: a second motion on some joints of the same character, in place of the layers below or added to
them.

Additive motion is the difference to the first pose of its clip, in the space of each joint: rotations q ·
(first⁻¹ · now), as in three.js (AnimationUtils.makeClipAdditive, PropertyMixer).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from statwalk.maths.arrays import Bools, Ints
from statwalk.maths.columns import lock_fields


@dataclass(frozen=True, eq=False)
class Mask:
    """The joints and morph weights that a layer moves."""

    joints: Ints
    """(j,) rows of the joints"""
    weights: Ints
    """(w,) columns of the morph weights"""

    def __post_init__(self) -> None:
        lock_fields(self)


def below(parent: Ints, roots: Iterable[int]) -> Bools:
    """Returns (J,) the joints `roots` and all their descendants; `parent` (J,) lists parents before
    children.
    """
    is_below = np.zeros(len(parent), bool)
    is_below[list(roots)] = True
    for joint, ancestor in enumerate(parent.tolist()):
        is_below[joint] |= ancestor >= 0 and is_below[ancestor]
    return is_below
