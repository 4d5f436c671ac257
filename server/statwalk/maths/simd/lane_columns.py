"""Loads and stores that transpose: vectors of three, quaternions and matrices in memory, one component of
each in sixteen lanes.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils

from statwalk.maths.compiling import intrinsic
from statwalk.maths.simd.lanes import INT32, LANES, LANES_TYPE, loaded, place, shuffled, stored

QUAD = ir.VectorType(ir.FloatType(), 4)


def _rows_from(context: Any, builder: Any, sig: Any, args: Any, count: int) -> list[Any]:
    """`count` times sixteen floats, one after the other."""
    starts = [builder.add(args[1], ir.Constant(args[1].type, LANES * row)) for row in range(count)]
    return [loaded(builder, place(context, builder, sig.args[0], args[0], start)) for start in starts]


@intrinsic
def load_xyz(_typing: Any, array: Any, index: Any) -> Any:
    """load_xyz(array, index): x, y and z of 16 vectors, 48 floats."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        rows, axes = _rows_from(context, builder, sig, args, 3), []
        for axis in range(3):
            lanes = [3 * vector + axis for vector in range(LANES)]
            pairs = shuffled(builder, rows[0], rows[1], [lane % (2 * LANES) for lane in lanes])
            picks = [vector if lane < 2 * LANES else lane - LANES for vector, lane in enumerate(lanes)]
            axes.append(shuffled(builder, pairs, rows[2], picks))
        return cgutils.pack_array(builder, axes)

    return types.UniTuple(LANES_TYPE, 3)(array, types.int64), code


@intrinsic
def load_quads(_typing: Any, array: Any, index: Any) -> Any:
    """load_quads(array, index): the four columns of 16 rows of four floats; the order of the rows differs,
    but is the same in all columns.
    """

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return cgutils.pack_array(builder, _exchanged(builder, _rows_from(context, builder, sig, args, 4)))

    return types.UniTuple(LANES_TYPE, 4)(array, types.int64), code


@intrinsic
def store_xyz(_typing: Any, array: Any, index: Any, x: Any, y: Any, z: Any) -> Any:
    """store_xyz(array, index, x, y, z): 48 floats, x y z of the first lane, then of the second, and so on."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        for part in range(3):
            lanes = [divmod(LANES * part + lane, 3) for lane in range(LANES)]
            pairs = shuffled(
                builder, args[2], args[3], [vertex + LANES * (axis == 1) for vertex, axis in lanes]
            )
            picks = [LANES + vertex if axis == 2 else lane for lane, (vertex, axis) in enumerate(lanes)]
            start = builder.add(args[1], ir.Constant(args[1].type, LANES * part))
            stored(
                builder,
                shuffled(builder, pairs, args[4], picks),
                place(context, builder, sig.args[0], args[0], start),
            )
        return context.get_dummy_value()

    return types.void(array, types.int64, LANES_TYPE, LANES_TYPE, LANES_TYPE), code


@intrinsic
def columns(_typing: Any, array: Any, index: Any) -> Any:
    """columns(array, index): the columns of 16 rows of 16 floats, one row after the other."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        def quad(row: int, number: int) -> Any:
            start = builder.add(args[1], ir.Constant(args[1].type, LANES * row + 4 * number))
            return loaded(builder, place(context, builder, sig.args[0], args[0], start, QUAD))

        # quads of four rows are loaded side by side: only the rest of the transposition costs shuffles
        fours = [
            [_joined(builder, [quad(row + 4 * lane, number) for lane in range(4)]) for row in range(4)]
            for number in range(4)
        ]
        return cgutils.pack_array(builder, [column for four in fours for column in _exchanged(builder, four)])

    return types.UniTuple(LANES_TYPE, 16)(array, types.int64), code


def _joined(builder: Any, quads: Sequence[Any]) -> Any:
    """Four times four floats as sixteen."""
    while len(quads) > 1:
        width = 2 * quads[0].type.count
        picks = ir.Constant(ir.VectorType(INT32, width), list(range(width)))
        quads = [builder.shuffle_vector(a, b, picks) for a, b in zip(quads[::2], quads[1::2], strict=True)]
    return quads[0]


def _exchanged(builder: Any, rows: Sequence[Any]) -> list[Any]:
    """The transpose of each of the four 4 x 4 blocks that are side by side in four rows."""
    singles = [[0, 16, 1, 17], [2, 18, 3, 19]]
    pairs = [[0, 1, 16, 17], [2, 3, 18, 19]]

    def mixed(a: Any, b: Any, picks: Sequence[int]) -> Any:
        return shuffled(builder, a, b, [4 * block + pick for block in range(4) for pick in picks])

    upper = [mixed(rows[0], rows[1], picks) for picks in singles]
    lower = [mixed(rows[2], rows[3], picks) for picks in singles]
    return [mixed(a, b, picks) for a, b in zip(upper, lower, strict=True) for picks in pairs]
