"""Soles of the walker: where they are through a clip, and how far they are dragged over the ground."""

from itertools import pairwise

import numpy as np
from statwalk.character.character import Character
from statwalk.motion.clip import Clip

RATE = 120


def times_of(clip: Clip, rate: int = RATE) -> np.ndarray:
    return np.linspace(0.0, clip.duration, round(clip.duration * rate) + 1)


def part_of(character: Character) -> int:
    """Which part the soles are."""
    return next(
        i for i, part in enumerate(character.parts) if character.materials[part.material]["name"] == "soles"
    )


def sides_of(character: Character, points: np.ndarray) -> dict[str, np.ndarray]:
    """The vertices (F, V, 3) of both soles, one by one."""
    left = character.parts[part_of(character)].positions[:, 0] > 0
    return {"Left": points[:, left], "Right": points[:, ~left]}


def soles_of(character: Character, clip: Clip) -> dict[str, np.ndarray]:
    """World positions (F, V, 3) of the vertices of each sole through a clip."""
    which = part_of(character)
    return sides_of(
        character,
        np.array([character.vertices(clip.sample(float(t)))[which].positions for t in times_of(clip)], float),
    )


def slides(points: np.ndarray) -> list[float]:
    """For each time a foot is on the ground: how far (metres) the points that touch were dragged over it."""
    dragged, contacts = None, []
    for now, after in pairwise(points):
        lowest = now[:, 1].argmin()
        if max(now[lowest, 1], after[:, 1].min()) > 0.002:
            contacts += [] if dragged is None else [dragged]
            dragged = None
        else:
            dragged = (dragged or 0.0) + float(np.linalg.norm((after - now)[lowest, [0, 2]]))
    return contacts + ([] if dragged is None else [dragged])
