"""How limbs move: knees that bend backwards, and the accelerations of hands."""

from __future__ import annotations

import numpy as np

from statwalk.character.body_bones import body_bones
from statwalk.character.character import Character
from statwalk.character.feet import Foot
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.rig.evaluate import world_from_local
from statwalk.stage.measure.trials import RATE, Recording

BENT = 0.02
"""a leg that at rest is bent by more than this share of its length shows itself which way its knee bends"""


def knees(recording: Recording, feet: tuple[Foot, ...], watched: Bools) -> Floats:
    """Returns (N,) metres: how far a knee is behind the line from hip to ankle, on the side to which it does
    not bend.
    """
    rest = world_from_local(recording.role.character.skeleton, recording.role.character.bind_pose)
    behind = np.zeros(recording.heading.shape[1])
    for foot in feet:
        if min(foot.leg) >= 0:
            offset = -_bend(foot, recording.world, _forward(foot, rest))
            behind = np.maximum(behind, np.where(watched, offset, 0).max(0))
    return behind


def _forward(foot: Foot, rest: Floats) -> Floats:
    """(3,) the direction in which the knee bends, in the space of the thigh."""
    hip, knee, ankle = (rest[joint, :, 3].astype(np.float64) for joint in foot.leg)
    line = (ankle - hip) / max(float(np.linalg.norm(ankle - hip)), 1e-9)
    off = knee - hip - ((knee - hip) @ line) * line
    ahead = (foot.skin.at(rest).mean(0) - ankle) * (1, 0, 1)
    if np.linalg.norm(off) > BENT * np.linalg.norm(ankle - hip):
        ahead = off
    elif np.linalg.norm(ahead) < 1e-6:
        ahead = np.array([0.0, 0, 1])
    turned: Floats = np.linalg.solve(rest[foot.hip, :, :3].astype(np.float64), ahead)
    return turned


def _bend(foot: Foot, world: Floats, forward: Floats) -> Floats:
    """(…,) metres by which the knee is in front of the line from hip to ankle."""
    hip, knee, ankle = (world[..., joint, :, 3].astype(np.float64) for joint in foot.leg)
    line = _unit(ankle - hip)
    ahead = world[..., foot.hip, :, :3].astype(np.float64) @ forward
    across = _unit(ahead - _dot(ahead, line)[..., None] * line)
    return _dot(knee - hip, across)


def _unit(vectors: Floats) -> Floats:
    units: Floats = vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-12)
    return units


def _dot(first: Floats, second: Floats) -> Floats:
    products: Floats = (first * second).sum(-1)
    return products


def hands_of(character: Character) -> Ints:
    """Returns the joints of the hands, by their names."""
    bones = body_bones(character.skeleton)
    return np.array([bones[name] for name in ("LeftHand", "RightHand") if name in bones], np.int64)


def hand_accelerations(recording: Recording, hands: Ints, watched: Bools) -> Floats:
    """Returns (N,) m/s²: the largest acceleration of a hand over three ticks that are watched."""
    if not len(hands) or len(watched) < 3:
        return np.zeros(recording.heading.shape[1])
    second = np.linalg.norm(np.diff(recording.joints[:, :, hands], 2, axis=0), axis=-1) * RATE**2
    counts = watched[2:] & watched[1:-1] & watched[:-2]
    fastest: Floats = np.where(counts[..., None], second, 0).max((0, 2))
    return fastest
