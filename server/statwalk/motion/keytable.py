"""The channels of a file's animations in columns, over the numbers of the file: thousands of them without an object for each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import overload

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Ints
from statwalk.maths.kernels.choose import loaded
from statwalk.maths.pose import Pose
from statwalk.motion.bundle import Bundle, spans
from statwalk.motion.channel import WIDTHS, Channel, Interpolation, Path
from statwalk.motion.timing import KeyTimes
from statwalk.motion.track import Packed, Track

PATHS: tuple[Path, ...] = ("translation", "rotation", "scale")
INTERPOLATIONS: tuple[Interpolation, ...] = ("STEP", "LINEAR")
PATH_WIDTHS = np.array([WIDTHS[path] for path in PATHS])


@dataclass(frozen=True, eq=False)
class Shelf:
    """C channels with straight keys that a reader of files has checked, of several animations one after the other. Packed together.

    joint, path, interpolation   (C,) rows of the pose; indices into PATHS and INTERPOLATIONS
    times, timing                the different key times, and (C,) which of them each channel has
    numbers, first               float32 numbers of the file, and (C,) where each channel's values start in them
    """

    joint: Ints
    path: Ints
    interpolation: Ints
    times: KeyTimes
    timing: Ints
    numbers: NDArray[np.float32]
    first: Ints

    def channel(self, row: int) -> Channel:
        """One channel, its values a view of the file's numbers."""
        path, times, first = PATHS[self.path[row]], self.times[self.timing[row]], self.first[row]
        width = WIDTHS[path]
        values = self.numbers[first : first + len(times) * width].reshape(-1, width)
        return Channel.checked(int(self.joint[row]), path, times, values, INTERPOLATIONS[self.interpolation[row]])

    @cached_property
    def packed(self) -> tuple[tuple[Ints, Packed], ...]:
        """The channels by kind: which they are, and all of them packed."""
        kind = len(INTERPOLATIONS) * self.path + self.interpolation
        listed = [np.flatnonzero(kind == code) for code in np.flatnonzero(np.bincount(kind))]
        return tuple((rows, Packed(self.bundle(rows), loop=False)) for rows in listed)

    def bundle(self, rows: Ints) -> Bundle:
        """Channels of one kind, their values gathered in one take."""
        path, interpolation = PATHS[self.path[rows[0]]], INTERPOLATIONS[self.interpolation[rows[0]]]
        counts = WIDTHS[path] * self.times.counts[self.timing[rows]]
        values = gathered(self.numbers, self.first[rows], counts).reshape(-1, WIDTHS[path])
        return Bundle(path, interpolation, self.joint[rows], self.times, self.timing[rows], values)


def gathered(numbers: NDArray[np.float32], starts: Ints, counts: Ints) -> NDArray[np.float32]:
    """The counts[i] numbers from starts[i] on, for all i one after the other."""
    compiled = loaded()
    if compiled is None or not numbers.flags.aligned:
        return numbers.take(spans(starts, counts))
    out = np.empty(int(counts.sum()), np.float32)
    compiled.gathered(numbers, np.asarray(starts, np.int64), np.asarray(counts, np.int64), out)
    return out


@dataclass(frozen=True, eq=False)
class KeyTable(Sequence[Channel]):
    """The channels of one animation: those from `start` to `end` of a shelf. Each is made into a Channel when it is asked for."""

    shelf: Shelf
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
        """All of them."""
        return tuple(self.shelf.channel(row) for row in range(self.start, self.end))

    def duration(self) -> float:
        """Seconds to the last key of all channels."""
        return max(float(self.shelf.times[row][-1]) for row in set(self.shelf.timing[self.start : self.end].tolist()))

    def tracks(self) -> tuple[Track, ...]:
        """The channels that change, packed for sampling."""
        return tuple(track for packed, first, last in self.parts for track in packed.tracks(first, last))

    def lay(self, pose: Pose) -> None:
        """Write the values of the channels that never change into an unbatched pose."""
        for packed, first, last in self.parts:
            packed.bundle.lay(pose, first, last)

    @cached_property
    def parts(self) -> list[tuple[Packed, int, int]]:
        """What is packed of the shelf, and which part of it is this animation's."""
        ends = ((packed, rows.searchsorted((self.start, self.end)).tolist()) for rows, packed in self.shelf.packed)
        return [(packed, first, last) for packed, (first, last) in ends]
