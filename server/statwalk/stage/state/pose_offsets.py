"""Pose offsets of transitions under way, which decay to zero, and the root motion of the old motions.

An offset (`motion.inertialize`) is D = 9 J + W numbers: for each joint the move xyz, the turn xyz (a rotation
vector) and the stretch xyz, then the morph weights. Offsets are stored by layer and block of sixteen actors,
and only while an actor of the block has an offset.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numba import types
from numpy.typing import NDArray

from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.compiling import FLOAT, INT, LONG, write
from statwalk.maths.simd.pose_layout import blocks, places, zero_blocks


class Transitions(NamedTuple):
    """The transitions that begin in a tick, for N actors in L layers: one for the last change of state of
    each layer.
    """

    seconds: NDArray[np.float64]
    """(N, L) duration of the blend; 0: a cut; below 0: no transition begins"""
    quintic: NDArray[np.bool_]
    """(N, L) whether the curve is a quintic, else a cubic"""


class PoseOffsets(NamedTuple):
    """The transitions of N actors in L layers, under way if `elapsed` < `duration`; K slots for offsets."""

    slot: NDArray[np.int32]
    """(B, L) the slot of a block's layer, -1: no actor of the block has an offset"""
    start: NDArray[np.float32]
    """(K, D, 16) the offsets at the beginning of their transitions"""
    rate: NDArray[np.float32]
    """(K, D, 16) velocity of the offsets at that moment, per second"""
    free: NDArray[np.int32]
    """(K,) the free slots are the first `free_count`"""
    free_count: NDArray[np.int64]
    """(1,)"""
    elapsed: NDArray[np.float64]
    """(N, L) seconds"""
    duration: NDArray[np.float64]
    """(N, L) seconds"""
    quintic: NDArray[np.bool_]
    """(N, L) whether the curve is a quintic, else a cubic"""
    old_root_delta: NDArray[np.float64]
    """(N, 3) x, z, yaw: root motion of the old motion of the base layer in a tick"""

    @classmethod
    def none(cls, count: int, layers: int, size: int, slots: int = 0) -> PoseOffsets:
        """Returns `count` actors without transitions, with `slots` slots for offsets of `size` numbers."""
        slot = np.full((blocks(count), layers), -1, np.int32)
        clocks = np.zeros((count, layers)), np.zeros((count, layers)), np.zeros((count, layers), bool)
        free = np.arange(slots, dtype=np.int32)
        return cls(
            slot,
            zero_blocks(slots, size),
            zero_blocks(slots, size),
            free,
            np.array([slots]),
            *clocks,
            np.zeros((count, 3)),
        )

    @property
    def is_under_way(self) -> Bools:
        """(N, L) whether a transition is under way."""
        return self.elapsed < self.duration

    @property
    def left(self) -> Floats:
        """(N, L) 1…0, the share of each transition that is left."""
        done: Floats = np.where(
            self.duration > 0, self.elapsed / np.where(self.duration > 0, self.duration, 1), 1
        )
        return 1 - done

    def end(self, actors: Ints) -> None:
        """Ends all transitions of the actors at some rows; their slots are released at the next tick."""
        self.elapsed[actors], self.duration[actors], self.quintic[actors] = 0.0, 0.0, False

    def with_room(self, beginning: Ints) -> PoseOffsets:
        """Returns offsets with slots for all transitions that may begin in the blocks of the actors at some
        rows: `self` if it has room, else a copy with at least twice the room.
        """
        layers, free = self.slot.shape[1], int(self.free_count[0])
        if len(beginning) * layers <= free:
            return self
        needed = len(np.unique(places(beginning)[0])) * layers
        return self if needed <= free else self.grown(len(self.start) + needed - free)

    def grown(self, slots: int = 0) -> PoseOffsets:
        """Returns a copy with twice the slots, and at least `slots`."""
        old, size = len(self.start), self.start.shape[1]
        room = max(2 * old, slots, self.slot.shape[1])
        start, rate, free = zero_blocks(room, size), zero_blocks(room, size), np.empty(room, np.int32)
        start[:old], rate[:old] = self.start, self.rate
        count = int(self.free_count[0])
        free[:count], free[count : count + room - old] = self.free[:count], np.arange(old, room)
        return self._replace(start=start, rate=rate, free=free, free_count=np.array([count + room - old]))

    def copy(self) -> PoseOffsets:
        """Returns a copy that shares no memory."""
        start, rate = (zero_blocks(len(array), array.shape[1]) for array in (self.start, self.rate))
        start[:], rate[:] = self.start, self.rate
        return PoseOffsets._make(array.copy() for array in self)._replace(start=start, rate=rate)

    def rows(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Returns offsets and velocities (M, D) of all transitions under way, by actor and layer: the form
        for storing and sending.
        """
        rows, layers = self.is_under_way.nonzero()
        block, lanes = places(rows)
        slots = self.slot[block, layers]
        return self.start[slots, :, lanes], self.rate[slots, :, lanes]

    @classmethod
    def of_rows(
        cls, clocks: Sequence[NDArray[np.float64] | NDArray[np.bool_]], start: Floats, rate: Floats
    ) -> PoseOffsets:
        """Returns the offsets from `rows()` and the clocks `elapsed duration quintic old_root_delta`."""
        elapsed, duration, quintic, old_root_delta = clocks
        rows, layers = (elapsed < duration).nonzero()
        block, lane = places(rows)
        used, slot_of = np.unique(block * elapsed.shape[1] + layers, return_inverse=True)
        made = cls.none(len(elapsed), elapsed.shape[1], start.shape[1], len(used))
        made.slot.reshape(-1)[used], made.free_count[0] = np.arange(len(used)), 0
        made.start[slot_of, :, lane], made.rate[slot_of, :, lane] = start, rate
        for array, values in zip(made[5:], (elapsed, duration, quintic, old_root_delta), strict=True):
            array[:] = values
        return made

    def take(self, actors: Ints) -> PoseOffsets:
        """Returns the actors at some rows, in this order."""
        number = np.full(self.elapsed.shape, -1)
        number[self.is_under_way] = np.arange(np.count_nonzero(self.is_under_way))
        taken = number[actors]
        start, rate = (array[taken[taken >= 0]] for array in self.rows())
        return PoseOffsets.of_rows([array[actors] for array in self[5:]], start, rate)

    def append(self, other: PoseOffsets) -> PoseOffsets:
        """Returns the actors of these offsets followed by the actors of `other`."""
        clocks = [np.concatenate(pair) for pair in zip(self[5:], other[5:], strict=True)]
        start, rate = (np.concatenate(pair) for pair in zip(self.rows(), other.rows(), strict=True))
        return PoseOffsets.of_rows(clocks, start, rate)

    def with_layers(self, order: Sequence[int]) -> PoseOffsets:
        """Returns the layers in another order; -1 stands for a new layer."""
        blank = [
            np.concatenate([array, np.zeros_like(array[:, :1])], 1)[:, list(order)] for array in self[5:8]
        ]
        numbers = np.full((len(self.old_root_delta), self.slot.shape[1] + 1), -1)
        numbers[:, :-1][self.is_under_way] = np.arange(np.count_nonzero(self.is_under_way))
        kept = numbers[:, list(order)]
        start, rate = (array[kept[kept >= 0]] for array in self.rows())
        return PoseOffsets.of_rows([*blank, self.old_root_delta], start, rate)


def offset_size(joints: int, weights: int) -> int:
    """Returns how many numbers an offset has."""
    return 9 * joints + weights


_CLOCKS = [write(types.float64, 2), write(types.float64, 2), write(types.boolean, 2), write(types.float64, 2)]
OFFSETS = types.BaseTuple.from_types(
    [write(INT, 2), write(FLOAT, 3), write(FLOAT, 3), write(INT, 1), write(LONG, 1), *_CLOCKS], PoseOffsets
)
"""the type of PoseOffsets in kernels"""
TRANSITIONS = types.BaseTuple.from_types([write(types.float64, 2), write(types.boolean, 2)], Transitions)
"""the type of Transitions in kernels"""
