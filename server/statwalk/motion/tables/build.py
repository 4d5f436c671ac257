"""Builds the tables of all motions of a role; nothing can fail after it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats
from statwalk.maths.blend_tables import BlendedClip, BlendRows, BlendTables
from statwalk.maths.columns import locked
from statwalk.maths.phases import Warp, warp
from statwalk.maths.pose import Pose
from statwalk.motion.root_track import STANDING, RootTrack
from statwalk.motion.tables.edge_search import EdgeSearch
from statwalk.motion.tables.lane_groups import packed_clips
from statwalk.motion.tables.lane_layout import LaneLayout, PackedClip
from statwalk.motion.tables.motion_tables import MotionTables


class Member(Protocol):
    """A clip in place, and its root motion."""

    @property
    def clip(self) -> PackedClip: ...  # noqa: D102
    @property
    def root(self) -> RootTrack: ...  # noqa: D102


class Playable(Protocol):
    """The motion of a state: one member, or several at their `places` (K, A) along the parameters
    `columns`.
    """

    @property
    def members(self) -> Sequence[Member]: ...  # noqa: D102
    @property
    def places(self) -> Floats: ...  # noqa: D102
    @property
    def columns(self) -> tuple[int, ...]: ...  # noqa: D102
    @property
    def warps(self) -> tuple[Warp, ...]: ...  # noqa: D102
    @property
    def loop(self) -> bool: ...  # noqa: D102


@dataclass(frozen=True, eq=False)
class Alone:
    """A clip as a motion of its own, without root motion."""

    clip: PackedClip
    root: RootTrack = STANDING
    places: Floats = field(default_factory=lambda: np.zeros((1, 0)))
    columns: tuple[int, ...] = ()
    warps: tuple[Warp, ...] = (warp((), ()),)
    loop: bool = False

    @property
    def members(self) -> Sequence[Member]:
        """Returns this motion as the only member."""
        return (self,)


def tables_of(motions: Sequence[Playable | None], rest: Pose) -> MotionTables:
    """Returns the tables of each state's motion (None: no motion) on a character with the rest pose `rest`
    (unbatched).
    """
    members = list(
        {id(member): member for motion in motions if motion is not None for member in motion.members}.values()
    )
    clips, searches = [member.clip for member in members], EdgeSearch()
    layout = LaneLayout.of(clips, rest)
    packed = packed_clips(clips, layout, searches)
    ways, roots = [STANDING.places], []
    for member in members:
        moves = len(member.root.times) > 1
        roots.append((searches.add(member.root.times) if moves else -1, sum(map(len, ways)) if moves else 0))
        ways += [member.root.places] if moves else []
    blends = _blends(motions, {id(member): row for row, member in enumerate(members)})
    return locked(
        MotionTables(
            **blends._asdict(),
            roots=_table(roots, 2, np.int64),
            ways=np.concatenate(ways),
            clips=_table(packed.clips, 3, np.int64),
            searches=_table(searches.rows, 6, np.int64),
            scales=np.array(searches.scales, np.float64),
            edges=np.concatenate([*searches.edges, np.zeros(1)]),
            paces=np.concatenate([*searches.paces, np.zeros(1)]),
            buckets=np.concatenate([*searches.buckets, np.zeros(1, np.int32)]),
            groups=_table(packed.groups, 6, np.int64),
            values=packed.values,
            base=packed.base,
            layout=layout.places,
            common=layout.common,
            common_values=layout.common_values,
        )
    )


def _blends(motions: Sequence[Playable | None], rows: dict[int, int]) -> BlendTables:
    """The parts of MotionTables that describe states; `rows`: by the id of each member, the row of its clip
    and root track, without the rest pose.
    """
    blends = BlendRows()
    for motion in motions:
        if motion is None:
            blends.add_none()
            continue
        pairs = zip(motion.members, motion.warps, strict=True)
        clips = [BlendedClip(member.clip.duration, phases, rows[id(member)]) for member, phases in pairs]
        blends.add(clips, motion.places, motion.columns, motion.loop)
    return blends.tables()


def _table(rows: Sequence[object], width: int, kind: type) -> NDArray[Any]:
    return np.array(rows, kind).reshape(-1, width)
