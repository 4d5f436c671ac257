"""Counter-based random numbers: the same key and counters give the same number, on every machine and in any
order (splitmix64, Steele, Lea and Flood 2014).
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.reference import inlined

Words = NDArray[np.uint64]

WORD = 0xFFFFFFFFFFFFFFFF
GOLDEN = 0x9E3779B97F4A7C15


def splitmix64(word: Any) -> Any:
    """Returns a mixed word, or array of words: every bit of `word` changes half the bits of the result."""
    word = ((word ^ (word >> 30)) * 0xBF58476D1CE4E5B9) & WORD
    word = ((word ^ (word >> 27)) * 0x94D049BB133111EB) & WORD
    return word ^ (word >> 31)


scrambled = inlined(splitmix64)
"""`splitmix64` for kernels"""


@inlined
def chance(key: int, tick: int, layer: int, event: int, draw: int) -> float:
    """Returns an evenly distributed number 0 ≤ … < 1 for a 64-bit key and counters ≥ 0, in kernels."""
    word = scrambled(int(np.uint64(key)))
    word = _counted(_counted(_counted(_counted(word, tick), layer), event), draw)
    return float((word >> 11) * 2.0**-53)


@inlined
def _counted(word: int, counter: int) -> Any:
    return scrambled((word + int(np.uint64(counter + 1)) * GOLDEN) & WORD)


@cache
def odd_factors(count: int) -> Words:
    """Returns `count` odd 64-bit numbers without pattern."""
    factors: Words = splitmix64(np.arange(1, count + 1, dtype=np.uint64) * np.uint64(GOLDEN)) | np.uint64(1)
    return factors


def actor_keys(seed: int, ids: NDArray[np.int64]) -> Words:
    """Returns (N,) the random key of each actor, a function of the stage's seed and the actor's id."""
    return _keyed(np.full(len(ids), seed & WORD, np.uint64), ids)


def signed_chances(keys: Words, tick: int, count: int) -> Floats:
    """Returns (N, count) evenly distributed numbers −1 ≤ … < 1 for keys (N,) and a tick."""
    in_tick = _keyed(keys, np.full(len(keys), tick))
    words = np.stack([_keyed(in_tick, np.full(len(keys), number)) for number in range(count)], -1)
    return (words >> np.uint64(11)).astype(np.float64) / 2.0**52 - 1


_FACTOR = odd_factors(1)


def _keyed(keys: Words, counters: Ints) -> Words:
    words: Words = splitmix64(splitmix64(keys) + counters.astype(np.int64).view(np.uint64) * _FACTOR)
    return words
