"""The kernel that solves a chain for all blocks of a pose buffer."""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.maths.clamp_table import CLAMP_TABLE
from statwalk.maths.compiling import FLOAT, LONG, kernel, write
from statwalk.maths.packed import ADDRESSES, opened
from statwalk.maths.simd.lanes import LANES
from statwalk.solve.chains import CHAINS, ROWS
from statwalk.solve.solve_block import solve_chain_block

_chains, _clamps = opened(CHAINS), opened(CLAMP_TABLE)


@kernel(
    ADDRESSES, ADDRESSES, LONG, write(FLOAT, 3), write(FLOAT, 4), write(FLOAT, 1), write(types.float64, 2)
)  # fmt: skip
def solve(
    tables: Any, limits: Any, number: int, values: Any, rows: Any, scratch: Any, keep: Any
) -> None:  # fmt: skip
    """Runs `solve_chain_block` on every block; rows (B, chains, ROWS, LANES)."""
    chains, clamps = _chains(tables), _clamps(limits)
    for block in range(values.shape[0]):
        at = (block * rows.shape[1] + number) * ROWS * LANES
        solve_chain_block(chains, clamps, number, values, block, rows, at, scratch, keep)
