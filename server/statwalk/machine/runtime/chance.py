"""Counter-based random numbers: the same counters give the same number, on every machine and in any order."""

from __future__ import annotations

import numpy as np

from statwalk.maths.reference import inlined

_WORD = 0xFFFFFFFFFFFFFFFF
_GOLDEN = 0x9E3779B97F4A7C15


@inlined
def chance(key: int, tick: int, layer: int, event: int, draw: int) -> float:
    """Returns an evenly distributed number 0 ≤ … < 1 for a 64-bit key and counters ≥ 0 (splitmix64, Steele,
    Lea and Flood 2014).
    """
    word = _scramble(int(np.uint64(key)))
    word = _counted(_counted(_counted(_counted(word, tick), layer), event), draw)
    return (word >> 11) * 2.0**-53


@inlined
def _counted(word: int, counter: int) -> int:
    return _scramble((word + int(np.uint64(counter + 1)) * _GOLDEN) & _WORD)


@inlined
def _scramble(word: int) -> int:
    word = ((word ^ (word >> 30)) * 0xBF58476D1CE4E5B9) & _WORD
    word = ((word ^ (word >> 27)) * 0x94D049BB133111EB) & _WORD
    return word ^ (word >> 31)
