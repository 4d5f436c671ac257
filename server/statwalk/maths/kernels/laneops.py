"""What kernels do with sixteen numbers at a time beyond + - * / (see `lanes`)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

from statwalk.maths.kernels.lanes import INT32, LANES, VECTOR, WIDTH


def constant(value: float) -> ir.Constant:
    """The same number in all lanes."""
    return ir.Constant(VECTOR, [value] * WIDTH)


@intrinsic
def fused(_typing: Any, a: Any, b: Any, c: Any) -> Any:
    """fused(a, b, c): a·b + c, rounded once."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        function = cgutils.get_or_insert_function(builder.module, ir.FunctionType(VECTOR, [VECTOR] * 3), "llvm.fma.v16f32")
        return builder.call(function, args)

    return LANES(LANES, LANES, LANES), code


def of_one(build: Callable[[Any, Any], Any]) -> Any:
    """A function of one value."""

    def typed(_typing: Any, x: Any) -> Any:
        def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            return build(builder, args[0])

        return LANES(LANES), code

    return intrinsic(typed)


def of_two(build: Callable[[Any, Any, Any], Any]) -> Any:
    """A function of two values."""

    def typed(_typing: Any, x: Any, y: Any) -> Any:
        def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            return build(builder, args[0], args[1])

        return LANES(LANES, LANES), code

    return intrinsic(typed)


@of_one
def root(builder: Any, x: Any) -> Any:
    """root(x): the square root, correctly rounded."""
    function = cgutils.get_or_insert_function(builder.module, ir.FunctionType(VECTOR, [VECTOR]), "llvm.sqrt.v16f32")
    return builder.call(function, [x])


@of_two
def least(builder: Any, x: Any, y: Any) -> Any:
    """least(x, y): the smaller, lane by lane."""
    return builder.select(builder.fcmp_ordered("<", x, y), x, y)


@of_two
def most(builder: Any, x: Any, y: Any) -> Any:
    """most(x, y): the larger, lane by lane."""
    return builder.select(builder.fcmp_ordered(">", x, y), x, y)


@of_two
def lowest_bits(builder: Any, x: Any, y: Any) -> Any:
    """lowest_bits(x, y): the smaller for numbers that are not negative; what is not a number counts as the largest."""
    numbers = ir.VectorType(INT32, WIDTH)
    return builder.select(builder.icmp_unsigned("<", builder.bitcast(x, numbers), builder.bitcast(y, numbers)), x, y)


@of_two
def highest_bits(builder: Any, x: Any, y: Any) -> Any:
    """highest_bits(x, y): the larger for numbers that are not negative; what is not a number counts as the largest."""
    numbers = ir.VectorType(INT32, WIDTH)
    return builder.select(builder.icmp_unsigned(">", builder.bitcast(x, numbers), builder.bitcast(y, numbers)), x, y)


@of_two
def turned(builder: Any, x: Any, sign: Any) -> Any:
    """turned(x, sign): -x where `sign` is below 0, else x."""
    return builder.select(builder.fcmp_ordered("<", sign, constant(0.0)), builder.fneg(x), x)


@intrinsic
def all_between(_typing: Any, x: Any, low: Any, high: Any) -> Any:
    """all_between(x, low, high): whether low < x < high in all lanes; no for what is not a number."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        inside = builder.and_(builder.fcmp_ordered(">", args[0], args[1]), builder.fcmp_ordered("<", args[0], args[2]))
        mask = ir.IntType(WIDTH)
        return builder.icmp_unsigned("==", builder.bitcast(inside, mask), ir.Constant(mask, (1 << WIDTH) - 1))

    return types.boolean(LANES, LANES, LANES), code


@intrinsic
def any_above(_typing: Any, x: Any, low: Any) -> Any:
    """any_above(x, low): whether x > low in any lane."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        mask = ir.IntType(WIDTH)
        return builder.icmp_unsigned("!=", builder.bitcast(builder.fcmp_ordered(">", *args), mask), ir.Constant(mask, 0))

    return types.boolean(LANES, LANES), code
