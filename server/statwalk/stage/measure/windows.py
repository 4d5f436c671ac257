"""The ticks of a recording that belong to a transition."""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Bools, Ints
from statwalk.stage.measure.trials import NEVER, Recording

NOT_TAKEN = -1


def change_ticks(recording: Recording, layer: int, column: int) -> Ints:
    """Returns (N,) the tick in which the cell of an event changed the state of a layer; NOT_TAKEN where the
    first change after the event has another cause, or the state was left before the event.
    """
    ticks = np.arange(len(recording.event))[:, None]
    has_changed = recording.event[:, :, layer] != NEVER
    is_end = column == recording.role.machine.end
    too_early = (has_changed & (ticks <= recording.sent)).any(0) & (not is_end)
    counts = has_changed & ((ticks > recording.sent) | is_end)
    first = counts.argmax(0)
    cause = recording.event[first, np.arange(len(first)), layer]
    return np.where(counts.any(0) & ~too_early & (cause == column), first, NOT_TAKEN)


def end_of_blend(recording: Recording, changed: Ints) -> Ints:
    """Returns (N,) the first tick from `changed` (N,) on in which nothing is left of the transition; the last
    tick where there is none.
    """
    ticks = np.arange(len(recording.left))[:, None]
    ended = (recording.left <= 0) & (ticks >= changed)
    return np.where(ended.any(0), ended.argmax(0), len(recording.left) - 1)


def span(recording: Recording, first: Ints, last: Ints) -> Bools:
    """Returns (T, N) the ticks from `first` (N,) to `last` (N,)."""
    ticks = np.arange(len(recording.left))[:, None]
    return (ticks >= first) & (ticks <= last)
