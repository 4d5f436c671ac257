"""The packed form of a clip: channels of one kind together, so that one search and one gather serve all of
them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.motion.keys.key_set import KeySet, spans
from statwalk.motion.keys.key_times import timing_of
from statwalk.motion.keys.segment_kinds import HOLD
from statwalk.motion.keys.segments import pack

LARGEST_TABLE = (
    1 << 18
)  # cells of a track's table (edges x channels): larger tables are split over several tracks


@dataclass(frozen=True, eq=False)
class Track:
    """C channels with the same property and kind of segment.

    Their key times may differ: `edges` are the times of all of them.

    Row 0 of the tables counts before the first edge, row u + 1 from edge u on.
    """

    path: str
    kind: int
    """see `segment_kinds`"""
    target: Ints
    """(C,) joints, or columns of the weights"""
    edges: Floats
    """(U,) float64 seconds, rising"""
    segment: Ints
    """(U + 1, C) row of `rows` that holds between two edges"""
    start: Floats
    """(U + 1, C) float64 seconds at which the segment starts"""
    rate: Floats
    """(U + 1, C) float64 1/s, one over the segment's length; 0 before the first key and after the last"""
    rows: Floats
    """(S, m) float32, see `segments`"""


def tracks_of(key_sets: Iterable[KeySet], loop: bool) -> tuple[Track, ...]:
    """Returns the tracks of all channels that change."""
    packed = [PackedKeys(key_set, loop) for key_set in key_sets]
    return tuple(track for keys in packed for track in keys.tracks(0, len(keys.key_set.target)))


class PackedKeys:
    """A key set ready to be cut into tracks: the rows of all channels that change, made in one pass."""

    def __init__(self, key_set: KeySet, loop: bool) -> None:
        self.key_set = key_set
        moving = ~key_set.is_constant
        self.moving = key_set if moving.all() else key_set.taken(np.flatnonzero(moving))
        self.before = np.append(0, moving.cumsum())
        """(C + 1,) for each channel, the number of earlier channels that change"""
        self.kind, self.rows = pack(self.moving, loop) if moving.any() else (HOLD, key_set.keys[:0])

    def tracks(self, first: int, last: int) -> list[Track]:
        """Returns the tracks of the channels among first…last that change: one, or several if its table were
        too large.
        """
        start, end = int(self.before[first]), int(self.before[last])
        timing = self.moving.timing[start:end]
        if start == end:
            return []
        if (timing == timing[0]).all():
            return [self._track_in_step(start, end)]
        if sum(len(self.moving.times[row]) for row in np.unique(timing)) * len(timing) <= LARGEST_TABLE:
            return [self.track(np.arange(start, end))]
        return [self.track(rows) for rows in self.batches(start, end)]

    def _track_in_step(self, start: int, end: int) -> Track:
        """The track of the channels start…end if all have the same times."""
        row, times = int(self.moving.timing[start]), self.moving.times
        rows = self.rows[self.moving.starts[start] : self.moving.ends[end - 1]]
        target, edges = self.moving.target[start:end], times.timing(row).edges
        return Track(self.key_set.path, self.kind, target, edges, *times.in_step(row, end - start), rows)

    def batches(self, start: int, end: int) -> Iterator[Ints]:
        """Yields the channels start…end, grouped by times, in batches whose tables are not too large."""
        order = np.argsort(self.moving.timing[start:end], kind="stable") + start
        is_new_time = np.diff(self.moving.timing[order], prepend=-1) != 0
        batch, edges = 0, 0
        for row, (count, is_new) in enumerate(
            zip(self.moving.counts[order].tolist(), is_new_time.tolist(), strict=True)
        ):
            edges += count if is_new else 0
            if row > batch and edges * (row - batch + 1) > LARGEST_TABLE:
                yield order[batch:row]
                batch, edges = row, count
        yield order[batch:]

    def track(self, channels: Ints) -> Track:
        """Returns the track of some channels (C,) with different times."""
        used, which = np.unique(self.moving.timing[channels], return_inverse=True)
        times = [self.moving.times[row].astype(np.float64) for row in used]
        edges = np.unique(np.concatenate(times))
        parts = [timing_of(own, edges) for own in times]
        key = np.stack([part.key for part in parts], -1).take(which, -1)
        start, rate = (
            np.stack(columns, -1).take(which, -1)
            for columns in zip(*((part.start, part.rate) for part in parts), strict=True)
        )
        first, counts = self.moving.starts[channels], self.moving.counts[channels]
        rows = self.rows[spans(first, counts)]
        before: Ints = np.cumsum(counts) - counts
        segment = np.asarray(key + before, np.int64)
        return Track(
            self.key_set.path, self.kind, self.moving.target[channels], edges, segment, start, rate, rows
        )
