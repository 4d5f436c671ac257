"""The run form of a clip: channels of one kind packed together, so that one search and one gather serve them all."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby

import numpy as np

from statwalk.maths.arrays import Floats, Ints
from statwalk.motion.channel import Channel
from statwalk.motion.segments import Evaluate, pack, pack_straight

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


def tracks_of(channels: Sequence[Channel], loop: bool) -> tuple[Track, ...]:
    """The tracks of all channels that change at all."""
    columns = [column for channel in channels if not channel.is_constant for column in _split_weights(channel)]
    columns.sort(key=_kind)
    return tuple(
        _track(batch, loop)
        for _, alike in groupby(columns, key=_kind)
        for batch in _batches(sorted(alike, key=lambda c: c.times.tobytes()))
    )


def _kind(channel: Channel) -> tuple[str, str]:
    return channel.path, channel.interpolation


def _split_weights(channel: Channel) -> list[Channel]:
    """A channel of weights as one channel for each weight, so that all of them can lie in one track."""
    if channel.path != "weights":
        return [channel]
    count = channel.values.shape[-1]
    return [
        Channel(channel.joint, "weights", channel.times, channel.values[..., i : i + 1], channel.interpolation, channel.weight_first + i)
        for i in range(count)
    ]


def _batches(channels: list[Channel]) -> Iterator[list[Channel]]:
    """The channels, those with the same times together, in batches whose table is not too large."""
    batch: list[Channel] = []
    edges, seen = 0, b""
    for channel in channels:
        times = channel.times.tobytes()
        edges += len(channel.times) if times != seen else 0
        if batch and edges * (len(batch) + 1) > LARGEST_TABLE:
            yield batch
            batch, edges = [], len(channel.times)
        batch.append(channel)
        seen = times
    yield batch


def _track(channels: list[Channel], loop: bool) -> Track:
    edges = np.unique(np.concatenate([channel.times for channel in channels])).astype(np.float64)
    evaluate, rows = _packed(channels, loop)
    first = np.cumsum([0, *(len(channel.times) for channel in channels[:-1])])
    # Channels with the same times lie side by side (see _batches): their columns are computed once.
    runs = [list(alike) for _, alike in groupby(channels, key=lambda channel: channel.times.tobytes())]
    timing = [_timing(alike[0].times.astype(np.float64), edges) for alike in runs]
    counts = [len(alike) for alike in runs]
    index, start, rate = (np.stack(parts, -1).repeat(counts, -1) for parts in zip(*timing, strict=True))
    target = [channel.weight_first if channel.path == "weights" else channel.joint for channel in channels]
    return Track(channels[0].path, evaluate, np.array(target), edges, index + first, start, rate, rows)


def _packed(channels: list[Channel], loop: bool) -> tuple[Evaluate, Floats]:
    """How the channels' segments are evaluated, and the rows (S, m) of all of them, one channel after the other."""
    if channels[0].interpolation in ("STEP", "LINEAR"):
        return pack_straight(channels)
    packed = [pack(channel, loop and _goes_on(channel)) for channel in channels]
    return packed[0][0], np.concatenate([rows for _, rows in packed])


def _goes_on(channel: Channel) -> bool:
    """Whether the next lap goes on where this one ends: the ends meet, or it is a way whose next lap starts there (root motion)."""
    return channel.path == "translation" or bool((channel.keys[0] == channel.keys[-1]).all())


def _timing(times: Floats, edges: Floats) -> tuple[Ints, Floats, Floats]:
    """For each row of the table: which key holds, since when (seconds), and one over the seconds to the next key."""
    key = np.concatenate([[-1], times.searchsorted(edges, "right") - 1])
    rate = np.append(1 / np.diff(times), 0.0)
    return key.clip(0), times[key.clip(0)], np.where(key < 0, 0.0, rate[key])
