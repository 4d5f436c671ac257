"""Searches of edges between key frames, in buckets, so that a random seek costs no more than playing."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats


class EdgeSearch:
    """The searches of a role while its tables are built; one row for each list of times."""

    def __init__(self) -> None:
        self.rows: list[list[int]] = []
        """first edge, number of edges, first bucket, number of buckets, first group, end of the groups"""
        self.scales: list[float] = []
        self.edges: list[Floats] = []
        self.paces: list[Floats] = []
        self.buckets: list[NDArray[np.int32]] = []
        self._ends = [0, 0]

    def add(self, times: Floats, groups: tuple[int, int] = (0, 0)) -> int:
        """Adds rising times (U,); returns their row."""
        edges = times.astype(np.float64)
        span = float(edges[-1] - edges[0])
        count = len(edges) if span > 0 else 1
        scale = count / span if span > 0 else 0.0
        scale = scale if np.isfinite(scale) else 0.0
        of_edge = np.minimum((edges - edges[0]) * scale, count - 1).astype(np.int64)
        before = np.append(of_edge.searchsorted(np.arange(count), "left"), len(edges)).astype(np.int32)
        self.rows.append([self._ends[0], len(edges), self._ends[1], count, *groups])
        self.scales.append(scale)
        self.edges.append(edges)
        self.paces.append(np.append(1 / np.diff(edges), 0.0))
        self.buckets.append(before)
        self._ends = [self._ends[0] + len(edges), self._ends[1] + len(before)]
        return len(self.rows) - 1
