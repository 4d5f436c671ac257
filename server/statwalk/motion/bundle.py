"""Channels of one kind side by side: their keys one channel after the other, so that all of them are packed by a few array operations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.kernels.choose import loaded
from statwalk.maths.pose import Pose
from statwalk.motion.channel import Channel, Interpolation, Path
from statwalk.motion.timing import KeyTimes


@dataclass(frozen=True, eq=False)
class Bundle:
    """The keys of C channels with one path and one kind of interpolation; their key times may differ.

    path, interpolation   what all of them move, and how
    target                (C,) joints, or columns of the weights
    times                 the different key times
    timing                (C,) which of them each channel has
    values                (S, …) the values of all keys, one channel after the other
    """

    path: Path
    interpolation: Interpolation
    target: Ints
    times: KeyTimes
    timing: Ints
    values: Floats

    @cached_property
    def counts(self) -> Ints:
        """(C,) how many keys each channel has."""
        return self.times.counts[self.timing]

    @cached_property
    def starts(self) -> Ints:
        """(C,) the row of each channel's first key."""
        return self.counts.cumsum() - self.counts

    @cached_property
    def ends(self) -> Ints:
        """(C,) the row after each channel's last key."""
        return self.starts + self.counts

    @cached_property
    def keys(self) -> Floats:
        """(S, n) the key values, without the tangents of a CUBICSPLINE."""
        return self.values[:, 1] if self.interpolation == "CUBICSPLINE" else self.values

    @cached_property
    def is_constant(self) -> Bools:
        """(C,) whether a channel says the same at every time."""
        compiled = loaded()
        if compiled is not None and self.values.ndim == 2 and self.values.dtype == np.float32:
            found = np.empty(len(self.counts), bool)
            compiled.constant(np.require(self.values, requirements=["C", "A"]), np.asarray(self.ends, np.int64), found)
            return found
        width = self.keys.shape[-1]
        same = self.keys == self.keys[self.starts].repeat(self.counts, 0)
        if self.interpolation == "CUBICSPLINE":
            same &= (self.values[:, ::2] == 0).all(1)
        return np.logical_and.reduceat(same.ravel(), width * self.starts)

    def taken(self, rows: Ints) -> Bundle:
        """Some of its channels."""
        values = self.values[spans(self.starts[rows], self.counts[rows])]
        return Bundle(self.path, self.interpolation, self.target[rows], self.times, self.timing[rows], values)

    def lay(self, pose: Pose, first: int = 0, last: int | None = None) -> None:
        """Write the values of those channels that never change, of the channels first…last, into an unbatched pose."""
        rows = np.flatnonzero(self.is_constant[first:last]) + first
        if not len(rows):
            return
        values, target = self.keys[self.starts[rows]], self.target[rows]
        if self.path == "weights":
            pose.weights[target] = values[:, 0]
        else:
            getattr(pose, self.path)[target] = quat.normalize(values.astype(np.float64)) if self.path == "rotation" else values


def spans(starts: Ints, counts: Ints) -> Ints:
    """The rows starts[i], starts[i] + 1, …, so many as counts[i], for all i one after the other."""
    if (counts == counts[:1]).all():
        return np.asarray(starts[:, None] + np.arange(counts[0] if len(counts) else 0)).ravel()
    return np.asarray((starts - counts.cumsum() + counts).repeat(counts) + np.arange(counts.sum()))


def bundles_of(channels: Sequence[Channel]) -> tuple[Bundle, ...]:
    """The channels, those of one kind together; every weight is a channel of its own, so that all weights can lie side by side."""
    alike: dict[tuple[str, str], list[Channel]] = {}
    for channel in channels:
        alike.setdefault((channel.path, channel.interpolation), []).extend(single_weights(channel))
    return tuple(bundle(listed) for listed in alike.values())


def single_weights(channel: Channel) -> list[Channel]:
    """A channel of weights as one channel for each weight; any other as it is."""
    if channel.path != "weights":
        return [channel]
    count = channel.values.shape[-1]
    return [
        Channel(channel.joint, "weights", channel.times, channel.values[..., i : i + 1], channel.interpolation, channel.weight_first + i)
        for i in range(count)
    ]


def bundle(channels: Sequence[Channel]) -> Bundle:
    """Channels of one kind."""
    known: dict[bytes, int] = {}
    timing = [known.setdefault(channel.times.astype(np.float64).tobytes(), len(known)) for channel in channels]
    target = [channel.weight_first if channel.path == "weights" else channel.joint for channel in channels]
    values = np.concatenate([channel.values for channel in channels])
    times = KeyTimes([np.frombuffer(key) for key in known])
    return Bundle(channels[0].path, channels[0].interpolation, np.array(target), times, np.array(timing), values)
