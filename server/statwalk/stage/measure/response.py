"""The response of a cell: the seconds from the event to the first visible motion, to half way, to arrival."""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.stage.measure.trials import RATE, Recording

VISIBLE = 0.001
"""metres that a joint is elsewhere than without the event"""
ARRIVED = 0.005, 0.05
"""a transition has arrived where no joint is farther from the new motion than 5 mm, or than a twentieth of
the way
"""


def visible(recording: Recording, twins: Ints) -> Floats:
    """Returns (N,) seconds from the event until a joint is visibly elsewhere than in the trial `twins` (N,)
    without the event; infinite: never.
    """
    joints = recording.joints
    apart = np.linalg.norm(joints - joints[:, twins], axis=-1).max(-1) > VISIBLE
    return _seconds(recording, apart)


def arrivals(recording: Recording, changed: Ints) -> tuple[Floats, Floats]:
    """Returns (N,) seconds from the event until the pose is half way to the new motion, and until it has
    arrived; `changed` (N,): the tick in which the state changed.
    """
    away = np.linalg.norm(recording.world[..., 3] - recording.target, axis=-1).max(-1)
    whole = np.take_along_axis(away, changed[None], 0)
    after = np.arange(len(away))[:, None] >= changed
    half = after & (away <= np.maximum(whole / 2, ARRIVED[0]))
    arrived = after & (away <= np.maximum(whole * ARRIVED[1], ARRIVED[0]))
    return _seconds(recording, half), _seconds(recording, arrived)


def _seconds(recording: Recording, happens: Floats) -> Floats:
    """(N,) seconds from the event to the first tick after it in which something happens (T, N)."""
    counts = happens.astype(bool) & (np.arange(len(happens))[:, None] > recording.sent)
    ticks = counts.argmax(0) - recording.sent
    return np.where(counts.any(0), ticks / RATE, np.inf)
