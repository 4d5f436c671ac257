"""Draws an actor of a stage at some ticks of its past as stick figures."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from statwalk.errors import StageError, UnknownNameError
from statwalk.files.film_strip import MOST_PICTURES
from statwalk.files.skeleton_svg import Side, skeleton_svg
from statwalk.maths.pose import Pose
from statwalk.stage.stage import Stage
from statwalk.stage.state.frame import CastFrame


def stick_figures(stage: Stage, actor: int, ticks: Sequence[int], side: Side) -> str:
    """Returns an SVG of the actor at each tick, in the order of the ticks; moves the stage.

    :raises StageError: when the stage does not have a tick, or the ticks are too many.
    :raises UnknownNameError: when the actor is not on the stage at a tick.
    """
    if len(ticks) > MOST_PICTURES:
        raise StageError(f"{len(ticks)} ticks are too many; a strip has at most {MOST_PICTURES} pictures")
    found: list[tuple[CastFrame, int]] = []
    for tick in ticks:
        stage.seek(tick)
        found.append(_cast_of(stage, actor))
    character = found[0][0].role.character
    poses = (cast.pose.take(row) for cast, row in found)
    batch = Pose(*(np.stack(arrays) for arrays in zip(*poses, strict=True)))
    return skeleton_svg(character, batch, [f"tick {tick}" for tick in ticks], side)


def _cast_of(stage: Stage, actor: int) -> tuple[CastFrame, int]:
    for cast in stage.frame.casts:
        rows = np.flatnonzero(cast.ids == actor)
        if len(rows):
            return cast, int(rows[0])
    ids = [str(one) for cast in stage.frame.casts for one in cast.ids.tolist()]
    raise UnknownNameError("actor", str(actor), ids)
