"""A running 64-bit hash of every actor's state, in exact integer arithmetic: an actor has the same hash alone
and in a crowd.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.random import GOLDEN, WORD, Words, odd_factors, splitmix64


def mix(before: Words, arrays: Iterable[NDArray[Any]]) -> Words:
    """Returns (N,) the hashes that follow from the hashes before and from the bits of arrays with a leading
    axis of N actors.
    """
    words = np.concatenate([_words(array) for array in arrays if array.size], -1)
    placed = words * odd_factors(words.shape[1])  # the place of a word in the state matters
    hashes: Words = splitmix64(splitmix64(before) + placed.sum(-1, dtype=np.uint64))
    return hashes


def _words(array: NDArray[Any]) -> Words:
    """The bits of `array` (N, …) as words (N, K)."""
    flat = np.ascontiguousarray(array).reshape(len(array), -1)
    if flat.dtype.kind == "f":
        return flat.view(f"u{flat.dtype.itemsize}").astype(np.uint64)
    return flat.astype(np.int64).view(np.uint64)


def combine(hashes: Iterable[int]) -> int:
    """Returns one hash of many hashes, in their order."""
    total = 0
    for value in hashes:
        total = ((total ^ value) * GOLDEN + 1) & WORD
        total ^= total >> 29
    return total


def text(value: int) -> str:
    """Returns a hash as people and files see it: 16 hexadecimal digits."""
    return f"{value:016x}"
