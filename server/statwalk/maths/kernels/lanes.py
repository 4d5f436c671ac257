"""Sixteen float32 numbers as one value inside compiled kernels: what numba's own vectoriser does not find is said outright.

A value is one register of AVX-512; on processors with narrower registers LLVM splits it. Arrays are flat and float32, indices count
floats. Kernels are the only users: outside of them these functions mean nothing.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.extending import models, register_model
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin

WIDTH = 16
VECTOR = ir.VectorType(ir.FloatType(), WIDTH)
QUAD = ir.VectorType(ir.FloatType(), 4)
INT32 = ir.IntType(32)


class Lanes(types.Type):
    """The type of the sixteen."""

    def __init__(self) -> None:
        super().__init__("lanes16")


LANES = Lanes()


@register_model(Lanes)
class LanesModel(models.PrimitiveModel):
    """In LLVM: <16 x float>."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, VECTOR)


def define_operator(symbol: Callable[..., Any], instruction: str) -> None:
    """Lets `symbol` work on two values, lane by lane."""

    @infer_global(symbol)
    class OfLanes(ConcreteTemplate):
        cases = [signature(LANES, LANES, LANES)]  # noqa: RUF012 - numba's form

    @lower_builtin(symbol, LANES, LANES)
    def lowered(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return getattr(builder, instruction)(*args)


@infer_global(operator.neg)
class Negated(ConcreteTemplate):
    """-x of sixteen."""

    cases = [signature(LANES, LANES)]  # noqa: RUF012 - numba's form


@lower_builtin(operator.neg, LANES)
def negated(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
    """-x, lane by lane."""
    return builder.fneg(args[0])


for symbol, instruction in ((operator.add, "fadd"), (operator.sub, "fsub"), (operator.mul, "fmul"), (operator.truediv, "fdiv")):
    define_operator(symbol, instruction)


def shuffled(builder: Any, a: Any, b: Any, picks: Sequence[int]) -> Any:
    """Lanes picked from `a` (0…15) and `b` (16…31)."""
    return builder.shuffle_vector(a, b, ir.Constant(ir.VectorType(INT32, WIDTH), list(picks)))


def place(context: Any, builder: Any, kind: Any, array: Any, index: Any, what: Any = VECTOR) -> Any:
    """The address of `what` at `index` of an array; negative indices do not count from the end, unlike elsewhere in numba."""
    data = context.make_array(kind)(context, builder, array).data
    return builder.bitcast(builder.gep(data, [index]), what.as_pointer())


def loaded(builder: Any, address: Any) -> Any:
    """What is at an address of any alignment."""
    value = builder.load(address)
    value.align = 4
    return value


def stored(builder: Any, value: Any, address: Any) -> None:
    """Puts the value at an address of any alignment."""
    builder.store(value, address).align = 4


@intrinsic
def load(_typing: Any, array: Any, index: Any) -> Any:
    """load(array, index): sixteen floats."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return loaded(builder, place(context, builder, sig.args[0], *args))

    return LANES(array, types.int64), code


def rows_from(context: Any, builder: Any, sig: Any, args: Any, count: int) -> list[Any]:
    """So many times sixteen floats, one after the other."""
    starts = [builder.add(args[1], ir.Constant(args[1].type, WIDTH * row)) for row in range(count)]
    return [loaded(builder, place(context, builder, sig.args[0], args[0], start)) for start in starts]


@intrinsic
def load_xyz(_typing: Any, array: Any, index: Any) -> Any:
    """load_xyz(array, index): x, y and z of 16 vectors, 48 floats."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        rows, found = rows_from(context, builder, sig, args, 3), []
        for axis in range(3):
            lanes = [3 * vector + axis for vector in range(WIDTH)]
            pairs = shuffled(builder, rows[0], rows[1], [lane % (2 * WIDTH) for lane in lanes])
            picks = [vector if lane < 2 * WIDTH else lane - WIDTH for vector, lane in enumerate(lanes)]
            found.append(shuffled(builder, pairs, rows[2], picks))
        return cgutils.pack_array(builder, found)

    return types.UniTuple(LANES, 3)(array, types.int64), code


@intrinsic
def load_quads(_typing: Any, array: Any, index: Any) -> Any:
    """load_quads(array, index): the four columns of 16 rows of four floats; the rows stand in another order, the same in all columns."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return cgutils.pack_array(builder, exchanged(builder, rows_from(context, builder, sig, args, 4)))

    return types.UniTuple(LANES, 4)(array, types.int64), code


@intrinsic
def store(_typing: Any, array: Any, index: Any, value: Any) -> Any:
    """store(array, index, value)."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        stored(builder, args[2], place(context, builder, sig.args[0], *args[:2]))
        return context.get_dummy_value()

    return types.void(array, types.int64, LANES), code


@intrinsic
def store_xyz(_typing: Any, array: Any, index: Any, x: Any, y: Any, z: Any) -> Any:
    """store_xyz(array, index, x, y, z): 48 floats, x y z of the first lane, then of the second, and so on."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        for part in range(3):
            lanes = [divmod(WIDTH * part + lane, 3) for lane in range(WIDTH)]
            pairs = shuffled(builder, args[2], args[3], [vertex + WIDTH * (axis == 1) for vertex, axis in lanes])
            picks = [WIDTH + vertex if axis == 2 else lane for lane, (vertex, axis) in enumerate(lanes)]
            start = builder.add(args[1], ir.Constant(args[1].type, WIDTH * part))
            stored(builder, shuffled(builder, pairs, args[4], picks), place(context, builder, sig.args[0], args[0], start))
        return context.get_dummy_value()

    return types.void(array, types.int64, LANES, LANES, LANES), code


@intrinsic
def columns(_typing: Any, array: Any, index: Any) -> Any:
    """columns(array, index): the first 12 columns of 16 rows of 16 floats, one row after the other."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        def quad(row: int, number: int) -> Any:
            start = builder.add(args[1], ir.Constant(args[1].type, WIDTH * row + 4 * number))
            return loaded(builder, place(context, builder, sig.args[0], args[0], start, QUAD))

        # four rows' quads side by side come from memory: only what then is left to exchange costs shuffles
        fours = [[joined(builder, [quad(row + 4 * lane, number) for lane in range(4)]) for row in range(4)] for number in range(3)]
        return cgutils.pack_array(builder, [column for four in fours for column in exchanged(builder, four)])

    return types.UniTuple(LANES, 12)(array, types.int64), code


def joined(builder: Any, quads: Sequence[Any]) -> Any:
    """Four times four floats as sixteen."""
    while len(quads) > 1:
        width = 2 * quads[0].type.count
        picks = ir.Constant(ir.VectorType(INT32, width), list(range(width)))
        quads = [builder.shuffle_vector(a, b, picks) for a, b in zip(quads[::2], quads[1::2], strict=True)]
    return quads[0]


def exchanged(builder: Any, rows: Sequence[Any]) -> list[Any]:
    """The transpose of each of the four 4 x 4 blocks that lie side by side in four rows."""
    singles = [[0, 16, 1, 17], [2, 18, 3, 19]]
    pairs = [[0, 1, 16, 17], [2, 3, 18, 19]]

    def mixed(a: Any, b: Any, picks: Sequence[int]) -> Any:
        return shuffled(builder, a, b, [4 * block + pick for block in range(4) for pick in picks])

    upper = [mixed(rows[0], rows[1], picks) for picks in singles]
    lower = [mixed(rows[2], rows[3], picks) for picks in singles]
    return [mixed(a, b, picks) for a, b in zip(upper, lower, strict=True) for picks in pairs]


def repeated(builder: Any, number: Any) -> Any:
    """One number in all lanes."""
    nothing = ir.Constant(VECTOR, ir.Undefined)
    return shuffled(builder, builder.insert_element(nothing, number, ir.Constant(INT32, 0)), nothing, [0] * WIDTH)


@intrinsic
def broadcast(_typing: Any, number: Any) -> Any:
    """broadcast(number): the number in all lanes."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return repeated(builder, args[0])

    return LANES(types.float32), code


@intrinsic
def spread(_typing: Any, array: Any, index: Any) -> Any:
    """spread(array, index): one number of an array in all lanes."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        return repeated(builder, loaded(builder, place(context, builder, sig.args[0], args[0], args[1], ir.FloatType())))

    return LANES(array, types.int64), code


@intrinsic
def load_at(_typing: Any, array: Any, indices: Any, index: Any) -> Any:
    """load_at(array, indices, index): sixteen floats from where an int32 of another array says."""

    def code(context: Any, builder: Any, sig: Any, args: Any) -> Any:
        found = loaded(builder, place(context, builder, sig.args[1], args[1], args[2], INT32))
        start = builder.sext(found, args[2].type)
        return loaded(builder, place(context, builder, sig.args[0], args[0], start))

    return LANES(array, indices, types.int64), code
