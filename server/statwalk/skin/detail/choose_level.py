"""Chooses a level of detail: by the error in metres, or by a number or share of vertices."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from statwalk.errors import ContentError
from statwalk.skin.collapses import DetailLevel
from statwalk.skin.detail.coarser import coarser
from statwalk.skin.primitive import Primitive


def coarser_parts(
    parts: Sequence[Primitive],
    levels: Sequence[DetailLevel],
    error: float | None,
    vertices: int | None,
    share: float | None,
) -> tuple[Primitive, ...]:
    """Returns the parts as one of the wishes wants them.

    :raises ContentError: when there are no levels, or as `steps_for`.
    """
    if not levels:
        raise ContentError(
            "the character has no level of detail; statwalk.with_detail or statwalk lod finds it"
        )
    steps = steps_for(parts, levels, error, vertices, share)
    return tuple(coarser(part, steps) for part in parts)


def steps_for(
    parts: Sequence[Primitive],
    levels: Sequence[DetailLevel],
    error: float | None,
    vertices: int | None,
    share: float | None,
) -> int:
    """Returns the number of steps that are made for one of the wishes, the others None: an error of at most
    so many metres, at most so many vertices, or at most a share of the vertices.

    :raises ContentError: when not exactly one wish is given, it is out of its range, or the order does not go
        so far.
    """
    if sum(wish is not None for wish in (error, vertices, share)) != 1:
        raise ContentError("a level of detail is chosen by exactly one of error, vertices and share")
    total = sum(len(part.positions) for part in parts)
    if error is not None:
        if not error >= 0:
            raise ContentError(f"error is {error}; it must be at least 0 metres")
        return max((level.steps for level in levels if level.error <= error), default=0)
    if share is not None:
        if not 0 < share <= 1:
            raise ContentError(f"share is {share}; it must be above 0 and at most 1")
        vertices = int(share * total)
    assert vertices is not None
    return _steps_to(parts, total, vertices)


def _steps_to(parts: Sequence[Primitive], total: int, vertices: int) -> int:
    """The least steps after which at most so many vertices are left."""
    steps = np.sort(np.concatenate([[], *(part.collapses.steps for part in parts if part.collapses)]))
    surplus = total - vertices
    if surplus <= 0:
        return 0
    if surplus > len(steps):
        raise ContentError(
            f"{vertices:,} vertices are too few: the order in which they collapse leaves at least "
            f"{total - len(steps):,} of {total:,}"
        )
    return int(steps[surplus - 1]) + 1
