"""Key times, checked once however many channels have them (glTF 2.0, 3.11)."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.glb import check
from statwalk.files.glb.accessors import Accessors
from statwalk.files.glb.allowance import Allowance, key_times
from statwalk.files.glb.formats import TIMES


@dataclass
class KeyTimes:
    """Times (K,) of a sampler, and which of its keys they are: None for all."""

    times: NDArray[np.float32]
    keys: NDArray[np.int64] | None


@dataclass
class TimeTable:
    """The key times of a document, by accessor."""

    accessors: Accessors
    known: dict[int, KeyTimes] = field(default_factory=dict)
    allowed: Allowance = field(default_factory=key_times)

    def read(self, row: int, place: str) -> KeyTimes:
        """The times of an accessor: finite, not negative, rising. Of keys at the same time the last one stays; `place` is who asks."""
        if row not in self.known:
            count = self.accessors.entries[row].get("count")
            self.allowed.take(count if type(count) is int else 0, f"/accessors/{row}/count")
            times = self.accessors.floats(row, TIMES, place)
            steps = times[1:] - times[:-1]
            if times[0] < 0 or times[-1] > check.LATEST or (len(steps) and steps.min() < 0):
                raise ModelError(f"key times must rise from 0 or more to at most {check.LATEST:g} seconds", place=f"/accessors/{row}")
            self.known[row] = self.rising(times, steps)
        return self.known[row]

    def rising(self, times: NDArray[np.float32], steps: NDArray[np.float32]) -> KeyTimes:
        """Times that never fall, without those that the next one repeats."""
        if not len(steps) or steps.min() > 0:
            return KeyTimes(times, None)
        self.accessors.document.note("keys at equal times: the last one counts")
        keys = np.flatnonzero(np.append(steps > 0, True))
        return KeyTimes(times[keys], keys)
