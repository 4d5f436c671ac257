"""What the records of many viewers say: how evenly frames came, which were stale, and whether all saw the
same facts.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np
from load_process import Seen

OLD_SECONDS = 0.1
"""a frame is stale if another viewer had a newer one so long before"""


class Intervals(NamedTuple):
    """Milliseconds between two frames of the same viewer."""

    frames: int
    p50: float
    p99: float
    longest: float

    def __str__(self) -> str:
        return (
            f"{self.frames:8,} frames  p50 {self.p50:5.1f}  p99 {self.p99:5.1f}  max {self.longest:6.1f} ms"
        )


def intervals(seen: Iterable[Seen]) -> Intervals:
    """The intervals of all connections together."""
    each = [np.diff(np.asarray(one.times)) for one in seen if len(one.times) > 1]
    all_of_them = 1000 * np.concatenate(each or [np.zeros(1)])
    p50, p99 = np.percentile(all_of_them, (50, 99))
    return Intervals(len(all_of_them), float(p50), float(p99), float(all_of_them.max()))


def goes_back(seen: Iterable[Seen]) -> int:
    """How many frames came after a newer one on the same connection."""
    return sum(after <= before for one in seen for before, after in pairwise(one.ticks))


def stale(woken: Iterable[Seen], others: Sequence[Seen], since: float) -> list[tuple[float, int]]:
    """The frames that came after `since` although the others had newer ones: seconds after `since`, and by
    how many ticks they were too old.
    """
    times = np.concatenate([np.asarray(one.times) for one in others])
    ticks = np.concatenate([np.asarray(one.ticks) for one in others])
    order = np.argsort(times)
    times, newest = times[order], np.maximum.accumulate(ticks[order])
    found = []
    for one in woken:
        for time, tick in zip(one.times, one.ticks, strict=True):
            place = int(np.searchsorted(times, time - OLD_SECONDS)) - 1
            if time > since and place >= 0 and tick < newest[place]:
                found.append((time - since, int(newest[place]) - tick))
    return found


def resident_bytes(process: int) -> int:
    """The resident memory of a process (Linux)."""
    for line in Path(f"/proc/{process}/status").read_text().splitlines():
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) << 10
    raise ValueError("the process has ended")
