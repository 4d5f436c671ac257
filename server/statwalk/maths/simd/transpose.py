"""Transposes sixteen rows of numbers: poses of sixteen actors, each in its own row, are put side by side."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types

from statwalk.maths.compiling import intrinsic
from statwalk.maths.simd.lanes import INT32, LANES, VECTOR, loaded, place, shuffled, stored


def _transposed(builder: Any, rows: list[Any]) -> list[Any]:
    """Sixteen rows of sixteen, exchanged at distances 8, 4, 2, 1."""
    for distance in (8, 4, 2, 1):
        low = [k if not k & distance else LANES + (k ^ distance) for k in range(LANES)]
        high = [k | distance if not k & distance else LANES + k for k in range(LANES)]
        for row in range(LANES):
            if not row & distance:
                pair = rows[row], rows[row | distance]
                rows[row], rows[row | distance] = (
                    shuffled(builder, *pair, low),
                    shuffled(builder, *pair, high),
                )
    return rows


@intrinsic
def store_columns(
    _typing: Any, out: Any, base: Any, places: Any, first: Any, rows: Any, at: Any, stride: Any
) -> Any:
    """store_columns(out, base, places, first, rows, at, stride): the k-th of sixteen columns goes to out[base
    + places[first + k]].

    The rows of sixteen float32 start at `at` of `rows`, `stride` from each other; `places` are int32.
    """

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        out, base, places, first, rows, at, stride = args

        def number(kind: Any, value: Any) -> Any:
            return ir.Constant(kind.type, value)

        starts = [builder.add(at, builder.mul(stride, number(stride, row))) for row in range(LANES)]
        loaded_rows = [loaded(builder, place(context, builder, sig.args[4], rows, start)) for start in starts]
        for k, column in enumerate(_transposed(builder, loaded_rows)):
            index = place(context, builder, sig.args[2], places, builder.add(first, number(first, k)), INT32)
            target = builder.add(base, builder.sext(loaded(builder, index), base.type))
            stored(builder, column, place(context, builder, sig.args[0], out, target))
        return context.get_dummy_value()

    return types.void(out, types.int64, places, types.int64, rows, types.int64, types.int64), code


@intrinsic
def chosen(_typing: Any, test: Any, x: Any, y: Any) -> Any:
    """chosen(test, x, y): x in the lanes whose `test` is not 0, else y."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return builder.select(
            builder.fcmp_ordered("!=", args[0], ir.Constant(VECTOR, [0.0] * LANES)), args[1], args[2]
        )

    return test(test, x, y), code
