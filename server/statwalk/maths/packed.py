"""Named tuples of arrays as one argument of a kernel: addresses, shapes and strides of the arrays, as kernels
read them.

Passing a hundred arrays one by one costs tens of microseconds at each call, and seconds of compilation. They
are packed once, and a kernel opens them:

    program = packed(machine.program, PROGRAM)

    open_program = opened(PROGRAM)

    @kernel(ADDRESSES, LONG)
    def step(p, row):
        program = open_program(p)           # a reference, with the fields of the named tuple
"""

from __future__ import annotations

from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np
from numba import types
from numba.extending import intrinsic
from numba.np.numpy_support import as_dtype
from numpy.typing import NDArray

from statwalk.maths.compiling import IS_COMPILED
from statwalk.maths.reference import Reference

Values = TypeVar("Values", bound=tuple[Any, ...])
ADDRESSES = types.Array(types.int64, 1, "C")
"""the numba type of a packed named tuple"""


class PackedColumns(Generic[Values]):
    """A named tuple of arrays, and the kernel argument for it; it keeps the arrays alive."""

    __slots__ = ("argument", "values")

    def __init__(self, values: Values, argument: NDArray[np.int64] | Values) -> None:
        self.values, self.argument = values, argument


def packed(values: Values, kind: Any) -> PackedColumns[Values]:
    """Packs a named tuple whose numba type is `kind`.

    :raises TypeError: when an array has another dtype or number of axes, is not contiguous, or is read-only
        though kernels write it.
    """
    numbers = np.array(_numbers(values, kind), np.int64)
    return PackedColumns(values, numbers if IS_COMPILED else values)


def opened(kind: Any) -> Any:
    """Returns the function with which a kernel opens a packed named tuple of that numba type."""
    if not IS_COMPILED:
        return _itself

    @intrinsic
    def open_(_context: Any, addresses: Any) -> Any:
        def put(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            array = context.make_array(signature.args[0])(context, builder, arguments[0])
            return builder.bitcast(array.data, context.get_value_type(kind).as_pointer())

        return Reference(kind)(addresses), put

    return open_


def _itself(values: Any) -> Any:
    return values


def _numbers(values: Any, kind: Any) -> list[int]:
    """The numbers of numba's struct for each array: two unused pointers, size, item size, address, shape,
    strides.
    """
    numbers: list[int] = []
    for name, value, field in zip(values._fields, values, _fields_of(kind), strict=True):
        if field.nested is not None:
            numbers += _numbers(value, field.nested)
            continue
        if problem := _problem(value, field):
            raise TypeError(f"{type(values).__name__}.{name} is {problem} {field.kind}")
        address = value.__array_interface__["data"][0]
        numbers += (0, 0, value.size, value.itemsize, address, *value.shape, *value.strides)
    return numbers


def _problem(array: NDArray[Any], field: _Field) -> str:
    """Why kernels cannot take an array; empty if they can."""
    if array.dtype != field.dtype or array.ndim != field.axes:
        return f"{array.dtype} with {array.ndim} axes, not"
    flags = array.flags
    if not (flags.c_contiguous and flags.aligned) or (field.is_written and not flags.writeable):
        return "not contiguous and aligned, or locked, where kernels take"
    return ""


class _Field(NamedTuple):
    """The required type of an array in a named tuple; `nested` for a named tuple in a named tuple."""

    kind: Any
    nested: Any
    dtype: Any
    axes: int
    is_written: bool


_FIELDS: dict[int, tuple[_Field, ...]] = {}


def _fields_of(kind: Any) -> tuple[_Field, ...]:
    """The fields of a numba type, cached by numba's number of the type."""
    fields = _FIELDS.get(kind._code)
    if fields is None:
        fields = _FIELDS[kind._code] = tuple(_field(field) for field in kind.types)
    return fields


def _field(kind: Any) -> _Field:
    if isinstance(kind, types.BaseTuple):
        return _Field(kind, kind, None, 0, False)
    return _Field(kind, None, as_dtype(kind.dtype), kind.ndim, kind.mutable)
