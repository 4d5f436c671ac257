"""The layer that gets the jump of a channel: the uppermost layer that begins a blend and moves the channel
gets the jump, less what other layers have on top.

Other layers that begin a blend in the same tick have already got their own jumps (see `offset_apart`), so all
offsets together are the whole jump.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import any_above, either, most
from statwalk.maths.simd.lanes import LANES, broadcast, load, store
from statwalk.maths.simd.pose_lanes import store3
from statwalk.stage.steps.offset_lanes import (
    BEGINS,
    BLANK,
    CLOCKS,
    EARLIER,
    JOINT,
    NOW,
    OWNS,
    channel_at,
    clock_at,
    left_of,
)

ZERO, ONE = np.float32(0), np.float32(1)


@inlined
def jump_at(layers: int, part: int) -> Any:
    """Returns the place in the scratch of the offset of the part-th current channel; its velocity is `JOINT`
    rows further on.
    """
    return (CLOCKS * layers + part) * LANES


@inlined
def keep_jump(scratch: Any, layers: int, first: int, jump: Any) -> None:
    """Writes offset and velocity of three channels into the scratch."""
    at = jump_at(layers, first)
    store3(scratch, at, jump[0])
    store3(scratch, at + JOINT * LANES, jump[1])


@inlined
def _still_on_top(offsets: Any, at: int, layer: int, per_second: Any, scratch: Any) -> Any:
    """What a layer has on top of a channel at the tick before this one, and its velocity."""
    zero = broadcast(ZERO)
    now = left_of(
        offsets, at, load(scratch, clock_at(layer, NOW)), load(scratch, clock_at(layer, NOW + 1)), zero
    )
    start, rate = load(scratch, clock_at(layer, EARLIER)), load(scratch, clock_at(layer, EARLIER + 1))
    return now, (now - left_of(offsets, at, start, rate, zero)) * per_second


@inlined
def _find_owners(layers: int, moved: Any, place: int, scratch: Any) -> None:
    """Marks for each layer the lanes in which it is the uppermost layer that begins a blend and moves a
    place.
    """
    free = broadcast(ONE)
    for layer in range(layers - 1, -1, -1):
        owns = broadcast(ZERO)
        if moved[layer, place]:
            begins = load(scratch, clock_at(layer, BEGINS))
            owns, free = free * begins, free * (broadcast(ONE) - begins)
        store(scratch, clock_at(layer, OWNS), owns)


@inlined
def _less_others(
    offsets: Any, block: int, layer: int, channel: int, count: int, per_second: Any, scratch: Any
) -> None:
    """Subtracts what a layer has on top from the current jumps, in lanes in which the jumps are not
    its own.
    """
    layers, zero, owns = offsets.slot.shape[1], broadcast(ZERO), load(scratch, clock_at(layer, OWNS))
    if any_above(either(owns, zero, load(scratch, clock_at(layer, NOW))), zero):
        for part in range(count):
            place = channel_at(offsets, offsets.slot[block, layer], channel + part)
            now, velocity = _still_on_top(offsets, place, layer, per_second, scratch)
            at = jump_at(layers, part)
            store(scratch, at, load(scratch, at) - either(owns, zero, now))
            at += JOINT * LANES
            store(scratch, at, load(scratch, at) - either(owns, zero, velocity))


@inlined
def _give(offsets: Any, at: int, layer: int, part: int, scratch: Any) -> None:
    """Gives a layer the jump of a channel in the lanes that it owns, and 0 in lanes in which a blend without
    an offset begins.
    """
    owns, jump = load(scratch, clock_at(layer, OWNS)), jump_at(offsets.slot.shape[1], part)
    changes, zero = most(owns, load(scratch, clock_at(layer, BLANK))), broadcast(ZERO)
    start, rate = either(owns, load(scratch, jump), zero), load(scratch, jump + JOINT * LANES)
    store(offsets.start, at, either(changes, start, load(offsets.start, at)))
    store(offsets.rate, at, either(changes, either(owns, rate, zero), load(offsets.rate, at)))


@inlined
def share_out(
    offsets: Any, block: int, channel: int, count: int, moved: Any, place: int, per_second: Any, scratch: Any
) -> None:
    """Gives the jumps of `count` channels to the uppermost layer that begins a blend and moves them; `moved`
    (L, places).
    """
    _find_owners(offsets.slot.shape[1], moved, place, scratch)
    for layer in range(offsets.slot.shape[1]):
        _less_others(offsets, block, layer, channel, count, per_second, scratch)
    for layer in range(offsets.slot.shape[1]):
        if any_above(load(scratch, clock_at(layer, BEGINS)), broadcast(ZERO)):
            for part in range(count):
                _give(
                    offsets,
                    channel_at(offsets, offsets.slot[block, layer], channel + part),
                    layer,
                    part,
                    scratch,
                )


@inlined
def give_part(
    offsets: Any, block: int, layer: int, channel: int, count: int, moves: bool, per_second: Any, scratch: Any
) -> None:
    """Gives a layer the jumps of `count` channels, beside what it has on top, in the lanes of OWNS; 0 if it
    does not move them.
    """
    owns = load(scratch, clock_at(layer, OWNS))
    for part in range(count):
        at = channel_at(offsets, offsets.slot[block, layer], channel + part)
        jump = jump_at(offsets.slot.shape[1], part)
        start = rate = broadcast(ZERO)
        if moves:
            now, velocity = _still_on_top(offsets, at, layer, per_second, scratch)
            start, rate = load(scratch, jump) + now, load(scratch, jump + JOINT * LANES) + velocity
        store(offsets.start, at, either(owns, start, load(offsets.start, at)))
        store(offsets.rate, at, either(owns, rate, load(offsets.rate, at)))
