"""Sixteen float32 numbers as one value inside compiled kernels, for loops that numba's own vectoriser does
not vectorise.

A value is one register of AVX-512; on processors with narrower registers LLVM splits it. Arrays are flat and
float32, indices count floats. These functions work inside kernels only.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Any

from llvmlite import ir
from numba import types
from numba.core.extending import models, register_model
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import lower_builtin

from statwalk.maths.compiling import intrinsic

LANES = 16
"""float32 numbers of a value; also the actors of a block of poses (`pose_layout`)"""
VECTOR = ir.VectorType(ir.FloatType(), LANES)
INT32 = ir.IntType(32)


class LanesType(types.Type):
    """The numba type of sixteen float32 numbers."""

    def __init__(self) -> None:
        super().__init__("lanes16")


LANES_TYPE = LanesType()


@register_model(LanesType)
class LanesModel(models.PrimitiveModel):
    """The LLVM type: <16 x float>."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, VECTOR)


def _define_operator(symbol: Callable[..., Any], instruction: str) -> None:
    """Defines `symbol` for two values, lane by lane."""

    @infer_global(symbol)
    class OfLanes(ConcreteTemplate):
        cases = [signature(LANES_TYPE, LANES_TYPE, LANES_TYPE)]  # noqa: RUF012 - numba's form

    @lower_builtin(symbol, LANES_TYPE, LANES_TYPE)
    def lowered(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return getattr(builder, instruction)(*args)


@infer_global(operator.neg)
class Negated(ConcreteTemplate):
    """The type of -x."""

    cases = [signature(LANES_TYPE, LANES_TYPE)]  # noqa: RUF012 - numba's form


@lower_builtin(operator.neg, LANES_TYPE)
def negated(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
    """Returns -x, lane by lane."""
    return builder.fneg(args[0])


for symbol, instruction in (
    (operator.add, "fadd"),
    (operator.sub, "fsub"),
    (operator.mul, "fmul"),
    (operator.truediv, "fdiv"),
):
    _define_operator(symbol, instruction)


def shuffled(builder: Any, a: Any, b: Any, picks: Sequence[int]) -> Any:
    """Returns lanes picked from `a` (0…15) and `b` (16…31)."""
    return builder.shuffle_vector(a, b, ir.Constant(ir.VectorType(INT32, LANES), list(picks)))


def place(context: Any, builder: Any, kind: Any, array: Any, index: Any, what: Any = VECTOR) -> Any:
    """Returns the address of a `what` at `index` of an array; negative indices do not count from the end,
    unlike elsewhere in numba.
    """
    data = context.make_array(kind)(context, builder, array).data
    return builder.bitcast(builder.gep(data, [index]), what.as_pointer())


def loaded(builder: Any, address: Any) -> Any:
    """Returns the value at an address of any alignment."""
    value = builder.load(address)
    value.align = 4
    return value


def stored(builder: Any, value: Any, address: Any) -> None:
    """Writes the value to an address of any alignment."""
    builder.store(value, address).align = 4


@intrinsic
def load(_typing: Any, array: Any, index: Any) -> Any:
    """load(array, index): sixteen floats."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return loaded(builder, place(context, builder, sig.args[0], *args))

    return LANES_TYPE(array, types.int64), code


@intrinsic
def store(_typing: Any, array: Any, index: Any, value: Any) -> Any:
    """store(array, index, value)."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        stored(builder, args[2], place(context, builder, sig.args[0], *args[:2]))
        return context.get_dummy_value()

    return types.void(array, types.int64, LANES_TYPE), code


def _repeated(builder: Any, number: Any) -> Any:
    """One number in all lanes."""
    nothing = ir.Constant(VECTOR, ir.Undefined)
    return shuffled(
        builder, builder.insert_element(nothing, number, ir.Constant(INT32, 0)), nothing, [0] * LANES
    )


@intrinsic
def broadcast(_typing: Any, number: Any) -> Any:
    """broadcast(number): the number in all lanes."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return _repeated(builder, args[0])

    return LANES_TYPE(types.float32), code


@intrinsic
def spread(_typing: Any, array: Any, index: Any) -> Any:
    """spread(array, index): one number of an array in all lanes."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return _repeated(
            builder, loaded(builder, place(context, builder, sig.args[0], args[0], args[1], ir.FloatType()))
        )

    return LANES_TYPE(array, types.int64), code


@intrinsic
def load_at(_typing: Any, array: Any, indices: Any, index: Any) -> Any:
    """load_at(array, indices, index): sixteen floats from the position that an int32 of another
    array gives.
    """

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        position = loaded(builder, place(context, builder, sig.args[1], args[1], args[2], INT32))
        start = builder.sext(position, args[2].type)
        return loaded(builder, place(context, builder, sig.args[0], args[0], start))

    return LANES_TYPE(array, indices, types.int64), code
