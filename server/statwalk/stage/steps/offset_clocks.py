"""The clocks of transitions, actor by actor, and the slots of their offsets.

Also runs as plain Python.
"""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.pose_layout import end_row, first_row

ROUNDING_S = 1e-6
"""a transition with less than this left is over: 12 times 1/60 s is 0.2 s"""


@inlined
def remaining(offsets: Any, row: int, layer: int, earlier: float) -> Any:
    """Returns what was left of an offset `earlier` seconds before now: factors of its start and of its
    velocity, 0 if no transition is under way.

    It decays along a cubic, or along a quintic that ends without acceleration and jerk (see
    `motion.inertialize`).
    """
    duration = offsets.duration[row, layer]
    if not offsets.elapsed[row, layer] < duration:
        return 0.0, 0.0
    left = 1.0 - max(offsets.elapsed[row, layer] - earlier, 0.0) / duration
    drift, square = duration * (1.0 - left), left * left
    if offsets.quintic[row, layer]:
        return (5.0 - 4.0 * left) * (square * square), drift * (square * square)
    return (3.0 - 2.0 * left) * square, drift * square


@inlined
def advance_clocks(offsets: Any, row: int, dt: float) -> None:
    """Advances an actor's transitions by `dt` seconds."""
    for layer in range(offsets.elapsed.shape[1]):
        elapsed, duration = offsets.elapsed[row, layer] + dt, offsets.duration[row, layer]
        offsets.elapsed[row, layer] = elapsed if elapsed + ROUNDING_S < duration else duration


@inlined
def blend_root_delta(offsets: Any, row: int, root_delta: Any) -> None:
    """Blends the root motion (N, 3) of an actor smoothly from the old motion's velocity to the new
    motion's.
    """
    elapsed, duration = offsets.elapsed[row, 0], offsets.duration[row, 0]
    if elapsed < duration:
        part = elapsed / duration
        weight = part * part * (3.0 - 2.0 * part)
        for axis in range(3):
            root_delta[row, axis] = (
                offsets.old_root_delta[row, axis]
                + (root_delta[row, axis] - offsets.old_root_delta[row, axis]) * weight
            )


@inlined
def has_room(offsets: Any) -> Any:
    """Returns whether all layers of a block can get slots, the most that `begin_block` needs."""
    return offsets.free_count[0] >= offsets.slot.shape[1]


@inlined
def take_slot(offsets: Any, block: int, layer: int) -> None:
    """Takes a free slot for a block's layer without one."""
    if offsets.slot[block, layer] < 0:
        last = offsets.free_count[0] - 1
        offsets.slot[block, layer] = offsets.free[last]
        offsets.free_count[0] = last


@inlined
def release_slots(offsets: Any, block: int) -> None:
    """Releases the slots in which no actor of the block has a transition under way."""
    for layer in range(offsets.slot.shape[1]):
        under_way = False
        for row in range(first_row(block), end_row(block, offsets.elapsed.shape[0])):
            under_way |= offsets.elapsed[row, layer] < offsets.duration[row, layer]
        if offsets.slot[block, layer] >= 0 and not under_way:
            offsets.free[offsets.free_count[0]] = offsets.slot[block, layer]
            offsets.free_count[0] += 1
            offsets.slot[block, layer] = -1
