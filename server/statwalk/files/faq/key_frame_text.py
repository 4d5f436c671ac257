"""The FAQ's key frames (Q15) as text. KF1.

    #time      0.5
    #rotate    Left.upperleg 0 10 0          degrees about the parent's X first, then Y, then Z
    #translate Left.upperleg 0 0.3 0         off the parent's end
    #length    Left.upperleg 3
    #matrix    Left.upperleg                 or all of rotation and translation as four rows
    #weight    Left.upperleg 2               how strongly a NURBS is drawn to this key (1 without this line)

`#time`, in seconds, begins the next pose of a clip (statwalk's extension: the FAQ has one pose a file); a
file without it is one pose at 0 s. Lines that begin with `# ` are comments.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import TextError
from statwalk.files.faq.skeleton_text import lines_of, number_text, numbers, numbers_text
from statwalk.motion.keys.channel import WEIGHT_RANGE

Triple = tuple[float, float, float]
_MOST_KEYS = 1_000_000
_SINGULAR = 1e-9


@dataclass(frozen=True, eq=False)
class BoneKey:
    """The key of one bone in one pose; a field is None if the pose does not set it."""

    place: str = ""
    rotate_deg: Triple | None = None
    translate: Triple | None = None
    length: float | None = None
    matrix: NDArray[np.float64] | None = None
    """(3, 4) rows [R | t]"""
    weight: float = 1.0
    """how strongly a NURBS is drawn to the key"""


@dataclass(frozen=True, eq=False)
class KeyFrame:
    """One pose of a clip: `time` in seconds, and the keys of its bones by name."""

    time: float = 0.0
    bones: dict[str, BoneKey] = field(default_factory=dict)


@dataclass
class _Reader:
    """The frames read so far, and the lines that follow."""

    lines: Iterator[tuple[str, list[str]]]
    frames: list[KeyFrame] = field(default_factory=list)
    keys: int = 0


def read_keys(text: str) -> tuple[KeyFrame, ...]:
    """Reads the poses of a key-frame file, in the order of time.

    :raises TextError: when a `#` command is unknown, numbers are wrong, a matrix is singular or no rotation,
        a bone is keyed twice in a pose, or times do not rise; `place` is the line, the message names the
        bone.
    """
    reader = _Reader(lines_of(text))
    for place, words in reader.lines:
        if words[0] not in _COMMANDS:
            raise TextError(
                f"a line should begin with one of {', '.join(_COMMANDS)}, not {words[0][:40]!r}", place=place
            )
        _COMMANDS[words[0]](reader, words[1:], place)
    if not reader.frames:
        raise TextError("this file has no key; a key reads: #rotate BONE x y z")
    return tuple(reader.frames)


def write_keys(frames: Sequence[KeyFrame]) -> str:
    """Returns the text of the poses; `read_keys` reads the same values from it, bit for bit."""
    lines: list[str] = []
    for frame in frames:
        if len(frames) > 1 or frame.time != 0:
            lines += (
                ["", f"#time {number_text(frame.time)}"] if lines else [f"#time {number_text(frame.time)}"]
            )
        for name, key in frame.bones.items():
            lines += _key_lines(name, key)
    return "\n".join(lines) + "\n"


def _key_lines(name: str, key: BoneKey) -> Iterator[str]:
    if key.matrix is not None:
        yield f"#matrix {name}"
        yield from (numbers_text(row) for row in (*key.matrix, np.array([0.0, 0.0, 0.0, 1.0])))
    if key.rotate_deg is not None:
        yield f"#rotate {name} {numbers_text(key.rotate_deg)}"
    if key.translate is not None:
        yield f"#translate {name} {numbers_text(key.translate)}"
    if key.length is not None:
        yield f"#length {name} {number_text(key.length)}"
    if key.weight != 1:
        yield f"#weight {name} {number_text(key.weight)}"


def _time(reader: _Reader, words: list[str], place: str) -> None:
    _expect(words, 1, "#time SECONDS", place)
    (time,) = numbers(words, "#time", place)
    if time < 0 or (reader.frames and time <= reader.frames[-1].time):
        raise TextError(f"times begin at 0 or later and rise; {words[0]} does not", place=place)
    reader.frames.append(KeyFrame(time))


def _rotate(reader: _Reader, words: list[str], place: str) -> None:
    _expect(words, 4, "#rotate BONE x y z", place)
    _put(reader, words[0], place, "rotate_deg", _triple(words, "#rotate", place))


def _translate(reader: _Reader, words: list[str], place: str) -> None:
    _expect(words, 4, "#translate BONE x y z", place)
    _put(reader, words[0], place, "translate", _triple(words, "#translate", place))


def _length(reader: _Reader, words: list[str], place: str) -> None:
    _expect(words, 2, "#length BONE length", place)
    (length,) = numbers(words[1:], f"#length {words[0]}", place)
    if length < 0:
        raise TextError(f"the length of {words[0]} should not be negative, it is {words[1]}", place=place)
    _put(reader, words[0], place, "length", length)


def _weight(reader: _Reader, words: list[str], place: str) -> None:
    _expect(words, 2, "#weight BONE weight", place)
    name, (weight,) = words[0], numbers(words[1:], f"#weight {words[0]}", place)
    least, most = WEIGHT_RANGE
    if not least <= weight <= most:
        raise TextError(
            f"the weight of {name} should be {least:g} to {most:g}, it is {words[1]}", place=place
        )
    if not reader.frames or name not in reader.frames[-1].bones:
        raise TextError(f"#weight {name} should follow the key of {name} in this pose", place=place)
    bones = reader.frames[-1].bones
    bones[name] = replace(bones[name], weight=weight)


def _matrix(reader: _Reader, words: list[str], place: str) -> None:
    _expect(words, 1, "#matrix BONE, and four rows of four numbers below it", place)
    name, rows = words[0], []
    for _ in range(4):
        row_place, row = next(reader.lines, (place, ["the end of the file"]))
        if len(row) != 4:
            raise TextError(
                f"the matrix of {name} needs four rows of four numbers, not {' '.join(row)[:60]!r}",
                place=row_place,
            )
        rows.append(numbers(row, f"a row of the matrix of {name}", row_place))
    matrix = np.array(rows)
    _check_matrix(name, matrix, place)
    _put(reader, name, place, "matrix", matrix[:3])


def _check_matrix(name: str, matrix: NDArray[np.float64], place: str) -> None:
    """Checks that a key's matrix rotates, translates and scales only; the FAQ's printed example, third row 0
    0 0 0, is singular.
    """
    if not np.array_equal(matrix[3], [0, 0, 0, 1]):
        raise TextError(
            f"the last row of the matrix of {name} should be 0 0 0 1, not {numbers_text(matrix[3])}",
            place=place,
        )
    x, y, z = matrix[:3, :3].T
    length_product = float(np.sqrt((x * x).sum() * (y * y).sum() * (z * z).sum()))
    volume = float((np.cross(x, y) * z).sum())
    if abs(volume) <= _SINGULAR * length_product or length_product == 0:
        zero_row = next((index for index in range(3) if not matrix[index, :3].any()), None)
        hint = (
            ""
            if zero_row is None
            else f": row {zero_row + 1} is 0 0 0; for a bone that is not turned it is "
            f"{('1 0 0', '0 1 0', '0 0 1')[zero_row]}"
        )
        raise TextError(f"the matrix of {name} is singular{hint}", place=place)
    if volume < length_product * (1 - 1e-4):
        raise TextError(
            f"the matrix of {name} shears or mirrors; its three columns should be at right angles, "
            "right-handed",
            place=place,
        )


def _put(reader: _Reader, name: str, place: str, field_name: str, value: Any) -> None:
    """Stores a value in the bone's key of the current pose."""
    reader.keys += 1
    if reader.keys > _MOST_KEYS:
        raise TextError(f"a file may have at most {_MOST_KEYS} keys", place=place)
    if not reader.frames:
        reader.frames.append(KeyFrame())
    bones = reader.frames[-1].bones
    key = bones.get(name, BoneKey(place))
    conflicting = (
        ("rotate_deg", "translate", "matrix")
        if field_name == "matrix"
        else (field_name,)
        if field_name == "length"
        else (field_name, "matrix")
    )
    if any(getattr(key, name_of_field) is not None for name_of_field in conflicting):
        raise TextError(f"{name} already has this key in this pose, at {key.place}", place=place)
    bones[name] = replace(key, **{field_name: value})


def _expect(words: list[str], count: int, form: str, place: str) -> None:
    if len(words) != count:
        raise TextError(
            f"this key should read {form}, not {len(words)} words: {' '.join(words)[:60]!r}", place=place
        )


def _triple(words: list[str], command: str, place: str) -> Triple:
    x, y, z = numbers(words[1:], f"{command} {words[0]}", place)
    return x, y, z


_COMMANDS: dict[str, Callable[[_Reader, list[str], str], None]] = {
    "#time": _time,
    "#rotate": _rotate,
    "#translate": _translate,
    "#length": _length,
    "#matrix": _matrix,
    "#weight": _weight,
}
