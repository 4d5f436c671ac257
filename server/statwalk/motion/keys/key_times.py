"""The distinct key times of many channels, and the tables that map a time to its key."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Floats, Ints


class Timing(NamedTuple):
    """For each row of a track's table, before the first of its `edges` and from each edge on: the key that
    holds, its time (seconds), and one over the seconds to the next key.
    """

    key: Ints
    start: Floats
    rate: Floats
    edges: Floats


def timing_of(times: Floats, edges: Floats) -> Timing:
    """Returns the timing of keys at `times` (K,) float64 seconds, in a table with edges (U,)."""
    key = np.concatenate([BEFORE, times.searchsorted(edges, "right") - 1])
    held = np.maximum(key, 0)
    rate = np.concatenate([1 / (times[1:] - times[:-1]), STILL])
    return Timing(held, times[held], np.where(key < 0, 0.0, rate[held]), edges)


BEFORE, STILL = np.array([-1]), np.zeros(1)


class KeyTimes:
    """The distinct key times of some channels, each (K,) seconds and rising; derived tables are cached."""

    def __init__(self, times: Sequence[Floats]) -> None:
        self.times = times
        self.timings: dict[int, Timing] = {}
        self.tables: dict[tuple[int, int], tuple[Ints, Floats, Floats]] = {}

    def __getitem__(self, row: int) -> Floats:
        return self.times[row]

    @cached_property
    def counts(self) -> Ints:
        """Returns the number of keys of each list of key times."""
        return np.array([len(times) for times in self.times])

    def timing(self, row: int) -> Timing:
        """Returns the timing of channels that all have the key times of `row`."""
        if row not in self.timings:
            times = self.times[row].astype(np.float64)
            self.timings[row] = timing_of(times, times)
        return self.timings[row]

    def in_step(self, row: int, count: int) -> tuple[Ints, Floats, Floats]:
        """Returns the tables (U + 1, C) of a track (see `Track`) for `count` channels, one after the other,
        that all have the key times of `row`.
        """
        if (row, count) not in self.tables:
            timing = self.timing(row)
            segment = timing.key[:, None] + len(timing.edges) * np.arange(count)
            start, rate = (part[:, None].repeat(count, 1) for part in (timing.start, timing.rate))
            self.tables[row, count] = segment, start, rate
        return self.tables[row, count]
