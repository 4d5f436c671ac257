"""A clip that a file makes of another clip (principles of animation, KF9): what to do, in order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple


class SpeedChange(NamedTuple):
    """The clip runs `speed` times as fast."""

    line: int
    speed: float


class LengthChange(NamedTuple):
    """The clip takes `frames` frames at `rate` frames per second."""

    line: int
    frames: float
    rate: float


class EaseChange(NamedTuple):
    """Its time runs unevenly."""

    line: int
    easing: str


class ExaggerateChange(NamedTuple):
    """Its motion is scaled about the mean pose; `joints`: with all below them, empty: all."""

    line: int
    factor: float
    joints: tuple[str, ...] = ()


class AnticipateChange(NamedTuple):
    """A counter-motion of `seconds` comes before it."""

    line: int
    amount: float
    seconds: float
    joints: tuple[str, ...] = ()


class SquashChange(NamedTuple):
    """A joint is stretched along an axis, its volume kept; `stretch`: factors by seconds."""

    line: int
    joint: str
    axis: str
    stretch: Mapping[float, float]


class MirrorChange(NamedTuple):
    """Left and right change places."""

    line: int


class FilterChange(NamedTuple):
    """What moves faster than `low_pass` Hz goes (0: nothing), and single wild samples do if `spikes`."""

    line: int
    low_pass: float
    spikes: bool


class SwitchChange(NamedTuple):
    """Its keys switch half-way to the next key, where it went straight from key to key."""

    line: int


ClipChange = (
    SpeedChange
    | LengthChange
    | EaseChange
    | ExaggerateChange
    | AnticipateChange
    | SquashChange
    | MirrorChange
    | FilterChange
    | SwitchChange
)


@dataclass(frozen=True)
class ClipDefinition:
    """A clip made of the clip `of` by changes, in the order of the file."""

    of: str
    changes: tuple[ClipChange, ...]
    line: int
    loop: bool | None = None
    """None: as the changes leave it"""
