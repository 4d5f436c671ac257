"""Packs clips for sampling: the channels of all clips of a role in one order, cut into groups of sixteen
lanes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.simd.lanes import LANES
from statwalk.motion.keys.packed_keys import Track
from statwalk.motion.keys.segment_kinds import HOLD, IN_STEP, IS_TURN, LOOSE, OWN_CLOCKS, VECTORS
from statwalk.motion.tables.edge_search import EdgeSearch
from statwalk.motion.tables.lane_layout import LaneLayout, PackedClip
from statwalk.motion.tables.lane_rows import LaneRows, Owner, in_step, rotation_rows, scalar_rows

ROOM = 1 << 22
"""numbers (16 MiB) that the groups of a role may take up, whatever they hold"""
MOST_CELLS_A_KEY = 4
"""most cells for each key of its lanes that a further group may have"""


@dataclass(eq=False)
class PackedLanes:
    """The parts of MotionTables that describe clips."""

    base: NDArray[np.float32]
    clips: list[tuple[int, int, int]] = field(default_factory=lambda: [(0, 0, 0)])
    groups: list[tuple[int, int, int, int, int, int]] = field(default_factory=list)
    parts: list[NDArray[np.float32]] = field(default_factory=list)
    size: int = 0

    @property
    def values(self) -> NDArray[np.float32]:
        """Returns the rows of all groups, padded so that a vector can be loaded at their end."""
        return np.concatenate([*self.parts, np.zeros(LANES, np.float32)])

    def add(self, values: NDArray[np.float32]) -> int:
        """Adds numbers; returns the index of the first."""
        self.parts.append(values.ravel())
        self.size += values.size
        return self.size - values.size

    def mask(self, group: Group) -> int:
        """Adds the mask of the lanes that a group writes, if other groups write the rest; returns its index,
        or -1.
        """
        return self.add(group.lanes.astype(np.float32)) if group.is_masked else -1


class Group(NamedTuple):
    """Sixteen lanes of one clip of one kind: `channels` (16,), for rotations the first of four."""

    kind: int
    channels: Ints
    first: int
    """number in the packed row"""
    lanes: Bools
    """(16,) the lanes that the group writes"""
    is_masked: bool = False
    """whether other groups write the other lanes"""


def packed_clips(clips: Sequence[PackedClip], layout: LaneLayout, searches: EdgeSearch) -> PackedLanes:
    """Packs all clips; clip 0 is the rest pose, which has no group."""
    packed = PackedLanes(layout.base[:, layout.order])
    for row, clip in enumerate(clips):
        start = len(packed.groups)
        first = _add_clip(packed, clip.tracks, layout.owners[row], layout.base[row + 1], layout, searches)
        written = sum(
            LANES * (4 if IS_TURN[kind] else 1) for kind, *_, mask, _ in packed.groups[start:] if mask < 0
        )
        packed.clips.append((first, len(searches.rows), written == packed.base.shape[1]))
    return packed


def _add_clip(
    packed: PackedLanes,
    tracks: Sequence[Track],
    owner: Owner,
    base: Floats,
    layout: LaneLayout,
    searches: EdgeSearch,
) -> int:
    """Adds the groups of a clip and their searches; returns the first search."""
    by_edges: dict[bytes, tuple[Floats, list[Group]]] = {}
    loose = []
    for group in _groups(tracks, owner, layout):
        edges = _edges(tracks, owner, group.channels[group.lanes])
        if _is_wasteful(packed.size, group, edges, owner):
            loose.append(group)
        else:
            by_edges.setdefault(edges.tobytes(), (edges, []))[1].append(group)
    starts = [_add_lanes(packed, group, tracks, owner, base, searches) for group in loose]
    first = len(searches.rows)
    for edges, groups in by_edges.values():
        start = len(packed.groups)
        for kind in sorted({group.kind for group in groups}):
            _add_groups(
                packed,
                [group for group in groups if group.kind == kind],
                LaneRows(tracks, owner, base, edges),
            )
        searches.add(edges, (start, len(packed.groups)))
    if loose:
        start = len(packed.groups)
        packed.groups += [
            (group.kind, at, 0, group.first, packed.mask(group), LOOSE)
            for group, at in zip(loose, starts, strict=True)
        ]
        searches.add(np.zeros(1), (start, len(packed.groups)))
    return first


def _is_wasteful(size: int, group: Group, edges: Floats, owner: Owner) -> bool:
    """Whether a group's lanes share too few key times to be kept as rows of sixteen."""
    cells, keys = LANES * len(edges), int(owner.keys[group.channels[group.lanes]].sum())
    return size + cells * VECTORS[group.kind] > ROOM and cells > MOST_CELLS_A_KEY * keys


