"""How well a server keeps time, and what it holds: from a viewer, /metrics and /proc (Linux)."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from viewer_figures import resident_bytes

BUCKET = 'statwalk_tick_late_seconds_bucket{le="'


class Pace(NamedTuple):
    """`hz`: ticks a second, by a line through all frames; `drift`: seconds by which the last frame came later
    than the first frame and its tick say, negative if it came earlier.
    """

    hz: float
    drift: float


def pace(times: Sequence[float], ticks: Sequence[int], rate: float = 60.0) -> Pace:
    """The pace of a stage, from when (s) which tick came to a viewer."""
    at, tick = np.asarray(times), np.asarray(ticks)
    slope = np.polyfit(at - at[0], tick - tick[0], 1)[0]
    return Pace(float(slope), float(at[-1] - at[0] - (tick[-1] - tick[0]) / rate))


class Held(NamedTuple):
    """What a process holds."""

    resident: int
    """bytes"""
    files: int
    threads: int


def held(process: int) -> Held:
    """What a process holds now."""
    folder = Path(f"/proc/{process}")
    return Held(
        resident_bytes(process), len(list((folder / "fd").iterdir())), len(list((folder / "task").iterdir()))
    )


def late_counts(metrics: str) -> dict[float, float]:
    """By bound (s), the ticks that were at most so late, from the text of /metrics."""
    lines = [line.removeprefix(BUCKET) for line in metrics.splitlines() if line.startswith(BUCKET)]
    return {float(bound): float(count) for bound, count in (line.split('"} ') for line in lines)}


def late_within(before: dict[float, float], after: dict[float, float], part: float) -> float:
    """The bound (s) within which `part` of the ticks between two looks at /metrics were late."""
    counts = {bound: after[bound] - before.get(bound, 0) for bound in after}
    return min(bound for bound, count in counts.items() if count >= part * max(counts.values()))
