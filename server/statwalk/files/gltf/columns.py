"""Reads one field of many glTF objects as a column: a few array operations check hundreds of accessors.

A column holds BROKEN for every value that is not valid; the functions of `check` then read the field again
and report what is wrong.
"""

from __future__ import annotations

import marshal
from collections.abc import Iterable, Sequence
from itertools import chain, repeat
from operator import contains, itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.files.gltf.check import LARGEST as LARGEST_NUMBER
from statwalk.files.gltf.check import Json

BROKEN = -1
LARGEST = 1 << 40
"""limit of counts and offsets in a column: their products with two small numbers still fit 64 bits"""

WRITTEN, HEAD = np.dtype([("kind", "S1"), ("value", "<i4")]), 5
"""`marshal`'s format of an int that fits 32 bits, and the bytes of a list before its first member"""

Column = NDArray[np.int64]


def whole_numbers(entries: Sequence[Json], key: str, default: int = BROKEN) -> Column:
    """Returns the field of every object (N,), at most LARGEST; the default if it is missing, BROKEN (below 0)
    if it is no whole number.
    """
    values = field(entries, key, default)
    small = _small_numbers(values)
    if small is not None:
        return small
    values = [value if type(value) is int else BROKEN for value in values]
    try:
        return np.minimum(np.array(values, np.int64), LARGEST)
    except OverflowError:
        return np.array([min(max(value, BROKEN), LARGEST) for value in values], np.int64)


def _small_numbers(values: list[Any]) -> Column | None:
    """Returns the values if all of them are ints (not bools) of up to 31 bits, otherwise None.

    `marshal` writes the type before each value: one pass instead of two.
    """
    try:
        data = marshal.dumps(values, 2)
    except ValueError:  # `marshal` refuses deeply nested values
        return None
    if len(data) != HEAD + WRITTEN.itemsize * len(values):
        return None
    written = np.frombuffer(data, WRITTEN, len(values), HEAD)
    return written["value"].astype(np.int64) if (written["kind"] == b"i").all() else None


def codes(entries: Sequence[Json], key: str, code_of: Codes, default: str | None = None) -> Column:
    """Returns the code of every object's field (N,), a string; BROKEN if the string has no code."""
    values = field(entries, key, default)
    try:
        return np.fromiter(map(code_of.__getitem__, values), np.int64, len(values))
    except TypeError:  # lists and objects cannot be looked up
        return np.array([code_of[value] if type(value) is str else BROKEN for value in values], np.int64)


class Codes(dict[str, int]):
    """A code for each name, counted from 0; BROKEN for all other names."""

    def __init__(self, names: Iterable[str]) -> None:
        super().__init__((name, row) for row, name in enumerate(names))

    def __missing__(self, name: str) -> int:
        return BROKEN


def vectors(entries: Sequence[Json], key: str, default: list[float]) -> NDArray[np.float64] | None:
    """Returns the field of every object (N,n), a list of as many numbers as the default has; None if a field
    is anything else, or a number is beyond 1e24.
    """
    values = field(entries, key, default)
    if not all_of(values, list) or not set(map(len, values)) <= {len(default)}:
        return None
    flat = list(chain.from_iterable(values))
    if not set(map(type, flat)) <= {int, float}:
        return None
    numbers = np.array(flat, np.float64)
    return numbers.reshape(-1, len(default)) if np.abs(numbers).max(initial=0) <= LARGEST_NUMBER else None


def lists_of_indices(entries: Sequence[Json], key: str, end: int) -> list[list[int]] | None:
    """Returns the field of every object, a list of indices below `end`, empty if it is missing; None if a
    field is anything else.
    """
    values = [entry.get(key, []) for entry in entries]
    flat = list(chain.from_iterable(values)) if all_of(values, list) else [BROKEN]
    return values if not flat or (all_of(flat, int) and min(flat) >= 0 and max(flat) < end) else None


def field(entries: Sequence[Json], key: str, default: object) -> list[Any]:
    """Returns the field of every object, the default if it is missing."""
    try:
        return list(map(itemgetter(key), entries))
    except KeyError:
        return [entry.get(key, default) for entry in entries]


def named(entries: Sequence[Json], key: str) -> NDArray[np.bool_]:
    """Returns which objects have the field (N,)."""
    if not any(map(contains, entries, repeat(key))):
        return np.zeros(len(entries), bool)
    return np.array([key in entry for entry in entries])


def all_of(values: Sequence[Any], kind: type) -> bool:
    """Returns whether all values are of one type; a bool does not count as an int."""
    return set(map(type, values)) <= {kind}
