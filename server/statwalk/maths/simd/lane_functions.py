"""Functions of sixteen numbers at a time, beyond + - * / (see `lanes`)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils

from statwalk.maths.compiling import intrinsic
from statwalk.maths.simd.lanes import INT32, LANES, LANES_TYPE, VECTOR


def _constant(value: float) -> ir.Constant:
    """The same number in all lanes."""
    return ir.Constant(VECTOR, [value] * LANES)


@intrinsic
def fused(_typing: Any, a: Any, b: Any, c: Any) -> Any:
    """fused(a, b, c): a·b + c, rounded once."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        function = cgutils.get_or_insert_function(
            builder.module, ir.FunctionType(VECTOR, [VECTOR] * 3), "llvm.fma.v16f32"
        )
        return builder.call(function, args)

    return LANES_TYPE(LANES_TYPE, LANES_TYPE, LANES_TYPE), code


def _of_one(build: Callable[[Any, Any], Any]) -> Any:
    """A function of one value."""

    def typed(_typing: Any, x: Any) -> Any:
        def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            return build(builder, args[0])

        return LANES_TYPE(LANES_TYPE), code

    return intrinsic(typed)


def _of_two(build: Callable[[Any, Any, Any], Any]) -> Any:
    """A function of two values."""

    def typed(_typing: Any, x: Any, y: Any) -> Any:
        def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            return build(builder, args[0], args[1])

        return LANES_TYPE(LANES_TYPE, LANES_TYPE), code

    return intrinsic(typed)


@_of_one
def root(builder: Any, x: Any) -> Any:
    """root(x): the square root, correctly rounded."""
    function = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(VECTOR, [VECTOR]), "llvm.sqrt.v16f32"
    )
    return builder.call(function, [x])


@_of_two
def least(builder: Any, x: Any, y: Any) -> Any:
    """least(x, y): the smaller, lane by lane."""
    return builder.select(builder.fcmp_ordered("<", x, y), x, y)


@_of_two
def most(builder: Any, x: Any, y: Any) -> Any:
    """most(x, y): the larger, lane by lane."""
    return builder.select(builder.fcmp_ordered(">", x, y), x, y)


@_of_two
def lowest_bits(builder: Any, x: Any, y: Any) -> Any:
    """lowest_bits(x, y): the smaller of numbers that are not negative; NaN counts as the largest."""
    numbers = ir.VectorType(INT32, LANES)
    return builder.select(
        builder.icmp_unsigned("<", builder.bitcast(x, numbers), builder.bitcast(y, numbers)), x, y
    )


@_of_two
def highest_bits(builder: Any, x: Any, y: Any) -> Any:
    """highest_bits(x, y): the larger of numbers that are not negative; NaN counts as the largest."""
    numbers = ir.VectorType(INT32, LANES)
    return builder.select(
        builder.icmp_unsigned(">", builder.bitcast(x, numbers), builder.bitcast(y, numbers)), x, y
    )


@_of_two
def turned(builder: Any, x: Any, sign: Any) -> Any:
    """turned(x, sign): -x in lanes with `sign` below 0, else x."""
    return builder.select(builder.fcmp_ordered("<", sign, _constant(0.0)), builder.fneg(x), x)


@intrinsic
def all_between(_typing: Any, x: Any, low: Any, high: Any) -> Any:
    """all_between(x, low, high): whether low < x < high in all lanes; false for NaN."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        inside = builder.and_(
            builder.fcmp_ordered(">", args[0], args[1]), builder.fcmp_ordered("<", args[0], args[2])
        )
        mask = ir.IntType(LANES)
        return builder.icmp_unsigned("==", builder.bitcast(inside, mask), ir.Constant(mask, (1 << LANES) - 1))

    return types.boolean(LANES_TYPE, LANES_TYPE, LANES_TYPE), code


@intrinsic
def any_above(_typing: Any, x: Any, low: Any) -> Any:
    """any_above(x, low): whether x > low in any lane."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        mask = ir.IntType(LANES)
        return builder.icmp_unsigned(
            "!=", builder.bitcast(builder.fcmp_ordered(">", *args), mask), ir.Constant(mask, 0)
        )

    return types.boolean(LANES_TYPE, LANES_TYPE), code


@_of_two
def with_sign(builder: Any, x: Any, sign: Any) -> Any:
    """with_sign(x, sign): the size of x with the sign of `sign`, -0 included."""
    function = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(VECTOR, [VECTOR] * 2), "llvm.copysign.v16f32"
    )
    return builder.call(function, [x, sign])


@_of_one
def size(builder: Any, x: Any) -> Any:
    """size(x): |x|."""
    function = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(VECTOR, [VECTOR]), "llvm.fabs.v16f32"
    )
    return builder.call(function, [x])


@intrinsic
def where_below(_typing: Any, a: Any, b: Any, x: Any, y: Any) -> Any:
    """where_below(a, b, x, y): x in lanes with a < b, else y, bit for bit."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return builder.select(builder.fcmp_ordered("<", args[0], args[1]), args[2], args[3])

    return LANES_TYPE(LANES_TYPE, LANES_TYPE, LANES_TYPE, LANES_TYPE), code


@intrinsic
def either(_typing: Any, mask: Any, x: Any, y: Any) -> Any:
    """either(mask, x, y): x in lanes with a mask above 0, else y, bit for bit."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return builder.select(builder.fcmp_ordered(">", args[0], _constant(0.0)), args[1], args[2])

    return LANES_TYPE(LANES_TYPE, LANES_TYPE, LANES_TYPE), code


@intrinsic
def with_lane(_typing: Any, lanes: Any, lane: Any, number: Any) -> Any:
    """with_lane(lanes, lane, number): the lanes with the number in one lane."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return builder.insert_element(args[0], args[2], builder.trunc(args[1], INT32))

    return LANES_TYPE(LANES_TYPE, types.int64, types.float32), code
