"""The FAQ's skeleton table (Q2, Q11) as text: `name parent length direction`, one bone a line, in any order.

SK1.

    Bone            Parent            Length        Direction
    ---------------------------------------------------------
    Root            ---               -             -  -  -
    Lowerback       Root              5             0  1  0

`---` means that a bone has no parent, `-` that it has no length or direction. The heading, lines of dashes,
empty lines and lines that begin with `# ` are skipped.
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
SHIPPED = Path(__file__).resolve().parents[2] / "rig" / "data"


class _Row(NamedTuple):
    place: str
    name: str
    parent: str | None
    length: float
    direction: tuple[float, float, float]


def read_skeleton(text: str) -> Bones:
    """Reads the bones of a skeleton table, parents first, in the table's own unit of length.

    :raises TextError: when a row is not six words, a number is invalid, a direction has no length, a name
        occurs twice, a parent is unknown, or bones form a circle; `place` is the line.
    """
    rows = [_row(place, words) for place, words in lines_of(text) if not _is_furniture(words)]
    if not rows:
        raise TextError("this skeleton has no bone; a row reads: name parent length direction")
    if len(rows) > MOST_BONES:
        raise TextError(
            f"a skeleton may have at most {MOST_BONES} bones, not {len(rows)}", place=rows[MOST_BONES].place
        )
    skeleton, order = Skeleton.sorted(
        [row.name for row in rows], [row.parent for row in rows], [row.place for row in rows]
    )
    lengths, directions = np.array([row.length for row in rows]), np.array([row.direction for row in rows])
    return Bones(skeleton, lengths[order], directions[order])


def write_skeleton(bones: Bones) -> str:
    """Returns the skeleton table of the bones; `read_skeleton` reads the same values from it, bit for bit."""
    lines = [f"{'Bone':<20}{'Parent':<20}{'Length':<10}Direction", "-" * 60]
    for bone, name in enumerate(bones.skeleton.names):
        parent = int(bones.skeleton.parent[bone])
        parent_name = bones.skeleton.names[parent] if parent >= 0 else _NO_PARENT
        lines.append(
            f"{name:<19} {parent_name:<19} {number_text(bones.length[bone]):<9} "
            f"{numbers_text(bones.direction[bone])}"
        )
    return "\n".join(lines) + "\n"


def shipped_skeleton(name: str) -> Bones:
    """Returns a skeleton that statwalk ships: `mammal` (20 bones, misprints corrected) or `hand` (16
    bones).
    """
    return read_skeleton((SHIPPED / f"{name}.txt").read_text(encoding="utf-8"))


def read_text(path: Path) -> str:
    """Reads a text file that a character file names.

    :raises TextError: when the file is missing, too large or not UTF-8.
    """
    try:
        if path.stat().st_size > LARGEST_TEXT_BYTES:
            raise TextError(f"the text is larger than {LARGEST_TEXT_BYTES >> 20} MiB", file=str(path))
        return path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise TextError("this is not UTF-8 text", file=str(path), place=f"byte {error.start}") from None
    except OSError as error:
        raise TextError(f"the file cannot be read: {error.strerror}", file=str(path)) from None


def lines_of(text: str) -> Iterator[tuple[str, list[str]]]:
    """Yields (place, words) of every line that is neither empty nor a comment."""
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if words and words[0] != "#":
            yield f"line {number}", words


def numbers(words: Sequence[str], subject: str, place: str) -> list[float]:
    """Returns the words as numbers within ±1e9.

    :raises TextError: when a word is no such number; the message begins with `subject`.
    """
    try:
        values = [float(word) for word in words]
    except ValueError:
        values = [math.nan]
    if not all(abs(value) <= LARGEST_NUMBER for value in values):
        wanted = "a number" if len(words) == 1 else "numbers"
        raise TextError(
            f"{subject} should be {wanted} within {LARGEST_NUMBER:g}, not {' '.join(words)[:80]!r}",
            place=place,
        )
    return values


def number_text(value: float) -> str:
    """Returns the shortest text that reads back as the same number; whole numbers have no decimal point."""
    number = float(value) + 0.0
    return repr(int(number)) if number.is_integer() and abs(number) < 1e15 else repr(number)


def numbers_text(values: Sequence[float] | np.ndarray[tuple[int, ...], np.dtype[np.floating]]) -> str:
    """Returns the numbers as text, separated by spaces."""
    return " ".join(number_text(value) for value in values)


def _is_furniture(words: list[str]) -> bool:
    return [word.lower() for word in words] == _HEADING or (len(words) == 1 and set(words[0]) == {"-"})


def _row(place: str, words: list[str]) -> _Row:
    if len(words) != 6:
        raise TextError(
            f"a bone is six words, name parent length x y z, not {len(words)}: {' '.join(words)[:80]!r}",
            place=place,
        )
    name, parent = words[:2]
    length = 0.0 if words[2] == _NOTHING else numbers(words[2:3], f"the length of {name}", place)[0]
    if length < 0:
        raise TextError(f"the length of {name} should not be negative, it is {words[2]}", place=place)
    return _Row(
        place,
        name,
        None if parent == _NO_PARENT else parent,
        length,
        _direction(name, words[3:], length, place),
    )


def _direction(name: str, words: list[str], length: float, place: str) -> tuple[float, float, float]:
    """Returns the direction at unit length; only a bone without length may have none."""
    if words == [_NOTHING] * 3:
        words = ["0", "0", "0"]
    x, y, z = numbers(words, f"the direction of {name}", place)
    norm = math.sqrt(x * x + y * y + z * z)
    if norm == 0 and length > 0:
        raise TextError(f"the direction of {name} is 0 0 0; it should point along the bone", place=place)
    return (x, y, z) if abs(norm - 1) < 1e-15 or norm == 0 else (x / norm, y / norm, z / norm)
