"""All motions of a role as read-only contiguous arrays for compiled code.

A pose is sampled as a *packed row*: first the rotations that differ between the motions, sixteen joints at a
time (16 x, 16 y, 16 z, 16 w), then all other numbers that differ, sixteen at a time. Channels that all
motions share with the rest pose are in no packed row.
"""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.columns import columns
from statwalk.maths.simd.lanes import LANES
from statwalk.motion.keys.segment_kinds import VECTORS


class MotionTables(NamedTuple):
    """S states, K members (a clip in a state), M clips (the first is the rest pose), T searches, G groups of
    sixteen lanes.

    Packed rows have W float32 numbers, R of them for rotations.
    """

    states: Annotated[NDArray[np.int64], "state, 5"]
    """the first six columns as in `maths.blend_tables.BlendTables`"""
    durations: Annotated[NDArray[np.float64], "state"]
    bounds: Annotated[NDArray[np.float64], "state, 4"]
    members: Annotated[NDArray[np.int64], "member, 5"]
    places: Annotated[NDArray[np.float64], "member, 5"]
    knots: Annotated[NDArray[np.float64], "knot, 2"]
    roots: Annotated[NDArray[np.int64], "root track, 2"]
    """search among the times of a root track (-1: it stands), and the first row of `ways`"""
    ways: Annotated[NDArray[np.float64], "key, 3"]
    """x, z (metres), yaw (radians)"""
    clips: Annotated[NDArray[np.int64], "clip, 3"]
    """the first search of each clip, the end of its searches, and whether its groups fill the whole packed
    row
    """
    searches: Annotated[NDArray[np.int64], "search, 6"]
    """first edge, number of edges, first bucket, number of buckets, first group, end of the groups (of a
    LOOSE lane: the index of its first number in `values`)
    """
    scales: Annotated[NDArray[np.float64], "search"]
    """buckets a second"""
    edges: Annotated[NDArray[np.float64], "edge"]
    """seconds, rising in each search"""
    paces: Annotated[NDArray[np.float64], "edge"]
    """one over the seconds from each edge to the next, 0 at the last"""
    buckets: Annotated[NDArray[np.int32], "bucket"]
    """the number of edges before each bucket"""
    groups: Annotated[NDArray[np.int64], "group, 6"]
    """kind, first of its `values`, numbers in each row, first number in the packed row, first of the mask in
    `values` (-1: all lanes), what the lanes share (a LOOSE group has the search of its first lane in place of
    `values`)
    """
    values: Annotated[NDArray[np.float32], "number"]
    """the rows of all groups, see `lane_rows`"""
    base: Annotated[NDArray[np.float32], "clip, W"]
    """the packed row of a clip's constant channels"""
    layout: Annotated[NDArray[np.int32], "2 + W"]
    """R and W, then the index in a block (`pose_layout`) for each number of a packed row"""
    common: Annotated[NDArray[np.int32], "channel"]
    """indices in a block of the channels that all motions share with the rest pose"""
    common_values: Annotated[NDArray[np.float32], "channel"]
    """the values of the common channels"""

    @property
    def width(self) -> int:
        """Returns W, the numbers of a packed row."""
        return int(self.layout[1])

    @property
    def memory(self) -> int:
        """Returns the float32 numbers of memory needed to sample a block."""
        return (LANES + 1) * self.width + LANES * (max(VECTORS) + 1)

    @property
    def most_members(self) -> int:
        """Returns the number of clips of the largest blend space; 1 if there is none."""
        return int(self.states[:, 1].max(initial=1))


MOTIONS = columns(MotionTables, readonly=True)
"""the numba type of MotionTables"""
