"""The FAQ's skeleton table (Q2, Q11) as text: `name parent length direction`, one bone a line, in any order. SK1.

    Bone            Parent            Length        Direction
    ---------------------------------------------------------
    Root            ---               -             -  -  -
    Lowerback       Root              5             0  1  0

`---` says that a bone has no parent, `-` that it has no length or direction. The heading, rules of dashes, empty lines and lines that
begin with `# ` are passed over.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from statwalk.errors import TextError
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton

LARGEST_TEXT_BYTES = 16 << 20
MOST_BONES = 20_000
LARGEST_NUMBER = 1e9
_NO_PARENT, _NOTHING = "---", "-"
_HEADING = ["bone", "parent", "length", "direction"]
SHIPPED = Path(__file__).resolve().parents[1] / "rig" / "data"


class _Row(NamedTuple):
    place: str
    name: str
    parent: str | None
    length: float
    direction: tuple[float, float, float]


def read_skeleton(text: str) -> Bones:
    """The bones of a skeleton table, parents first, in its own unit of length.

    Raises TextError, which names the line: a row that is not six words, a number that is none, a direction without length, a name that
    occurs twice, an unknown parent, bones in a circle.
    """
    rows = [_row(place, words) for place, words in lines_of(text) if not _is_furniture(words)]
    if not rows:
        raise TextError("there is no bone in this skeleton; a row reads: name parent length direction")
    if len(rows) > MOST_BONES:
        raise TextError(f"a skeleton may have {MOST_BONES} bones, not {len(rows)}", place=rows[MOST_BONES].place)
    skeleton, order = Skeleton.sorted([row.name for row in rows], [row.parent for row in rows], [row.place for row in rows])
    lengths, directions = np.array([row.length for row in rows]), np.array([row.direction for row in rows])
    return Bones(skeleton, lengths[order], directions[order])


def write_skeleton(bones: Bones) -> str:
    """The skeleton table of the bones; `read_skeleton` gives them back to the last bit."""
    lines = [f"{'Bone':<20}{'Parent':<20}{'Length':<10}Direction", "-" * 60]
    for bone, name in enumerate(bones.skeleton.names):
        parent = int(bones.skeleton.parent[bone])
        above = bones.skeleton.names[parent] if parent >= 0 else _NO_PARENT
        lines.append(f"{name:<19} {above:<19} {number_text(bones.length[bone]):<9} {numbers_text(bones.direction[bone])}")
    return "\n".join(lines) + "\n"


def shipped_skeleton(name: str) -> Bones:
    """A skeleton that comes with statwalk: `mammal` (20 bones, misprints corrected) or `hand` (16 bones)."""
    return read_skeleton((SHIPPED / f"{name}.txt").read_text(encoding="utf-8"))


def read_text(path: Path) -> str:
    """The text of a file that a character names. Raises TextError where it is missing, too large or not UTF-8."""
    try:
        if path.stat().st_size > LARGEST_TEXT_BYTES:
            raise TextError(f"the text is larger than {LARGEST_TEXT_BYTES >> 20} MiB", file=str(path))
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise TextError("this is not UTF-8 text", file=str(path), place=f"byte {error.start}") from None
    except OSError as error:
        raise TextError(f"cannot be read: {error.strerror}", file=str(path)) from None


def lines_of(text: str) -> Iterator[tuple[str, list[str]]]:
    """(place, words) of every line that is not empty and no comment."""
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if words and words[0] != "#":
            yield f"line {number}", words


def numbers(words: Sequence[str], what: str, place: str) -> list[float]:
    """The words as numbers within ±1e9; else a TextError that says of `what`."""
    try:
        values = [float(word) for word in words]
    except ValueError:
        values = [math.nan]
    if not all(abs(value) <= LARGEST_NUMBER for value in values):
        wanted = "a number" if len(words) == 1 else "numbers"
        raise TextError(f"{what} should be {wanted} within {LARGEST_NUMBER:g}, not {' '.join(words)[:80]!r}", place=place)
    return values


def number_text(value: float) -> str:
    """The shortest text that reads back as the same number; whole numbers without a point."""
    number = float(value) + 0.0
    return repr(int(number)) if number.is_integer() and abs(number) < 1e15 else repr(number)


def numbers_text(values: Sequence[float] | np.ndarray[tuple[int, ...], np.dtype[np.floating]]) -> str:
    """Numbers with a space between them."""
    return " ".join(number_text(value) for value in values)


def _is_furniture(words: list[str]) -> bool:
    return [word.lower() for word in words] == _HEADING or (len(words) == 1 and set(words[0]) == {"-"})


def _row(place: str, words: list[str]) -> _Row:
    if len(words) != 6:
        raise TextError(f"a bone is six words, name parent length x y z, not {len(words)}: {' '.join(words)[:80]!r}", place=place)
    name, parent = words[:2]
    length = 0.0 if words[2] == _NOTHING else numbers(words[2:3], f"the length of {name}", place)[0]
    if length < 0:
        raise TextError(f"the length of {name} should not be negative, it is {words[2]}", place=place)
    return _Row(place, name, None if parent == _NO_PARENT else parent, length, _direction(name, words[3:], length, place))


def _direction(name: str, words: list[str], length: float, place: str) -> tuple[float, float, float]:
    """The unit direction; one that is written with another length is brought to 1. Only a bone without length may have none."""
    if words == [_NOTHING] * 3:
        words = ["0", "0", "0"]
    x, y, z = numbers(words, f"the direction of {name}", place)
    size = math.sqrt(x * x + y * y + z * z)
    if size == 0 and length > 0:
        raise TextError(f"the direction of {name} is 0 0 0; it should point along the bone", place=place)
    return (x, y, z) if abs(size - 1) < 1e-15 or size == 0 else (x / size, y / size, z / size)
