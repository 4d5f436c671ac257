"""The HIERARCHY of a BVH file: joints with their offsets and channels, line by line."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from io import StringIO
from typing import NamedTuple

from statwalk.errors import TextError
from statwalk.files.faq.skeleton_text import numbers

MOST_JOINTS = 20_000
CHANNELS_AT_MOST = 6
LONGEST_NAME = 200
AXES = "XYZ"
CHANNELS = tuple(f"{axis}{kind}" for kind in ("position", "rotation") for axis in AXES)
_SPELLING = {name.lower(): name for name in CHANNELS}


class BvhLine(NamedTuple):
    """A line that has words, and its number."""

    number: int
    words: list[str]

    @property
    def place(self) -> str:
        """Returns the place for errors."""
        return f"line {self.number}"


@dataclass
class BvhJoint:
    """A joint as the file says it; an End Site is a joint without channels, called PARENT.end.

    parent   row of the parent, -1 for a root
    line     its first line
    """

    name: str
    parent: int
    line: int
    offset: Sequence[float] = ()
    channels: tuple[str, ...] = ()


@dataclass
class _Reading:
    """What is known between two lines: the joints so far, and the rows of those whose braces are open."""

    joints: list[BvhJoint] = field(default_factory=list)
    opened: list[int] = field(default_factory=list)
    waits_for_brace: bool = False


def lines_of(text: str) -> Iterator[BvhLine]:
    """Yields the lines with words; a brace always stands alone."""
    for number, line in enumerate(StringIO(text, newline="\n"), 1):
        words = line.split()
        while words and words[-1] in "{}" and len(words) > 1:
            yield BvhLine(number, words[:-1])
            words = words[-1:]
        if words:
            yield BvhLine(number, words)


def read_hierarchy(lines: Iterator[BvhLine]) -> tuple[list[BvhJoint], BvhLine]:
    """Reads joints until MOTION; returns them, parents first, and the line that says MOTION.

    :raises TextError: when a line is not what it should be, or the file ends too early; `place` is the line.
    """
    first = next(lines, None)
    if first is None or first.words[0].upper() != "HIERARCHY":
        raise TextError("a BVH file begins with HIERARCHY", place=first.place if first else "line 1")
    reading, last = _Reading(), first
    for last in lines:
        if last.words[0].upper() == "MOTION":
            return _finished(reading, last), last
        _take(reading, last)
    raise TextError("the file ends before MOTION", place=last.place)


def _finished(reading: _Reading, line: BvhLine) -> list[BvhJoint]:
    if reading.opened or reading.waits_for_brace:
        name = reading.joints[reading.opened[-1] if reading.opened else -1].name
        raise TextError(f"MOTION begins before {name[:80]!r} is closed with }}", place=line.place)
    if not reading.joints:
        raise TextError("the hierarchy has no joint; it begins with ROOT NAME", place=line.place)
    return reading.joints


def _take(reading: _Reading, line: BvhLine) -> None:
    """Reads one line of the hierarchy."""
    word = line.words[0].upper()
    if reading.waits_for_brace != (word == "{"):
        wanted = "{ must follow" if reading.waits_for_brace else "this { follows no"
        raise TextError(f"{wanted} the name of a joint, not {' '.join(line.words)[:80]!r}", place=line.place)
    if word == "{":
        reading.waits_for_brace = False
        reading.opened.append(len(reading.joints) - 1)
    elif word in ("ROOT", "JOINT", "END"):
        _begin(reading, line, word)
    elif not reading.opened:
        raise TextError(
            f"{line.words[0][:80]!r} stands outside any joint; ROOT NAME begins one", place=line.place
        )
    elif word == "}":
        _close(reading, line)
    else:
        _detail(reading.joints[reading.opened[-1]], line, word)


def _begin(reading: _Reading, line: BvhLine, word: str) -> None:
    if (word == "ROOT") == bool(reading.opened):
        right = "inside a joint, JOINT begins the next" if reading.opened else "the first joint is a ROOT"
        raise TextError(f"{line.words[0]} cannot stand here: {right}", place=line.place)
    if len(reading.joints) >= MOST_JOINTS:
        raise TextError(f"a skeleton may have at most {MOST_JOINTS} joints", place=line.place)
    parent = reading.opened[-1] if reading.opened else -1
    name = f"{reading.joints[parent].name}.end" if word == "END" else " ".join(line.words[1:])
    reading.joints.append(BvhJoint(name[:LONGEST_NAME], parent, line.number))
    reading.waits_for_brace = True


def _close(reading: _Reading, line: BvhLine) -> None:
    if len(line.words) > 1:
        raise TextError(f"}} stands alone on its line, without {line.words[1][:80]!r}", place=line.place)
    joint = reading.joints[reading.opened.pop()]
    if not joint.offset:
        raise TextError(f"{joint.name[:80]!r} has no OFFSET: three numbers", place=line.place)


def _detail(joint: BvhJoint, line: BvhLine, word: str) -> None:
    """Reads OFFSET or CHANNELS."""
    if word == "OFFSET" and not joint.offset:
        if len(line.words) != 4:
            raise TextError(f"OFFSET needs three numbers, not {len(line.words) - 1}", place=line.place)
        joint.offset = numbers(line.words[1:], "OFFSET", line.place)
    elif word == "CHANNELS" and not joint.channels and not joint.name.endswith(".end"):
        joint.channels = _channels(line)
    else:
        raise TextError(
            f"{' '.join(line.words)[:80]!r} cannot stand here: a joint has OFFSET and CHANNELS once, and "
            "JOINTs or an End Site",
            place=line.place,
        )


def _channels(line: BvhLine) -> tuple[str, ...]:
    count, names = line.words[1:2], line.words[2:]
    if count != [str(len(names))] or len(names) > CHANNELS_AT_MOST:
        raise TextError(
            f"CHANNELS needs a number from 0 to {CHANNELS_AT_MOST} and as many names; here are {len(names)} "
            f"names after {' '.join(count)[:20]!r}",
            place=line.place,
        )
    for name in names:
        if name.lower() not in _SPELLING:
            raise TextError(
                f"there is no channel {name[:80]!r}; the channels are {', '.join(CHANNELS)}", place=line.place
            )
    channels = tuple(_SPELLING[name.lower()] for name in names)
    if len(set(channels)) < len(channels):
        raise TextError("CHANNELS names a channel twice", place=line.place)
    return channels
