"""The jump of a transition (SM4): how much more position and velocity change from tick to tick than within
the motions themselves.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from statwalk.character.role import Role
from statwalk.maths.arrays import Floats, Ints
from statwalk.stage.measure.alone import entries_of, motion_alone
from statwalk.stage.measure.trials import RATE

STILL = 1e-4
"""metres: a joint that stands still in all motions counts as if it moved so far in a tick"""
OFFSETS = np.linspace(0, 1 / RATE, 4, endpoint=False)
"""seconds into the first tick: a motion is looked at from several moments between its ticks"""


class Jump(NamedTuple):
    """A jump; 1: as much as within the motions."""

    body: float
    """the joint that changes most, relative to the joint that changes most in the motions"""
    joint: float
    """the joint that changes most relative to itself in the motions"""
    name: str
    """that joint"""
    what: str
    """`position` or `velocity`: what of it changed"""


def joints_shown(role: Role) -> Ints:
    """Returns the joints that move something: not the nodes that only carry a skinned mesh."""
    character = role.character
    bones = {int(joint) for skin in character.skins for joint in skin.joints}
    carriers = {part.joint for part in character.parts if part.skin is not None}
    parents = set(character.skeleton.parent.tolist())
    every = range(len(character.skeleton))
    return np.array([row for row in every if row in bones or row in parents or row not in carriers])


def changes_of(track: Floats) -> Floats:
    """Returns (2, …, J) the largest change of position and of velocity from tick to tick in tracks
    (T, …, J, 3).
    """
    return np.array([np.linalg.norm(np.diff(track, order, axis=0), axis=-1).max(0) for order in (1, 2)])


def most_of(role: Role, state: int, joints: Ints) -> Floats:
    """Returns (2, J) the largest changes within a state's motion by itself, whatever its entry values."""
    moments = product(OFFSETS, entries_of(role, state))
    tracks = (motion_alone(role, state, offset, axes)[:, joints] for offset, axes in moments)
    changes = [changes_of(track) for track in tracks if len(track) > 2]
    most: Floats = np.max(changes or [np.zeros((2, len(joints)))], 0)
    return most


def jump_of(track: Floats, most: Sequence[Floats], names: Sequence[str]) -> Jump:
    """Returns the jump of a track (T, J, 3) of joints `names` through motions whose largest changes are
    `most` (each (2, J)).
    """
    changes, limits = changes_of(track), np.max(most, 0)
    body = (changes.max(1) / np.maximum(limits.max(1), STILL)).max()
    ratios = changes / (limits + STILL)
    what, joint = np.unravel_index(ratios.argmax(), ratios.shape)
    return Jump(float(body), float(ratios.max()), names[joint], ("position", "velocity")[what])
