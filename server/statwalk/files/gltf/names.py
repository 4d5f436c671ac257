"""Makes names unique: an empty name becomes kind and number, a repeated name gets a count."""

from __future__ import annotations

from collections.abc import Sequence


def unique(
    names: Sequence[str], kind: str, numbers: Sequence[int] | None = None, between: str = " "
) -> list[str]:
    """Returns the names in order, empty ones as `clip 3`, repeated ones as `Walk`, `Walk 2`; `numbers` are
    the objects' numbers in the file, `between` stands before a number.
    """
    taken = set(names)
    used: set[str] = set()
    unique_names: list[str] = []
    for row, name in enumerate(names):
        candidate = name or f"{kind}{between}{row if numbers is None else numbers[row]}"
        if candidate in used or (not name and candidate in taken):
            candidate = next(
                free_name
                for free_name in (f"{candidate}{between}{count}" for count in range(2, len(names) + 2))
                if free_name not in used | taken
            )
        used.add(candidate)
        unique_names.append(candidate)
    return unique_names
