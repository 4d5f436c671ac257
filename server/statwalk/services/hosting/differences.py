"""Compares two stages, or two spans of one, tick by tick: how far apart the joints of the same actor are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from statwalk.errors import ConflictError
from statwalk.maths import quat
from statwalk.maths.arrays import Floats, Ints
from statwalk.services.hosting.stage_replies import JointTrack, StageStatus

USUAL_TICKS = 600
MOST_DETAILED = 100_000
"""joint poses that are listed one by one"""


class Span(NamedTuple):
    """Ticks from `first` to `last`."""

    first: int
    last: int

    def later(self, ticks: int) -> Span:
        """Returns the span so many ticks later."""
        return Span(self.first + ticks, self.last + ticks)


@dataclass(frozen=True)
class ActorDifference:
    """How far an actor is from itself on the other stage, at T ticks from `first` on, by J joints; metres and
    radians, an angle is that of a joint's rotation to its parent.
    """

    actor: int
    name: str
    joints: tuple[str, ...]
    first: int
    root_distance: Floats
    """(T,)"""
    root_angle: Floats
    """(T,)"""
    distance: Floats
    """(T, J)"""
    angle: Floats
    """(T, J)"""

    @property
    def first_tick(self) -> int | None:
        """The first tick at which anything differs; None: nothing does."""
        parts = self.root_distance, self.root_angle, self.distance.max(-1), self.angle.max(-1)
        ticks = np.flatnonzero(np.any(np.stack(parts) > 0, axis=0))
        return self.first + int(ticks[0]) if len(ticks) else None


def common_span(
    here: StageStatus, there: StageStatus, first: int | None, last: int | None, later: int = 0
) -> Span:
    """Returns the span of the stage `here` to compare; the span of the stage `there` begins `later` ticks
    after it. `last` None: the newest tick that both have; `first` None: `USUAL_TICKS` up to `last`.

    :raises ConflictError: when one of the stages does not have the ticks.
    """
    oldest, newest = max(here.first, there.first - later), min(here.head, there.head - later)
    last = newest if last is None else last
    first = max(oldest, last - USUAL_TICKS + 1) if first is None else first
    if not oldest <= first <= last <= newest:
        spans = f"{here.first} … {here.head} and {there.first} … {there.head}"
        asked = f"{first} to {last}" + (f", and from {first + later} to {last + later}" if later else "")
        raise ConflictError(f"the stages have the ticks {spans}; they have no span from {asked}")
    return Span(first, last)


def in_model_space(tracks: Sequence[JointTrack]) -> list[JointTrack]:
    """Returns tracks with the joints' places in model space: the same wherever an actor stands and looks."""
    return [replace(track, places=_model_places(track)) for track in tracks]


def moved(tracks: Sequence[JointTrack], ticks: int) -> list[JointTrack]:
    """Returns tracks that begin so many ticks later."""
    return [replace(track, first=track.first + ticks) for track in tracks]


def differences(here: Sequence[JointTrack], there: Sequence[JointTrack]) -> list[ActorDifference]:
    """Returns the differences of the actors that both stages have, by id, at the same ticks, with joints of
    the same names.
    """
    others = {track.actor: track for track in there}
    pairs = [(track, others[track.actor]) for track in here if track.actor in others]
    return [found for pair in pairs if (found := _difference(*pair))]


def check_detailed(found: Sequence[ActorDifference]) -> None:
    """:raises ConflictError: when there are too many joint poses to list one by one."""
    poses = sum(each.distance.size for each in found)
    if poses > MOST_DETAILED:
        raise ConflictError(
            f"{poses} joint poses (joints x actors x ticks) are too many to list, {MOST_DETAILED} at most: "
            "ask for fewer ticks, or for the summary"
        )


def _difference(here: JointTrack, there: JointTrack) -> ActorDifference | None:
    """None without a common tick or joint."""
    first = max(here.first, there.first)
    length = min(here.first + len(here.headings), there.first + len(there.headings)) - first
    joints = [name for name in here.joints if name in there.joints]
    if length <= 0 or not joints:
        return None
    own, other = (_cut(track, first, length, joints) for track in (here, there))
    return ActorDifference(
        here.actor,
        here.name,
        tuple(joints),
        first,
        np.linalg.norm(own.root_positions - other.root_positions, axis=-1),
        np.abs(np.angle(np.exp(1j * (own.headings - other.headings)))),
        np.linalg.norm(own.places - other.places, axis=-1),
        _angle(own.rotations, other.rotations),
    )


def _cut(track: JointTrack, first: int, length: int, joints: Sequence[str]) -> JointTrack:
    ticks = slice(first - track.first, first - track.first + length)
    columns: Ints = np.array([track.joints.index(name) for name in joints])
    return JointTrack(
        track.actor,
        track.name,
        tuple(joints),
        first,
        track.places[ticks][:, columns],
        track.rotations[ticks][:, columns],
        track.root_positions[ticks],
        track.headings[ticks],
    )


def _model_places(track: JointTrack) -> Floats:
    """The places (T, J, 3) as they are where an actor stands at the origin and looks along +Z."""
    back = quat.from_axis_angle((0.0, 1.0, 0.0), -track.headings)
    return quat.rotate(back[:, None], track.places - track.root_positions[:, None])


def _angle(a: Floats, b: Floats) -> Floats:
    """The angle between rotations; exactly 0 for equal ones, which the arc cosine of their product is not."""
    b = np.where(np.sum(a * b, axis=-1, keepdims=True) < 0, -b, b)
    angle: Floats = 4 * np.arctan2(np.linalg.norm(a - b, axis=-1), np.linalg.norm(a + b, axis=-1))
    return angle
