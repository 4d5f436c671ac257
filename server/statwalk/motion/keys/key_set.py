"""Channels of one kind side by side: their keys one channel after the other, so that a few array operations
pack all of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion.keys import _kernels
from statwalk.motion.keys.channel import Channel, Interpolation, Path
from statwalk.motion.keys.key_times import KeyTimes


@dataclass(frozen=True, eq=False)
class KeySet:
    """The keys of C channels with one path and one kind of interpolation; their key times may differ.

    path, interpolation   the property that the channels move, and how
    target                (C,) joints, or columns of the weights
    times                 the distinct key times
    timing                (C,) the row of each channel's key times
    values                (S, …) the values of all keys, one channel after the other
    key_weights           (S,) the weights of all keys of NURBS, None for other curves
    """

    path: Path
    interpolation: Interpolation
    target: Ints
    times: KeyTimes
    timing: Ints
    values: Floats
    key_weights: Floats | None = None

    @cached_property
    def counts(self) -> Ints:
        """Returns (C,) the number of keys of each channel."""
        return self.times.counts[self.timing]

    @cached_property
    def starts(self) -> Ints:
        """Returns (C,) the row of each channel's first key."""
        return self.counts.cumsum() - self.counts

    @cached_property
    def ends(self) -> Ints:
        """Returns (C,) the row after each channel's last key."""
        return self.starts + self.counts

    @cached_property
    def keys(self) -> Floats:
        """Returns (S, n) the key values, without the tangents of a CUBICSPLINE."""
        return self.values[:, 1] if self.interpolation == "CUBICSPLINE" else self.values

    @cached_property
    def is_constant(self) -> Bools:
        """Returns (C,) whether a channel has the same value at every time."""
        if self.values.ndim == 2 and self.values.dtype == np.float32:
            constant = np.empty(len(self.counts), bool)
            _kernels.constant(
                np.require(self.values, requirements=["C", "A"]), np.asarray(self.ends, np.int64), constant
            )
            return constant
        width = self.keys.shape[-1]
        same = self.keys == self.keys[self.starts].repeat(self.counts, 0)
        if self.interpolation == "CUBICSPLINE":
            same &= (self.values[:, ::2] == 0).all(1)
        return np.logical_and.reduceat(same.ravel(), width * self.starts)

    def taken(self, rows: Ints) -> KeySet:
        """Returns the key set of some channels."""
        keys = spans(self.starts[rows], self.counts[rows])
        weights = None if self.key_weights is None else self.key_weights[keys]
        target, timing = self.target[rows], self.timing[rows]
        return KeySet(self.path, self.interpolation, target, self.times, timing, self.values[keys], weights)

    def lay(self, pose: Pose, first: int = 0, last: int | None = None) -> None:
        """Writes the values of the constant channels among first…last into an unbatched pose."""
        rows = np.flatnonzero(self.is_constant[first:last]) + first
        if not len(rows):
            return
        values, target = self.keys[self.starts[rows]], self.target[rows]
        if self.path == "weights":
            pose.weights[target] = values[:, 0]
        else:
            getattr(pose, self.path)[target] = (
                quat.normalize(values.astype(np.float64)) if self.path == "rotation" else values
            )


def spans(starts: Ints, counts: Ints) -> Ints:
    """Returns the rows starts[i], starts[i] + 1, …, counts[i] of them, for all i one after the other."""
    if (counts == counts[:1]).all():
        return np.asarray(starts[:, None] + np.arange(counts[0] if len(counts) else 0)).ravel()
    return np.asarray((starts - counts.cumsum() + counts).repeat(counts) + np.arange(counts.sum()))


def key_sets_of(channels: Sequence[Channel]) -> tuple[KeySet, ...]:
    """Returns the channels grouped by kind; every weight becomes a channel of its own, so that all weights
    lie side by side.
    """
    by_kind: dict[tuple[str, str], list[Channel]] = {}
    for channel in channels:
        by_kind.setdefault((channel.path, channel.interpolation), []).extend(_single_weights(channel))
    return tuple(key_set_of(of_kind) for of_kind in by_kind.values())


def _single_weights(channel: Channel) -> list[Channel]:
    """A channel of weights as one channel for each weight; any other channel as it is."""
    if channel.path != "weights":
        return [channel]
    count = channel.values.shape[-1]
    return [
        Channel(
            channel.joint,
            "weights",
            channel.times,
            channel.values[..., i : i + 1],
            channel.interpolation,
            channel.weight_first + i,
            channel.key_weights,
        )
        for i in range(count)
    ]


def key_set_of(channels: Sequence[Channel]) -> KeySet:
    """Returns the key set of channels of one kind."""
    distinct_times: dict[bytes, int] = {}
    timing = [
        distinct_times.setdefault(channel.times.astype(np.float64).tobytes(), len(distinct_times))
        for channel in channels
    ]
    target = [channel.weight_first if channel.path == "weights" else channel.joint for channel in channels]
    values = np.concatenate([channel.values for channel in channels])
    times = KeyTimes([np.frombuffer(key) for key in distinct_times])
    path, interpolation = channels[0].path, channels[0].interpolation
    weights = (
        np.concatenate([_weights(channel) for channel in channels]) if "NURBS" in interpolation else None
    )
    return KeySet(path, interpolation, np.array(target), times, np.array(timing), values, weights)


def _weights(channel: Channel) -> Floats:
    return np.ones(len(channel.times)) if channel.key_weights is None else channel.key_weights
