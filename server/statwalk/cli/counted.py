"""How the terminal counts things."""

from __future__ import annotations


def counted(number: int, word: str) -> str:
    """Returns a number and what it counts: `1 warning`, `2 warnings`."""
    return f"{number} {word}{'' if number == 1 else 's'}"
