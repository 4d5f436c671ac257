"""The rows of groups of sixteen lanes: for each edge of a clip all numbers until the next edge.

Lanes may have different key times. If they have the same, they are in step: the fraction of the segment that
has passed is the same in all lanes. Otherwise a row begins at an edge of any lane, with the fraction of each
lane's own segment that has passed there, and its rate: fraction = a + rate · (time − edge).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.simd.pose_layout import first_channels
from statwalk.motion.keys.channel import WIDTHS
from statwalk.motion.keys.packed_keys import Track
from statwalk.motion.keys.segment_kinds import ARC, DIVISOR, HOLD, VECTORS

_MOST_EDGES = 1 << 32


def _changes(track: Track) -> Bools:
    segment, rate = track.segment, track.rate
    return np.asarray((segment[1:] != segment[:-1]) | (rate[1:] != rate[:-1]))


class Owner(NamedTuple):
    """For each channel (C,) of a clip: its track (-1: constant), its column in the track, and the component
    of its values.
    """

    track: Ints
    column: Ints
    component: Ints
    keys: Ints
    """the number of segments less one"""
    signature: Ints
    """equal for channels that are sampled side by side; -1 for a channel without a track"""
    changes: tuple[Bools, ...]
    """for each track (U, C) whether a channel enters another segment at an edge"""

    @classmethod
    def of(cls, tracks: Sequence[Track], channels: int, joints: int) -> Owner:
        """Returns the owner of all channels of a clip with these tracks."""
        none, zero = np.full(channels, -1), np.zeros(channels, int)
        owner = cls(
            none, zero, zero.copy(), zero.copy(), none.copy(), tuple(_changes(track) for track in tracks)
        )
        for number, track in enumerate(tracks):
            width = WIDTHS.get(track.path, 1)
            first = first_channels(track.path, track.target, joints)
            ours = first[:, None] + np.arange(width)
            owner.track[ours], owner.column[ours], owner.component[ours] = (
                number,
                np.arange(len(first))[:, None],
                np.arange(width),
            )
            owner.keys[ours] = owner.changes[number].sum(0)[:, None]
            owner.signature[ours] = number * _MOST_EDGES + owner.keys[ours]
        return owner


class LaneRows(NamedTuple):
    """A clip's tracks, the owner of each channel (C,), the values of constant channels, and edges (U,)
    seconds.
    """

    tracks: Sequence[Track]
    owner: Owner
    base: Floats
    edges: Floats

    def _by_track(self, channels: Ints) -> Iterator[tuple[Track, Ints, Ints, Ints]]:
        """For each track that moves some of the channels (L,): the track, the lanes, the rows (U + 1, 1) of
        its table, its columns.
        """
        number = self.owner.track[channels]
        for row in np.unique(number[number >= 0]):
            track, ours = self.tracks[row], np.flatnonzero(number == row)
            rows = np.append(0, track.edges.searchsorted(self.edges, "right"))[:, None]
            yield track, ours, rows, self.owner.column[channels[ours]]

    def clocks(self, track: Track, rows: Ints, column: Ints) -> tuple[Floats, Floats]:
        """Returns the fraction at each edge, and its rate per second (U + 1, n)."""
        start, rate = track.start[rows, column], track.rate[rows, column]
        edges = np.append(self.edges[0], self.edges)[:, None]
        return (edges - start) * rate, rate


def scalar_rows(kind: int, channels: Ints, lanes: LaneRows) -> tuple[Floats, Floats]:
    """Returns clocks (U + 1, 2, L) and rows (U + 1, V, L), float64, of channels (L,) that are plain
    numbers.
    """
    rows = np.zeros((len(lanes.edges) + 1, VECTORS[kind], len(channels)))
    clocks = np.zeros((len(rows), 2, len(channels)))
    rows[:, 0] = lanes.base[channels]
    if kind in DIVISOR:
        rows[:, DIVISOR[kind]] = 1
    for track, ours, at, column in lanes._by_track(channels):
        own = track.kind
        segment, component = track.segment[at, column], lanes.owner.component[channels[ours]]
        width = track.rows.shape[1] // VECTORS[own]
        for part in range(VECTORS[own]):
            rows[:, part, ours] = track.rows[segment, component + part * width]
        if own != HOLD:
            clocks[:, 0, ours], clocks[:, 1, ours] = lanes.clocks(track, at, column)
    return clocks, rows


def rotation_rows(kind: int, channels: Ints, lanes: LaneRows) -> tuple[Floats, Floats]:
    """Returns clocks (U + 1, 2, L) and rows (U + 1, V, L), float64, of rotations with the first channels
    `channels` (L,).
    """
    turns = np.zeros((len(lanes.edges) + 1, len(channels), VECTORS[kind] - (kind == ARC)))
    clocks = np.zeros((len(turns), 2, len(channels)))
    turns[:, :, :4] = lanes.base[channels[:, None] + np.arange(4)]
    if kind == ARC:
        turns[:, :, 4:] = turns[:, :, :4]
    elif kind in DIVISOR:
        turns[:, :, DIVISOR[kind]] = 1
    for track, ours, at, column in lanes._by_track(channels):
        own, segments = track.kind, track.rows[track.segment[at, column]]
        if own == kind:
            turns[:, ours] = segments
            clocks[:, 0, ours], clocks[:, 1, ours] = lanes.clocks(track, at, column)
        elif own == HOLD:
            turns[:, ours, :4] = segments
            if kind == ARC:
                turns[:, ours, 4:] = segments
    return clocks, (_arcs(turns) if kind == ARC else turns).transpose(0, 2, 1)


def in_step(clocks: Floats, edges: Floats) -> Bools:
    """Returns (L,) whether a lane needs no clock (U + 1, 2, L) of its own: its segments end at the edges, or
    it never changes.
    """
    paces = np.concatenate([[0.0], 1 / np.diff(edges), [0.0]])[:, None]
    alike = (clocks[:, 1] == paces).all(0) | (clocks[:, 1] == 0).all(0)
    return np.asarray(alike & (clocks[:, 0] == 0).all(0))


def _arcs(turns: Floats) -> Floats:
    """(U + 1, L, 9) the square of the angle θ between two rotations, and both rotations times θ / sin θ, on
    one side.
    """
    first, second = turns[..., :4], quat.align(turns[..., :4], turns[..., 4:])
    angle_squared, stretch = quat.arc(np.minimum(quat.dot(first, second), 1.0))
    return np.concatenate(
        [angle_squared[..., None], first * stretch[..., None], second * stretch[..., None]], -1
    )
