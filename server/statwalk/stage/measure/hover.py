"""How high a character hovers: all its soles are above the ground, though its motion stands."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from statwalk.character.feet import Foot
from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.maths.arrays import Bools, Floats
from statwalk.stage.measure.slide import NEAR, soles_above
from statwalk.stage.measure.trials import Recording

LASTING = 3
"""ticks: a height counts as far as the soles keep it for so long"""


def hovers(
    recording: Recording, feet: tuple[Foot, ...], watched: Bools, ground: Sequence[GroundDefinition] = ()
) -> Floats:
    """Returns (N,) metres: the height above the ground that all soles keep for LASTING ticks, beyond the
    height that they have in the motion.

    A tick counts if the motion has a sole near the floor; in a transition, if the motions have had one since
    it began: what comes down from a jump does not hover. `watched` (T, N): the ticks that count.
    """
    if not feet:
        return np.zeros(recording.heading.shape[1])
    lowest = np.min([soles_above(recording, foot, ground).min(-1) for foot in feet], 0)
    hover = np.where(watched & _stands(recording), lowest - recording.low.clip(0), 0).clip(0)
    lasting = np.min([hover[tick : len(hover) - LASTING + 1 + tick] for tick in range(LASTING)], 0)
    highest: Floats = lasting.max(0, initial=0)
    return highest


def _stands(recording: Recording) -> Bools:
    """(T, N) whether the motion has a sole near the floor, and has had one since its transition began."""
    stands = recording.low < NEAR
    for tick in range(1, len(stands)):
        stands[tick] &= stands[tick - 1] | (recording.left[tick] <= 0)
    return stands
