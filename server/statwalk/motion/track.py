"""The run form of a clip: channels of one kind packed together, so that one search and one gather serve them all."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.motion.bundle import Bundle, spans
from statwalk.motion.segments import Evaluate, hold, pack
from statwalk.motion.timing import timing_of

LARGEST_TABLE = 1 << 18  # cells of a track's table (edges x channels): beyond it the channels are spread over several tracks


@dataclass(frozen=True, eq=False)
class Track:
    """C channels with the same property, evaluated alike. Their key times may differ: `edges` are the times of all.

    Row 0 of the tables counts before the first edge, row u + 1 from edge u on.
    """

    path: str
    evaluate: Evaluate
    target: Ints
    """(C,) joints, or columns of the weights"""
    edges: Floats
    """(U,) float64 seconds, rising"""
    segment: Ints
    """(U + 1, C) row of `rows` that holds between two edges"""
    start: Floats
    """(U + 1, C) float64 seconds at which that segment starts"""
    rate: Floats
    """(U + 1, C) float64 1/s, one over its length; 0 before the first key and after the last"""
    rows: Floats
    """(S, m) float32, see `segments`"""

    def values(self, times: Floats) -> Floats:
        """(N, C, n) float32 at `times` (N,) float64 seconds."""
        row = self.edges.searchsorted(times, "right")
        fractions = (times[:, None] - self.start[row]) * self.rate[row]
        return self.evaluate(self.rows[self.segment[row]], fractions.astype(np.float32))


def tracks_of(bundles: Iterable[Bundle], loop: bool) -> tuple[Track, ...]:
    """The tracks of all channels that change at all."""
    packed = [Packed(bundle, loop) for bundle in bundles]
    return tuple(track for one in packed for track in one.tracks(0, len(one.bundle.target)))


class Packed:
    """A bundle ready to be cut into tracks: the rows of all channels that change, made at once."""

    def __init__(self, bundle: Bundle, loop: bool) -> None:
        self.bundle = bundle
        moving = ~bundle.is_constant
        self.moving = bundle if moving.all() else bundle.taken(np.flatnonzero(moving))
        self.before = np.append(0, moving.cumsum())
        """(C + 1,) how many of the channels before it change"""
        self.evaluate, self.rows = pack(self.moving, loop) if moving.any() else (hold, bundle.keys[:0])

    def tracks(self, first: int, last: int) -> list[Track]:
        """The tracks of those of the channels first…last that change: one, or more where its table would be too large."""
        start, end = int(self.before[first]), int(self.before[last])
        timing = self.moving.timing[start:end]
        if start == end:
            return []
        if (timing == timing[0]).all():
            return [self.track_in_step(start, end)]
        if sum(len(self.moving.times[row]) for row in np.unique(timing)) * len(timing) <= LARGEST_TABLE:
            return [self.track(np.arange(start, end))]
        return [self.track(rows) for rows in self.batches(start, end)]

    def track_in_step(self, start: int, end: int) -> Track:
        """The track of the channels start…end, all of which have the same times."""
        row, times = int(self.moving.timing[start]), self.moving.times
        rows = self.rows[self.moving.starts[start] : self.moving.ends[end - 1]]
        target, edges = self.moving.target[start:end], times.timing(row).edges
        return Track(self.bundle.path, self.evaluate, target, edges, *times.in_step(row, end - start), rows)

    def batches(self, start: int, end: int) -> Iterator[Ints]:
        """The channels start…end, those with the same times together, in batches whose table is not too large."""
        order = np.argsort(self.moving.timing[start:end], kind="stable") + start
        fresh = np.diff(self.moving.timing[order], prepend=-1) != 0
        batch, edges = 0, 0
        for row, (count, is_new) in enumerate(zip(self.moving.counts[order].tolist(), fresh.tolist(), strict=True)):
            edges += count if is_new else 0
            if row > batch and edges * (row - batch + 1) > LARGEST_TABLE:
                yield order[batch:row]
                batch, edges = row, count
        yield order[batch:]

    def track(self, channels: Ints) -> Track:
        """The track of some channels (C,) with different times."""
        used, which = np.unique(self.moving.timing[channels], return_inverse=True)
        times = [self.moving.times[row].astype(np.float64) for row in used]
        edges = np.unique(np.concatenate(times))
        parts = [timing_of(own, edges) for own in times]
        key = np.stack([part.key for part in parts], -1).take(which, -1)
        start, rate = (np.stack(columns, -1).take(which, -1) for columns in zip(*((part.start, part.rate) for part in parts), strict=True))
        first, counts = self.moving.starts[channels], self.moving.counts[channels]
        rows = self.rows[spans(first, counts)]
        before: Ints = np.cumsum(counts) - counts
        segment = np.asarray(key + before, np.int64)
        return Track(self.bundle.path, self.evaluate, self.moving.target[channels], edges, segment, start, rate, rows)
