"""Steps of the tick that work on a block of poses, each alone over a whole buffer: what tests and benchmarks
call.
"""

from typing import Any

from late_kernel import late_kernel
from numba import types
from statwalk.maths.compiling import FLOAT, LONG, read, write
from statwalk.maths.simd.pose_layout import end_row, first_row
from statwalk.motion.layer_lanes import MASKS, additive_block, override_block
from statwalk.motion.sampling.sample import sample_block
from statwalk.motion.tables.motion_tables import MOTIONS as TABLES
from statwalk.stage.state.pose_offsets import OFFSETS
from statwalk.stage.steps.hash_lanes import hash_block
from statwalk.stage.steps.offset_clocks import advance_clocks, blend_root_delta, release_slots
from statwalk.stage.steps.offset_lanes import add_block

DOUBLE = types.float64


@late_kernel(write(FLOAT, 3), read(FLOAT, 3), read(types.float64, 2), MASKS, LONG)
def override(under: Any, over: Any, weights: Any, masks: Any, layer: int) -> None:
    """`override_block` of all blocks."""
    for block in range(under.shape[0]):
        override_block(under, over, block, weights, masks, layer, block)


@late_kernel(write(FLOAT, 3), read(FLOAT, 3), read(FLOAT, 3), read(types.float64, 2), MASKS, LONG)
def additive(under: Any, over: Any, first: Any, weights: Any, masks: Any, layer: int) -> None:
    """`additive_block` of all blocks."""
    for block in range(under.shape[0]):
        additive_block(under, over, first, block, weights, masks, layer, block)


@late_kernel(OFFSETS, MASKS, write(FLOAT, 3), write(FLOAT, 2))
def add(offsets: Any, masks: Any, pose: Any, scratch: Any) -> None:
    """`add_block` of all blocks."""
    for block in range(pose.shape[0]):
        add_block(offsets, masks, pose, block, block, 0.0, scratch)


@late_kernel(OFFSETS, types.float64, write(types.float64, 2))
def pass_time(offsets: Any, dt: float, way: Any) -> None:
    """Lets `dt` seconds pass for all transitions, blends the ways (N, 3), and takes slots back."""
    for row in range(offsets.elapsed.shape[0]):
        advance_clocks(offsets, row, dt)
        blend_root_delta(offsets, row, way)
    for block in range(offsets.slot.shape[0]):
        release_slots(offsets, block)


@late_kernel(write(types.uint64, 1), read(FLOAT, 3), LONG, OFFSETS, write(FLOAT, 2))
def rehash(hashes: Any, pose: Any, used: int, offsets: Any, scratch: Any) -> None:
    """`hash_block` of all blocks."""
    for block in range(pose.shape[0]):
        hash_block(hashes, pose, used, offsets, block, scratch)


@late_kernel(
    TABLES,
    read(LONG, 2),
    read(DOUBLE, 2),
    LONG,
    types.boolean,
    read(DOUBLE, 2),
    write(DOUBLE, 1),
    write(FLOAT, 1),
    write(FLOAT, 3),
)
def sample_all(
    motions: Any,
    states: Any,
    times: Any,
    layer: int,
    start: bool,
    parameters: Any,
    weights: Any,
    rows: Any,
    out: Any,
) -> None:
    """The poses of all actors in one layer into a PoseBuffer's values (B, C, 16)."""
    for block in range(out.shape[0]):
        first = first_row(block)
        count = end_row(block, states.shape[0]) - first
        sample_block(
            motions, states, times, layer, start, parameters, first, count, weights, rows, out, block
        )
