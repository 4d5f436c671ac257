"""Finds the edge before a moment in an edge search of MotionTables."""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined


@inlined
def edges_before(motions: Any, search: int, time: float) -> Any:
    """Returns the number of edges of a search at or before `time` (seconds)."""
    first, buckets = motions.searches[search, 0], motions.searches[search, 2]
    if not time >= motions.edges[first]:
        return 0
    bucket = min((time - motions.edges[first]) * motions.scales[search], motions.searches[search, 3] - 1.0)
    low, high = motions.buckets[buckets + int(bucket)], motions.buckets[buckets + int(bucket) + 1]
    while low < high:
        middle = (low + high) // 2
        if motions.edges[first + middle] <= time:
            low = middle + 1
        else:
            high = middle
    return low
