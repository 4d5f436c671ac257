"""Chance that follows from counters alone: the same ones give the same number, on every machine and in every order."""

from __future__ import annotations

_WORD = 0xFFFFFFFFFFFFFFFF
_GOLDEN = 0x9E3779B97F4A7C15


def chance(key: int, *counters: int) -> float:
    """0 ≤ … < 1, evenly, from a 64-bit key and counters ≥ 0 (splitmix64, Steele, Lea and Flood 2014)."""
    word = _scramble(key & _WORD)
    for counter in counters:
        word = _scramble((word + (counter + 1) * _GOLDEN) & _WORD)
    return (word >> 11) * 2.0**-53


def _scramble(word: int) -> int:
    word = ((word ^ (word >> 30)) * 0xBF58476D1CE4E5B9) & _WORD
    word = ((word ^ (word >> 27)) * 0x94D049BB133111EB) & _WORD
    return word ^ (word >> 31)
