"""How well a server keeps time, and what it holds: from a viewer, /metrics and /proc (Linux)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from viewer_figures import resident_bytes

BUCKET = 'statwalk_tick_late_seconds_bucket{le="'


class Pace(NamedTuple):
    """`hz`: ticks a second, from the frame of the first quarter that came least late to that of the last one;
    `drift`: seconds by which the last frame came later than the first frame and its tick say, negative if it
    came earlier.
    """

    hz: float
    drift: float


def pace(times: Sequence[float], ticks: Sequence[int], rate: float = 60.0, left_out: int = 0) -> Pace:
    """The pace of a stage, from when (s) which tick came to a viewer. `left_out`: how many ticks the server
    says that it left out meanwhile, since the computer was busy; they count.
    """
    at, tick = np.asarray(times), np.asarray(ticks)
    late = at - at[0] - (tick - tick[0]) / rate
    quarter = max(1, len(late) // 4)
    first, last = int(late[:quarter].argmin()), len(late) - quarter + int(late[-quarter:].argmin())
    hz = (tick[last] - tick[first] + left_out) / (at[last] - at[first])
    return Pace(float(hz), float(late[-1]))


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


def ticks_left_out(metrics: str) -> int:
    """How many ticks a server has left out, from the text of /metrics."""
    (number,) = re.findall(r"^statwalk_ticks_left_out_total (\S+)$", metrics, re.MULTILINE)
    return int(float(number))


def late_counts(metrics: str) -> dict[float, float]:
    """By bound (s), the ticks that were at most so late, from the text of /metrics."""
    lines = [line.removeprefix(BUCKET) for line in metrics.splitlines() if line.startswith(BUCKET)]
    return {float(bound): float(count) for bound, count in (line.split('"} ') for line in lines)}


def late_within(before: dict[float, float], after: dict[float, float], part: float) -> float:
    """The bound (s) within which `part` of the ticks between two looks at /metrics were late."""
    counts = {bound: after[bound] - before.get(bound, 0) for bound in after}
    return min(bound for bound, count in counts.items() if count >= part * max(counts.values()))
