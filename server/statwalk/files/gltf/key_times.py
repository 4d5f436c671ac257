"""Reads key times; an accessor is checked once, however many channels use it (glTF 2.0, 3.11)."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.accessors import Accessors
from statwalk.files.gltf.allowance import Allowance, key_times
from statwalk.files.gltf.formats import TIMES


@dataclass
class SamplerTimes:
    """The times (K,) of a sampler, and the indices (K,) of its keys at these times; None for all keys."""

    times: NDArray[np.float32]
    keys: NDArray[np.int64] | None


@dataclass
class TimeTable:
    """The key times of a document, by accessor."""

    accessors: Accessors
    checked: dict[int, SamplerTimes] = field(default_factory=dict)
    allowed: Allowance = field(default_factory=key_times)

    def read(self, row: int, place: str) -> SamplerTimes:
        """Returns the times of an accessor; of several keys at the same time only the last one is used.

        `place` is the JSON pointer of the reference.

        :raises ModelError: when times are negative, too large, or fall.
        """
        if row not in self.checked:
            count = self.accessors.entries[row].get("count")
            self.allowed.take(count if type(count) is int else 0, f"/accessors/{row}/count")
            times = self.accessors.floats(row, TIMES, place)
            steps = times[1:] - times[:-1]
            if times[0] < 0 or times[-1] > check.LATEST or (len(steps) and steps.min() < 0):
                raise ModelError(
                    f"key times must rise from 0 or more to at most {check.LATEST:g} seconds",
                    place=f"/accessors/{row}",
                )
            self.checked[row] = self.rising(times, steps)
        return self.checked[row]

    def rising(self, times: NDArray[np.float32], steps: NDArray[np.float32]) -> SamplerTimes:
        """Returns the times without repeated ones."""
        if not len(steps) or steps.min() > 0:
            return SamplerTimes(times, None)
        self.accessors.document.note("several keys at the same time: the last one is used")
        keys = np.flatnonzero(np.append(steps > 0, True))
        return SamplerTimes(times[keys], keys)
