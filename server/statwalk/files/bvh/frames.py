"""The MOTION of a BVH file: the number of frames, the time of one, and a row of numbers for each.

The rows are counted before any number is read, so that a false count costs nothing.
"""

from __future__ import annotations

import re
import warnings
from math import isfinite

import numpy as np

from statwalk.errors import TextError
from statwalk.maths.arrays import Floats, Ints

LARGEST_NUMBER = 1e9
LONGEST_FRAME, SHORTEST_FRAME = 3_600.0, 1e-6
FRAMES = re.compile(r"frames\s*:\s*(\S+)\s*", re.IGNORECASE)
FRAME_TIME = re.compile(r"frame\s+time\s*:\s*(\S+)\s*", re.IGNORECASE)


def read_frames(text: str, motion_line: int, channels: int) -> tuple[Floats, float]:
    """Reads what follows MOTION in line `motion_line`; returns the rows (F, channels) as written, and the
    seconds from frame to frame.

    :raises TextError: when a line is wrong, or there are more or fewer rows than the file says.
    """
    lines = text.split("\n", motion_line)
    body = lines[-1] if len(lines) > motion_line else ""
    frames_line, body, first = _next_line(body, motion_line + 1)
    frames = _count(frames_line, first)
    time_line, body, second = _next_line(body, first + 1)
    seconds = _seconds(time_line, second)
    return _rows(body, second + 1, frames, channels), seconds


def _next_line(body: str, number: int) -> tuple[str, str, int]:
    """Returns the first line that is not blank, what follows it, and the line's number."""
    while body:
        line, _, body = body.partition("\n")
        if line.strip():
            return line.strip(), body, number
        number += 1
    raise TextError("the file ends before its frames", place=f"line {number}")


def _count(line: str, number: int) -> int:
    match = FRAMES.fullmatch(line)
    if not match or not match[1].isdecimal() or len(match[1]) > 15 or not match[1].isascii():
        raise TextError(
            f"here must stand Frames: and their number, 0 or more, not {line[:80]!r}", place=f"line {number}"
        )
    return int(match[1])


def _seconds(line: str, number: int) -> float:
    match = FRAME_TIME.fullmatch(line)
    try:
        seconds = float(match[1]) if match else float("nan")
    except ValueError:
        seconds = float("nan")
    if not isfinite(seconds) or not SHORTEST_FRAME <= seconds <= LONGEST_FRAME:
        raise TextError(
            f"here must stand Frame Time: and seconds from {SHORTEST_FRAME:g} to {LONGEST_FRAME:g}, "
            f"not {line[:80]!r}",
            place=f"line {number}",
        )
    return seconds


def _rows(body: str, first_line: int, frames: int, channels: int) -> Floats:
    """Returns the numbers (frames, channels); counts the words of every line first."""
    words = words_by_line(body)
    filled = np.flatnonzero(words)
    wrong = filled[words[filled] != channels]
    if channels and len(wrong):
        raise TextError(
            f"a frame has {channels} numbers, this line has {words[wrong[0]]}",
            place=f"line {first_line + wrong[0]}",
        )
    if (len(filled) if channels else frames) != frames:
        raise TextError(
            f"Frames: says {frames}, but {len(filled)} rows follow",
            place=f"line {first_line + len(words) - 1}",
        )
    if not channels or not frames:
        return np.zeros((0, channels))
    return _numbers(body, first_line, frames * channels).reshape(frames, channels)


def words_by_line(body: str) -> Ints:
    """Returns (L,) the number of words in each line of a text, in one pass over its bytes."""
    letters = np.frombuffer(body.encode("utf-8", "replace") + b"\n", np.uint8)
    is_space = letters <= 32
    begins = ~is_space
    begins[1:] &= is_space[:-1]
    ends = np.flatnonzero(letters == 10)
    words_until = np.cumsum(begins)[ends]
    return np.diff(words_until, prepend=0)


def _numbers(body: str, first_line: int, count: int) -> Floats:
    """Returns the words as numbers."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            values = np.fromstring(body, np.float64, sep=" ")
    except (ValueError, DeprecationWarning):
        values = np.zeros(0)
    if len(values) != count or not (np.abs(values) <= LARGEST_NUMBER).all():
        _refuse(body, first_line)
    return values


def _refuse(body: str, first_line: int) -> None:
    """Finds the word that is no number within ±1e9, and raises the error."""
    for number, line in enumerate(body.split("\n"), first_line):
        for word in line.split():
            if not _is_number(word):
                raise TextError(
                    f"{word[:80]!r} is no number within {LARGEST_NUMBER:g}", place=f"line {number}"
                )
    raise TextError("the frames cannot be read as numbers", place=f"line {first_line}")


def _is_number(word: str) -> bool:
    try:
        return abs(float(word)) <= LARGEST_NUMBER and "_" not in word
    except ValueError:
        return False
