"""One field of many glTF objects at once, as a column: hundreds of accessors are checked by a few array operations.

A column only tells what is plain. Where it says BROKEN somebody looks again, field by field (`check`), and says what is wrong.
"""

from __future__ import annotations

import marshal
from collections.abc import Iterable, Sequence
from itertools import chain, repeat
from operator import contains, itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.files.glb.check import LARGEST as LARGEST_NUMBER
from statwalk.files.glb.check import Json

BROKEN = -1
LARGEST = 1 << 40
"""of any count or offset in a column: products of two small numbers with it still fit 64 bits"""

WRITTEN, HEAD = np.dtype([("kind", "S1"), ("value", "<i4")]), 5
"""how `marshal` writes an int that fits 32 bits, and the bytes of a list before its first member"""

Column = NDArray[np.int64]


def whole_numbers(entries: Sequence[Json], key: str, default: int = BROKEN) -> Column:
    """The field of every object (N,), at most LARGEST; the default where it is missing, BROKEN (below 0) where it is no whole number."""
    values = field(entries, key, default)
    small = small_numbers(values)
    if small is not None:
        return small
    values = [value if type(value) is int else BROKEN for value in values]
    try:
        return np.minimum(np.array(values, np.int64), LARGEST)
    except OverflowError:
        return np.array([min(max(value, BROKEN), LARGEST) for value in values], np.int64)


def small_numbers(values: list[Any]) -> Column | None:
    """The values where all are ints (bool is none) of up to 31 bits. `marshal` writes what each is before it: one pass instead of two."""
    try:
        text = marshal.dumps(values, 2)
    except ValueError:  # something nested too deeply to be a number
        return None
    if len(text) != HEAD + WRITTEN.itemsize * len(values):
        return None
    written = np.frombuffer(text, WRITTEN, len(values), HEAD)
    return written["value"].astype(np.int64) if (written["kind"] == b"i").all() else None


def codes(entries: Sequence[Json], key: str, known: Codes, default: str | None = None) -> Column:
    """The field of every object (N,), a string, by its code; BROKEN where it is none of those known."""
    values = field(entries, key, default)
    try:
        return np.fromiter(map(known.__getitem__, values), np.int64, len(values))
    except TypeError:  # lists and objects cannot be looked up
        return np.array([known[value] if type(value) is str else BROKEN for value in values], np.int64)


class Codes(dict[str, int]):
    """A code for each name, counted from 0; BROKEN for all others."""

    def __init__(self, names: Iterable[str]) -> None:
        super().__init__((name, row) for row, name in enumerate(names))

    def __missing__(self, name: str) -> int:
        return BROKEN


def vectors(entries: Sequence[Json], key: str, default: list[float]) -> NDArray[np.float64] | None:
    """The field of every object, a list of as many numbers as the default has (N,n); None where one is anything else, or beyond 1e24."""
    values = field(entries, key, default)
    if not all_of(values, list) or not set(map(len, values)) <= {len(default)}:
        return None
    flat = list(chain.from_iterable(values))
    if not set(map(type, flat)) <= {int, float}:
        return None
    numbers = np.array(flat, np.float64)
    return numbers.reshape(-1, len(default)) if np.abs(numbers).max(initial=0) <= LARGEST_NUMBER else None


def lists_of_indices(entries: Sequence[Json], key: str, end: int) -> list[list[int]] | None:
    """The field of every object, a list of indices below `end`, empty where it is missing; None where one is anything else."""
    values = [entry.get(key, []) for entry in entries]
    flat = list(chain.from_iterable(values)) if all_of(values, list) else [BROKEN]
    return values if not flat or (all_of(flat, int) and min(flat) >= 0 and max(flat) < end) else None


def field(entries: Sequence[Json], key: str, default: object) -> list[Any]:
    """The field of every object, the default where it is missing."""
    try:
        return list(map(itemgetter(key), entries))
    except KeyError:
        return [entry.get(key, default) for entry in entries]


def named(entries: Sequence[Json], key: str) -> NDArray[np.bool_]:
    """Which objects have the field (N,)."""
    if not any(map(contains, entries, repeat(key))):
        return np.zeros(len(entries), bool)
    return np.array([key in entry for entry in entries])


def all_of(values: Sequence[Any], kind: type) -> bool:
    """Whether all are of one type (bool is no int here)."""
    return set(map(type, values)) <= {kind}