def _add_lanes(
    packed: PackedLanes,
    group: Group,
    tracks: Sequence[Track],
    owner: Owner,
    base: Floats,
    searches: EdgeSearch,
) -> int:
    """Adds a search and rows for each lane of a group; returns the first search."""
    starts = []
    for channel in group.channels:
        edges = _edges(tracks, owner, np.array([channel])) if owner.track[channel] >= 0 else np.zeros(1)
        make = rotation_rows if IS_TURN[group.kind] else scalar_rows
        _, rows = make(group.kind, np.array([channel]), LaneRows(tracks, owner, base, edges))
        at = packed.add(rows[..., 0].astype(np.float32))
        starts.append(searches.add(edges, (at, at)))
    return starts[0]


def _edges(tracks: Sequence[Track], owner: Owner, channels: Ints) -> Floats:
    """The times at which a segment of any of the channels (L,) ends."""
    by_track: list[Floats] = []
    for row in np.unique(owner.track[channels]):
        if row >= 0:
            columns = np.unique(owner.column[channels[owner.track[channels] == row]])
            edges = tracks[row].edges
            ends = edges[owner.changes[row][:, columns].any(1)]
            by_track.append(ends if len(ends) else edges[:1])  # one key: its tangents have no effect
    if all(np.array_equal(edges, by_track[0]) for edges in by_track):
        return by_track[0]
    return np.asarray(np.unique(np.concatenate(by_track)))


def _add_groups(packed: PackedLanes, groups: list[Group], lanes: LaneRows) -> None:
    """Adds groups of one kind with the same edges, all rows in one pass."""
    kind, channels = groups[0].kind, np.concatenate([group.channels for group in groups])
    clocks, rows = (rotation_rows if IS_TURN[kind] else scalar_rows)(kind, channels, lanes)
    steady = np.asarray(in_step(clocks, lanes.edges).reshape(-1, LANES).all(1))
    bare, own = _by_group(rows), _by_group(clocks)
    for row, group in enumerate(groups):
        values = bare[row] if steady[row] else np.concatenate([own[row], bare[row]], 1)
        at = packed.add(values.astype(np.float32))
        clock = IN_STEP if steady[row] else OWN_CLOCKS
        packed.groups.append((kind, at, values[0].size, group.first, packed.mask(group), clock))


def _by_group(rows: Floats) -> Floats:
    """(G, U + 1, V, 16) from (U + 1, V, L)."""
    edges, vectors = rows.shape[:2]
    return rows.reshape(edges, vectors, -1, LANES).transpose(2, 0, 1, 3)


def _groups(tracks: Sequence[Track], owner: Owner, layout: LaneLayout) -> Iterator[Group]:
    """The groups of a clip in which something changes."""
    kinds = np.array([*(track.kind for track in tracks), -1])
    all_lanes = np.ones(LANES, bool)
    for number, channels in enumerate(layout.turning.reshape(-1, LANES)):
        ours, first = kinds[owner.track[channels]], 4 * LANES * number
        turning = [kind for kind in np.unique(ours).tolist() if kind > HOLD]
        if not turning and (ours == HOLD).any():
            yield from (Group(HOLD, channels + k, first + LANES * k, all_lanes) for k in range(4))
        for kind in turning:
            lanes = (ours == kind) | ((ours == HOLD) & (kind == turning[0]))
            yield Group(kind, channels, first, lanes, len(turning) > 1)
    for number, channels in enumerate(layout.moving.reshape(-1, LANES)):
        kind = int(kinds[owner.track[channels]].max())
        if kind >= 0:
            yield Group(kind, channels, 4 * len(layout.turning) + LANES * number, all_lanes)
