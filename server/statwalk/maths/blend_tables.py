"""The blends of clips of a table's states as arrays: the clips, their places, how their phases are matched.

`blending` reads them; who samples clips has the same columns among its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats
from statwalk.maths.columns import columns, locked
from statwalk.maths.phases import Warp


class BlendTables(NamedTuple):
    """S states, K members (a clip in a state)."""

    states: Annotated[NDArray[np.int64], "state, 5"]
    """first member, number of members (0: no motion, 1: a clip, more: a blend space), whether it loops,
    columns of its one or two parameters (-1: none)
    """
    durations: Annotated[NDArray[np.float64], "state"]
    """seconds; of a blend space the longest clip"""
    bounds: Annotated[NDArray[np.float64], "state, 4"]
    """the smallest and the largest position along the first axis, then along the second"""
    members: Annotated[NDArray[np.int64], "member, 5"]
    """clip, first knot and number of knots of the warp (0: identity), rank of its position along the first
    axis, root track
    """
    places: Annotated[NDArray[np.float64], "member, 5"]
    """position on both axes, duration (seconds), the phases at which the warp's two circles are cut open"""
    knots: Annotated[NDArray[np.float64], "knot, 2"]
    """phases since the cut, of the state's first clip and of this clip"""

    @property
    def most_members(self) -> int:
        """Returns the number of clips of the largest blend; 1 if there is none."""
        return int(self.states[:, 1].max(initial=1))


BLENDS = columns(BlendTables, readonly=True)
"""the numba type of BlendTables"""


class BlendedClip(NamedTuple):
    """A clip in a state's motion; `row` counts the clips that are sampled, -1 none is."""

    duration: float
    phases: Warp
    row: int = -1


class BlendRows:
    """BlendTables while they are built, one state after the other."""

    def __init__(self) -> None:
        self._states: list[tuple[int, ...]] = []
        self._durations: list[float] = []
        self._bounds: list[tuple[float, ...]] = []
        self._members: list[tuple[int, ...]] = []
        self._places: list[tuple[float, ...]] = []
        self._knots: list[tuple[float, float]] = []

    def add_none(self) -> None:
        """Adds a state without motion."""
        self._states.append((len(self._members), 0, 0, -1, -1))
        self._durations.append(0.0)
        self._bounds.append((0.0,) * 4)

    def add(self, clips: Sequence[BlendedClip], places: Floats, over: Sequence[int], loop: bool) -> None:
        """Adds a state with clips at `places` (K, A) along the columns `over` of the parameters."""
        axes = np.concatenate([places, np.zeros((len(places), 2))], -1)[:, :2]
        ranks = np.argsort(np.argsort(axes[:, 0], kind="stable"), kind="stable").tolist()
        self._states.append((len(self._members), len(clips), int(loop), *(*over, -1, -1)[:2]))
        self._durations.append(max(clip.duration for clip in clips))
        self._bounds.append((axes[:, 0].min(), axes[:, 0].max(), axes[:, 1].min(), axes[:, 1].max()))
        for clip, place, rank in zip(clips, axes, ranks, strict=True):
            self._add_member(clip, place, rank)

    def _add_member(self, clip: BlendedClip, place: Floats, rank: int) -> None:
        phases, first = clip.phases, len(self._knots)
        knots = [] if phases.is_identity else list(zip(phases.here, phases.there, strict=True))
        self._members.append((clip.row + 1, first, len(knots), rank, clip.row))
        self._places.append((*place, clip.duration, *phases.origin))
        self._knots += knots

    def tables(self) -> BlendTables:
        """Returns the tables of the states added so far."""
        return locked(
            BlendTables(
                states=_table(self._states, 5, np.int64),
                durations=np.array(self._durations, np.float64),
                bounds=_table(self._bounds, 4, np.float64),
                members=_table(self._members, 5, np.int64),
                places=_table(self._places, 5, np.float64),
                knots=_table([*self._knots, (0.0, 0.0)], 2, np.float64),
            )
        )


def _table(rows: Sequence[object], width: int, kind: type) -> NDArray[Any]:
    return np.array(rows, kind).reshape(-1, width)
