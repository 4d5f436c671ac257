"""The running hash of sixteen actors at a time: of their poses and of their offsets under way, on top of the
hash so far.
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.hashing import HALF_WORD, lane_hash, stir, stir_where
from statwalk.maths.simd.lane_bits import with_word
from statwalk.maths.simd.lane_functions import any_above
from statwalk.maths.simd.lanes import broadcast, load
from statwalk.maths.simd.pose_layout import end_row, first_row, index_at
from statwalk.stage.steps.offset_lanes import NOW, ZERO, channel_at, clock_at, read_clocks


@inlined
def _halves_of(hashes: Any, block: int) -> Any:
    """The hashes of a block in lanes: lower and upper halves."""
    low = high = broadcast(ZERO)
    first = first_row(block)
    for row in range(first, end_row(block, hashes.shape[0])):
        low = with_word(low, row - first, hashes[row])
        high = with_word(high, row - first, hashes[row] >> HALF_WORD)
    return low, high


@inlined
def _hash_poses(halves: Any, pose: Any, used: int, block: int) -> Any:
    """The halves after hashing the first `used` channels of a block."""
    even, odd = halves, (halves[1], halves[0])  # two chains: a step waits for the one before it
    for channel in range(0, used - 1, 2):
        even = stir(even, load(pose, index_at(pose, block, channel)))
        odd = stir(odd, load(pose, index_at(pose, block, channel + 1)))
    if used % 2:
        even = stir(even, load(pose, index_at(pose, block, used - 1)))
    return stir(stir(even, odd[0]), odd[1])


@inlined
def _hash_offsets(halves: Any, offsets: Any, block: int, scratch: Any) -> Any:
    """The halves after hashing the offsets of a block under way."""
    for layer in range(offsets.slot.shape[1]):
        slot = offsets.slot[block, layer]
        if slot >= 0:
            read_clocks(offsets, block, layer, 0.0, scratch, NOW)
            under_way = load(scratch, clock_at(layer, NOW))
            if any_above(under_way, broadcast(ZERO)):
                for channel in range(offsets.start.shape[1]):
                    at = channel_at(offsets, slot, channel)
                    halves = stir_where(under_way, halves, load(offsets.start, at))
                    halves = stir_where(under_way, halves, load(offsets.rate, at))
    return halves


@called
def hash_block(hashes: Any, pose: Any, used: int, offsets: Any, block: int, scratch: Any) -> None:
    """Updates the hashes (N,) of a block's actors with their poses (`used` channels) and their offsets."""
    halves = _hash_offsets(_hash_poses(_halves_of(hashes, block), pose, used, block), offsets, block, scratch)
    first = first_row(block)
    for row in range(first, end_row(block, hashes.shape[0])):
        hashes[row] = lane_hash(halves, row - first)
