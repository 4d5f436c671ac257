"""The cycles of an MD2 file: frames whose names have the same beginning, `run1` … `run6`. Quake II plays ten
frames a second.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from statwalk.files.gltf.names import unique

RATE = 10.0
LONGEST_NAME = 15
"""letters of a frame's name: 16 bytes with the zero at its end"""
DIGITS = "0123456789"
ENDING = ("attack", "attak", "pain", "death", "jump", "flip", "salute", "taunt", "wave", "point", "boom")
"""how the names of Quake II's cycles begin that end in their last frame, crouched (cr…) or not; all others
come round
"""


def comes_round(cycle: str) -> bool:
    """Returns whether the first frame of a cycle follows its last frame."""
    name = cycle.lower()
    return not name.startswith(ENDING) and not name.removeprefix("cr").startswith(ENDING)


def cycles_of(names: Sequence[str]) -> dict[str, list[int]]:
    """Returns the frames of each cycle, in the order of the file.

    The number at the end of a name is no part of the cycle's: two digits of three or more (`pain104` is frame
    04 of pain1), all if they begin with 0 (`walk001`), or if they continue the count of the frame before
    (`idle99`, `idle100`).
    """
    cycles: dict[str, list[int]] = {}
    cycle, number = "", -1
    for frame, name in enumerate(names):
        cycle, number = _split(name, cycle, number)
        cycles.setdefault(cycle, []).append(frame)
    return dict(zip(unique(list(cycles), "cycle"), cycles.values(), strict=True))


def _split(name: str, last_cycle: str, last_number: int) -> tuple[str, int]:
    """Returns the cycle and the number in a frame's name; `last_cycle` and `last_number` those before."""
    cycle = name.rstrip(DIGITS)
    digits = name[len(cycle) :]
    if name.startswith(last_cycle) and last_number >= 0:
        further = name[len(last_cycle) :]
        if further and digits.endswith(further) and int(further) == last_number + 1:
            return last_cycle, last_number + 1
    if len(digits) > 2 and digits[0] != "0":
        cycle, digits = cycle + digits[:-2], digits[-2:]
    return cycle, int(digits or 0)


def frame_names(counts: Mapping[str, int]) -> list[str]:
    """Returns the names of the frames of clips, which have some frames each; `cycles_of` finds the clips
    again.

    A clip's name is cut to the length of a frame's; it ends in _ where its digits would count as the frame's.
    """
    names: list[str] = []
    for row, (clip, count) in enumerate(counts.items()):
        names += next(own for own in _numbered(clip, count, row) if _stands_apart(names, own))
    return names


def _numbered(clip: str, count: int, row: int) -> Iterator[list[str]]:
    """Yields names for the frames of clip number `row`: the clip's own, then ever more changed ones."""
    width = max(2, len(str(count)))
    plain = re.sub(r"[^!-~]+", "_", clip) or "frame"
    for ending in ("", "_", *(f"_{number}_" for number in range(row, row + 1_000))):
        cycle = plain[: LONGEST_NAME - width - len(ending)] + ending
        yield [f"{cycle}{number:0{width}}" for number in range(1, count + 1)]


def _stands_apart(names: list[str], own: list[str]) -> bool:
    """Returns whether the frames called `own` are a cycle of their own after the frames called `names`."""
    cycles = cycles_of([*names, *own])
    return list(cycles.values())[-1] == list(range(len(names), len(names) + len(own)))
