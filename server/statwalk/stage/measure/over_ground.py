"""A state's motion by itself over uneven ground: what transitions there are measured against."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

import numpy as np

from statwalk.character.role import Role
from statwalk.machine.model_checker.work import Checkpoint, go_on
from statwalk.maths.arrays import Floats, Ints
from statwalk.stage.measure.jump import changes_of
from statwalk.stage.measure.measured_ground import Spot
from statwalk.stage.measure.trials import NEVER, RATE, WARM_UP, CellTrial, record

PHASES = (0.0, 0.25, 0.5, 0.75)
LAPS, LONGEST = 2, 3.0
"""laps of a motion that loops; seconds for which a motion is looked at"""


def most_over(
    role: Role, state: int, joints: Ints, places: Sequence[Spot], checkpoint: Checkpoint = go_on
) -> Floats:
    """Returns (2, J) the largest changes within a state's motion over uneven ground, begun at `places`, until
    it ends.
    """
    machine = role.machine
    duration = float(machine.duration[state]) if np.isfinite(machine.duration[state]) else 1.0
    laps, phases = (LAPS, PHASES) if machine.loop[state] else (1, PHASES[:1])
    ticks = round(min(laps * duration, LONGEST) * RATE) + WARM_UP + 3
    trials = [CellTrial(state, phase, place=place) for phase, place in product(phases, places)]
    recording = record(role, trials, ticks, checkpoint)
    most = np.zeros((2, len(joints)))
    for number in range(len(trials)):
        ended = (recording.event[:, number] != NEVER).any(-1)
        past = int(ended.argmax()) if ended.any() else ticks
        track = recording.joints[1:past, number][:, joints]  # the pose at 0 was put there, not shown
        most = np.maximum(most, changes_of(track)) if len(track) > 2 else most
    return most
