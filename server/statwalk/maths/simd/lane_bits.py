"""The bits of numbers inside compiled kernels, as whole numbers: of arrays of any type, and of
sixteen lanes.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils

from statwalk.maths.compiling import intrinsic
from statwalk.maths.simd.lanes import INT32, LANES, LANES_TYPE, VECTOR

WORDS = ir.VectorType(INT32, LANES)
INT64 = ir.IntType(64)


@intrinsic
def word_at(_typing: Any, array: Any, index: Any) -> Any:
    """word_at(array, index): the bits of the number at a flat index of an array of any shape and type, as
    uint64.
    """

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        kind = sig.args[0]
        value = builder.load(builder.gep(context.make_array(kind)(context, builder, args[0]).data, [args[1]]))
        if isinstance(kind.dtype, types.Float):
            value = builder.bitcast(value, ir.IntType(kind.dtype.bitwidth))
        signed = getattr(kind.dtype, "signed", False)
        return value if value.type == INT64 else (builder.sext if signed else builder.zext)(value, INT64)

    return types.uint64(array, types.int64), code


@intrinsic
def with_word(_typing: Any, lanes: Any, lane: Any, word: Any) -> Any:
    """with_word(lanes, lane, word): the lanes with the low 32 bits of a word in one lane."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        words = builder.bitcast(args[0], WORDS)
        return builder.bitcast(
            builder.insert_element(words, builder.trunc(args[2], INT32), builder.trunc(args[1], INT32)),
            VECTOR,
        )

    return LANES_TYPE(LANES_TYPE, types.int64, types.uint64), code


@intrinsic
def word_of(_typing: Any, lanes: Any, lane: Any) -> Any:
    """word_of(lanes, lane): the bits of a lane, as uint64."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        word = builder.extract_element(builder.bitcast(args[0], WORDS), builder.trunc(args[1], INT32))
        return builder.zext(word, INT64)

    return types.uint64(LANES_TYPE, types.int64), code


def stirring(rotation: int, factor: int) -> Any:
    """Returns a step of the hash of sixteen lanes: hash xor value, rotated, times an odd factor."""

    def typed(_typing: Any, before: Any, value: Any) -> Any:
        def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            mixed = builder.xor(*(builder.bitcast(lanes, WORDS) for lanes in args))
            name = f"llvm.fshl.v{LANES}i32"
            rotate = cgutils.get_or_insert_function(builder.module, ir.FunctionType(WORDS, [WORDS] * 3), name)
            turned = builder.call(rotate, [mixed, mixed, ir.Constant(WORDS, [rotation] * LANES)])
            return builder.bitcast(builder.mul(turned, ir.Constant(WORDS, [factor] * LANES)), VECTOR)

        return LANES_TYPE(LANES_TYPE, LANES_TYPE), code

    return intrinsic(typed)


@intrinsic
def natural(_typing: Any, number: Any) -> Any:
    """natural(number): the number, which is not negative: as an index it cannot count from the end, and the
    compiler leaves out the code for that.
    """

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        whole = context.cast(builder, args[0], sig.args[0], types.int64)
        return builder.and_(whole, ir.Constant(INT64, (1 << 63) - 1))

    return types.int64(number), code
