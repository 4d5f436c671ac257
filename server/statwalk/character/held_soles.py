"""Keeps a sole where it stands while a body moves as another body did, whose feet were longer or shorter."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from statwalk.character.body import Body
from statwalk.character.carried_soles import Sole
from statwalk.maths.arrays import Bools, Floats, Ints

ACROSS = np.array([1.0, 0.0, 1.0])


def held(body: Body, sole: Sole, turns: Mapping[str, Floats], ankle: Floats, stands: Bools) -> Floats:
    """Returns where the ankle (F, 3) goes so that the lowest points of its sole do not slide while it stands;
    `turns`: those (F, 4) of foot and toes.

    A foot that stands is on average where it was. In the air it goes over from one shift to the next.
    """
    at = np.flatnonzero(stands)
    if len(at) < 2:
        return ankle
    slid = (np.diff(ankle, axis=0) + sole.rolled(body, turns)) * ACROSS
    shift = -np.concatenate([np.zeros((1, 3)), slid.cumsum(0)])
    for contact in np.split(at, np.flatnonzero(np.diff(at) > 1) + 1):
        shift[contact] -= shift[contact].mean(0)
    return ankle + _bridged(shift, at)


def _bridged(shift: Floats, at: Ints) -> Floats:
    """The shifts (F, 3) at the frames `at`; between them they go over smoothly."""
    frames = np.arange(len(shift))
    place = np.clip(np.searchsorted(at, frames, "right") - 1, 0, len(at) - 1)
    before, after = at[place], at[np.minimum(place + 1, len(at) - 1)]
    part = np.clip((frames - before) / np.maximum(after - before, 1), 0, 1)[:, None]
    bridged: Floats = shift[before] + (shift[after] - shift[before]) * part * part * (3 - 2 * part)
    return bridged
