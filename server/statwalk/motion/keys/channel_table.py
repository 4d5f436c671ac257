"""The channels of a file's animations as columns over the numbers of the file: thousands of channels without
an object for each.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import overload

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Ints
from statwalk.maths.pose import Pose
from statwalk.motion.keys import _kernels
from statwalk.motion.keys.channel import WIDTHS, Channel, Interpolation, Path
from statwalk.motion.keys.key_set import KeySet
from statwalk.motion.keys.key_times import KeyTimes
from statwalk.motion.keys.packed_keys import PackedKeys, Track

PATHS: tuple[Path, ...] = ("translation", "rotation", "scale")
INTERPOLATIONS: tuple[Interpolation, ...] = ("STEP", "LINEAR")
PATH_WIDTHS = np.array([WIDTHS[path] for path in PATHS])


@dataclass(frozen=True, eq=False)
class ChannelTable:
    """C channels with STEP or LINEAR keys, checked by a reader of files, of several animations one after the
    other.

    joint, path, interpolation   (C,) rows of the pose; indices into PATHS and INTERPOLATIONS
    times, timing                the distinct key times, and (C,) the row of each channel's key times
    numbers, first               float32 numbers of the file, and (C,) the index at which each channel's
                                 values start
    """

    joint: Ints
    path: Ints
    interpolation: Ints
    times: KeyTimes
    timing: Ints
    numbers: NDArray[np.float32]
    first: Ints

    def channel(self, row: int) -> Channel:
        """Returns one channel; its values are a view of the file's numbers."""
        path, times, first = PATHS[self.path[row]], self.times[self.timing[row]], self.first[row]
        width = WIDTHS[path]
        values = self.numbers[first : first + len(times) * width].reshape(-1, width)
        return Channel.checked(
            int(self.joint[row]), path, times, values, INTERPOLATIONS[self.interpolation[row]]
        )

    @cached_property
    def packed(self) -> tuple[tuple[Ints, PackedKeys], ...]:
        """Returns the channels by kind: their rows, and all of them packed."""
        kind = len(INTERPOLATIONS) * self.path + self.interpolation
        listed = [np.flatnonzero(kind == code) for code in np.flatnonzero(np.bincount(kind))]
        return tuple((rows, PackedKeys(self.key_set(rows), loop=False)) for rows in listed)

    def key_set(self, rows: Ints) -> KeySet:
        """Returns the key set of channels of one kind, their values gathered in one pass."""
        path, interpolation = PATHS[self.path[rows[0]]], INTERPOLATIONS[self.interpolation[rows[0]]]
        counts = WIDTHS[path] * self.times.counts[self.timing[rows]]
        values = gathered(self.numbers, self.first[rows], counts).reshape(-1, WIDTHS[path])
        return KeySet(path, interpolation, self.joint[rows], self.times, self.timing[rows], values)


def gathered(numbers: NDArray[np.float32], starts: Ints, counts: Ints) -> NDArray[np.float32]:
    """Returns counts[i] numbers from starts[i] on, for all i one after the other."""
    out = np.empty(int(counts.sum()), np.float32)
    _kernels.gathered(
        np.require(numbers, requirements=["C", "A"]),
        np.asarray(starts, np.int64),
        np.asarray(counts, np.int64),
        out,
    )
    return out


@dataclass(frozen=True, eq=False)
class ClipChannels(Sequence[Channel]):
    """The channels of one animation: rows `start` to `end` of a table.

    Each Channel is made on first use.
    """

    table: ChannelTable
    start: int
    end: int

    def __len__(self) -> int:
        return self.end - self.start

    @overload
    def __getitem__(self, row: int) -> Channel: ...

    @overload
    def __getitem__(self, row: slice) -> tuple[Channel, ...]: ...

    def __getitem__(self, row: int | slice) -> Channel | tuple[Channel, ...]:
        return self.channels[row]

    def __iter__(self) -> Iterator[Channel]:
        return iter(self.channels)

    @cached_property
    def channels(self) -> tuple[Channel, ...]:
        """Returns all channels."""
        return tuple(self.table.channel(row) for row in range(self.start, self.end))

    def duration(self) -> float:
        """Returns the seconds to the last key of all channels."""
        return max(
            float(self.table.times[row][-1]) for row in set(self.table.timing[self.start : self.end].tolist())
        )

    def tracks(self) -> tuple[Track, ...]:
        """Returns the channels that change, packed for sampling."""
        return tuple(track for packed, first, last in self.parts for track in packed.tracks(first, last))

    def lay(self, pose: Pose) -> None:
        """Writes the values of the constant channels into an unbatched pose."""
        for packed, first, last in self.parts:
            packed.key_set.lay(pose, first, last)

    @cached_property
    def parts(self) -> list[tuple[PackedKeys, int, int]]:
        """Returns the packed keys of the table, each with the range that belongs to this animation."""
        ends = (
            (packed, rows.searchsorted((self.start, self.end)).tolist()) for rows, packed in self.table.packed
        )
        return [(packed, first, last) for packed, (first, last) in ends]
