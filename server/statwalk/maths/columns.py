"""NamedTuples of arrays, which kernels take as arguments (a Program, the motions of a role, the state of a
cast): their types are declared once, in the class.

    class Motions(NamedTuple):
        duration: Annotated[NDArray[np.float64], "state"]
        first_key: Annotated[NDArray[np.int32], "state, channel"]
        count: int

The text names the axes; the number of names is the number of axes. `Motions` then has two numba types:
`columns(Motions, readonly=True)` for constant tables, `columns(Motions)` for state that kernels write.
`locked` and `writable` make arrays, and NamedTuples of arrays, of these types: of the declared dtype,
contiguous, aligned to a cache line.

    @kernel(columns(Motions, readonly=True), columns(State), LONG)
    def step(motions, state, row): ...

    step(locked(motions), writable(state), 0)
"""

from __future__ import annotations

from functools import cache
from typing import Annotated, Any, NamedTuple, TypeVar, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.simd.aligned import of

Values = TypeVar("Values", bound=tuple[Any, ...] | NDArray[Any])
SCALARS = {int: np.dtype(np.int64), float: np.dtype(np.float64), bool: np.dtype(np.bool_)}


class Column(NamedTuple):
    """The declared type of one field; a number if `axes` is 0."""

    dtype: np.dtype[Any]
    axes: int


@cache
def _declared(kind: type[tuple[Any, ...]]) -> dict[str, Column | type[tuple[Any, ...]]]:
    """The fields of a NamedTuple class: an array, a number, or another NamedTuple class."""
    hints = get_type_hints(kind, include_extras=True)
    return {name: _column(hints[name], f"{kind.__name__}.{name}") for name in kind._fields}  # type: ignore[attr-defined]


def columns(kind: type[tuple[Any, ...]], readonly: bool = False) -> Any:
    """Returns the numba type of a NamedTuple class whose arrays are all contiguous: all read-only if
    `readonly`, else all writable.

    :raises TypeError: when a field is annotated as neither an array, a number nor a NamedTuple.
    """
    from numba import from_dtype, types

    field_types = []
    for column in _declared(kind).values():
        if not isinstance(column, Column):
            field_types.append(columns(column, readonly))
        elif column.axes:
            field_types.append(types.Array(from_dtype(column.dtype), column.axes, "C", readonly=readonly))
        else:
            field_types.append(from_dtype(column.dtype))
    return types.BaseTuple.from_types(field_types, kind)  # a separate class if all fields have one type


def locked(values: Values) -> Values:
    """Returns the array, or NamedTuple of arrays, as read-only copies.

    :raises ValueError: when an array has another number of axes than its class declares.
    """
    fitted: Values = _fitted(values, lock=True)
    return fitted


def writable(values: Values) -> Values:
    """Returns the array, or NamedTuple of arrays, as copies that kernels may write.

    :raises ValueError: when an array has another number of axes than its class declares.
    """
    fitted: Values = _fitted(values, lock=False)
    return fitted


def lock_fields(record: Any) -> None:
    """Replaces the arrays of a frozen dataclass, also in its NamedTuples, by read-only copies; for its
    `__post_init__`.
    """
    for name, value in vars(record).items():
        if isinstance(value, np.ndarray):
            object.__setattr__(record, name, locked(value))
        elif isinstance(value, tuple) and hasattr(value, "_fields"):
            object.__setattr__(record, name, type(value)(*(locked(array) for array in value)))


def _fitted(values: Any, lock: bool) -> Any:
    if isinstance(values, np.ndarray):
        return _array(values, values.dtype, lock)
    kind: Any = type(values)
    pairs = zip(_declared(kind).items(), values, strict=True)
    return kind._make(
        _field(f"{kind.__name__}.{name}", column, value, lock) for (name, column), value in pairs
    )


def _field(name: str, column: Any, value: Any, lock: bool) -> Any:
    if not isinstance(column, Column):
        return _fitted(value, lock)
    if not column.axes:
        return column.dtype.type(value).item()
    if np.ndim(value) != column.axes:
        raise ValueError(f"{name} has {np.ndim(value)} axes, not {column.axes}")
    return _array(value, column.dtype, lock)


def _array(value: Any, dtype: np.dtype[Any], lock: bool) -> NDArray[Any]:
    array = of(value, dtype)
    array.flags.writeable = not lock
    return array


def _column(hint: Any, name: str) -> Column | type[tuple[Any, ...]]:
    if hint in SCALARS:
        return Column(SCALARS[hint], 0)
    if isinstance(hint, type) and issubclass(hint, tuple) and hasattr(hint, "_fields"):
        return hint
    if get_origin(hint) is Annotated and len(get_args(hint)) == 2:
        array, axes = get_args(hint)
        if get_origin(array) is np.ndarray and isinstance(axes, str):
            return Column(np.dtype(get_args(get_args(array)[1])[0]), len(axes.split(",")))
    raise TypeError(f'{name} is {hint}, not Annotated[NDArray[kind], "axis, axis"], a number or a NamedTuple')
