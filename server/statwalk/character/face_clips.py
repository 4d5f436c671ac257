"""Clips of contractions (DS9): the keys of muscles as keys of morph weights, which every viewer plays."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import numpy as np

from statwalk.character.character import Character
from statwalk.maths.arrays import Floats
from statwalk.motion.clip import Channel, Clip
from statwalk.skin.face_muscles import contracted, contractions_of

FINE = 1 / 30
"""seconds between the keys of a clip at most, if a muscle has a curved path: a viewer blends c² linearly"""


def face_clip(
    character: Character, name: str, keys: Mapping[float, Mapping[str, float]], *, loop: bool = False
) -> Clip:
    """Returns the clip that keys contractions, by seconds and by muscle; muscles that a key does not name
    are at rest there. Between keys contractions are linear.
    """
    times = np.array(list(keys))
    values = np.stack([_row(character, contractions) for contractions in keys.values()])
    fine = _fine(times)
    between = np.stack([np.interp(fine, times, column) for column in values.T], -1)
    weights = contracted(between, contractions_of(character.muscles, character.targets))
    spans = {
        (part.joint, part.weight_first, len(part.target_positions))
        for part in character.parts
        if part.target_positions is not None
    }
    channels = [
        Channel(
            joint, "weights", fine.astype(np.float32),
            weights[:, first : first + count].astype(np.float32), weight_first=first,
        )
        for joint, first, count in sorted(spans)
    ]  # fmt: skip
    return Clip(name, channels, float(times[-1]), character.bind_pose, loop=loop)


def _row(character: Character, contractions: Mapping[str, float]) -> Floats:
    """The weights (W,) of a key, without squares and cubes."""
    row: Floats = character.bind_pose.weights.astype(np.float64)
    for name in character.muscles:
        row[list(character.targets[name])] = contractions.get(name, 0.0)
    return row


def _fine(times: Floats) -> Floats:
    """The times, and times between them at most FINE apart."""
    parts = [
        np.linspace(start, end, max(1, int(np.ceil((end - start) / FINE))), endpoint=False)
        for start, end in pairwise(times)
    ]
    return np.concatenate([*parts, times[-1:]])
