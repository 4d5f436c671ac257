"""Names made unique: what has none gets its kind and number, what repeats gets a count."""

from __future__ import annotations

from collections.abc import Sequence


def unique(names: Sequence[str], kind: str, numbers: Sequence[int] | None = None) -> list[str]:
    """The names in order, unnamed ones as `clip 3`, repeated ones as `Walk`, `Walk 2`; `numbers` are those of the file."""
    taken = set(names)
    used: set[str] = set()
    out: list[str] = []
    for row, name in enumerate(names):
        wanted = name or f"{kind} {row if numbers is None else numbers[row]}"
        if wanted in used or (not name and wanted in taken):
            wanted = next(free for free in (f"{wanted} {count}" for count in range(2, len(names) + 2)) if free not in used | taken)
        used.add(wanted)
        out.append(wanted)
    return out
