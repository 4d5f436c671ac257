"""One field of many glTF objects at once, as a column: hundreds of accessors are checked by a few array operations.

A column only tells what is plain. Where it says BROKEN somebody looks again, field by field (`check`), and says what is wrong.
"""

from __future__ import annotations

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

Column = NDArray[np.int64]


def whole_numbers(entries: Sequence[Json], key: str, default: int = BROKEN) -> Column:
    """The field of every object (N,), at most LARGEST; the default where it is missing, BROKEN (below 0) where it is no whole number."""
    values = field(entries, key, default)
    if not all_of(values, int):
        values = [value if type(value) is int else BROKEN for value in values]
    try:
        return np.minimum(np.array(values, np.int64), LARGEST)
    except OverflowError:
        return np.array([min(max(value, BROKEN), LARGEST) for value in values], np.int64)


def codes(entries: Sequence[Json], key: str, known: Codes, default: str | None = None) -> Column:
    """The field of every object (N,), a string, by its code; BROKEN where it is none of those known."""
    values = field(entries, key, default)
    if not all_of(values, str):
        values = [value if type(value) is str else "" for value in values]
    return np.array(list(map(known.__getitem__, values)), np.int64)


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
    if not set(map(type, flat)) <= {int, float} or (flat and not -LARGEST_NUMBER <= min(flat) <= max(flat) <= LARGEST_NUMBER):
        return None
    return np.array(flat, np.float64).reshape(-1, len(default))


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
