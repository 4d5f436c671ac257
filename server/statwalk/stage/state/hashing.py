"""A running 64-bit hash of every actor's state, in exact integer arithmetic: an actor has the same hash alone
and in a crowd.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

Words = NDArray[np.uint64]

_GOLDEN = 0x9E3779B97F4A7C15
_WORD = 0xFFFFFFFFFFFFFFFF


def mix(before: Words, arrays: Iterable[NDArray[Any]]) -> Words:
    """Returns (N,) the hashes that follow from the hashes before and from the bits of arrays with a leading
    axis of N actors.
    """
    words = np.concatenate([_words(array) for array in arrays if array.size], -1)
    return _scramble(_scramble(before) + (words * _factors(words.shape[1])).sum(-1, dtype=np.uint64))


def chance_keys(seed: int, ids: NDArray[np.int64]) -> Words:
    """Returns (N,) the random key of each actor, a function of the stage's seed and the actor's id."""
    return mix(np.full(len(ids), seed & _WORD, np.uint64), [ids])


def _words(array: NDArray[Any]) -> Words:
    """The bits of `array` (N, …) as words (N, K)."""
    flat = np.ascontiguousarray(array).reshape(len(array), -1)
    if flat.dtype.kind == "f":
        return flat.view(f"u{flat.dtype.itemsize}").astype(np.uint64)
    return flat.astype(np.int64).view(np.uint64)


@cache
def _factors(count: int) -> Words:
    """`count` odd 64-bit numbers without pattern, so that the place of a word in the state matters."""
    return _scramble(np.arange(1, count + 1, dtype=np.uint64) * np.uint64(_GOLDEN)) | np.uint64(1)


def _scramble(words: Words) -> Words:
    """splitmix64 (Steele, Lea and Flood 2014): every bit of the input changes half the bits of the output."""
    words = (words ^ (words >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    words = (words ^ (words >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return words ^ (words >> np.uint64(31))


def combine(hashes: Iterable[int]) -> int:
    """Returns one hash of many hashes, in their order."""
    total = 0
    for value in hashes:
        total = ((total ^ value) * _GOLDEN + 1) & _WORD
        total ^= total >> 29
    return total


def text(value: int) -> str:
    """Returns a hash as people and files see it: 16 hexadecimal digits."""
    return f"{value:016x}"
