"""Draws a character's skeleton at rest, or a clip at several times as a film strip, as SVG."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.skeleton_svg import SIDES, Side, skeleton_svg
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose

MOST_PICTURES = 60


def film_strip(
    character: Character, clip: str = "", times: Sequence[float] = (), frames: int = 0, side: Side = "right"
) -> str:
    """Returns an SVG of stick figures: a clip at `times` (seconds), or at as many times as `frames` says,
    evenly from its start to its end; without a clip the pose at rest.

    :raises UnknownNameError: when the character has no clip of that name.
    :raises ContentError: when times have no clip, times and frames are both given, or the pictures are too
        many.
    """
    if side not in SIDES:
        raise ContentError(f"no side is called {side[:40]!r}; there are: {', '.join(SIDES)}")
    if not clip:
        if times or frames:
            raise ContentError(f"times and frames need a clip; there are: {', '.join(character.clips)[:400]}")
        return skeleton_svg(character, _as_batch(character.bind_pose), ["at rest"], side)
    moments = _moments(character.clip(clip).duration, times, frames)
    poses = character.clip(clip).sample(moments)
    return skeleton_svg(character, poses, [f"{clip} {time:.2f} s" for time in moments], side)


def _as_batch(pose: Pose) -> Pose:
    return Pose(*(np.asarray(part)[None] for part in pose))


def _moments(duration: float, times: Sequence[float], frames: int) -> Floats:
    if times and frames:
        raise ContentError("give either the times or the number of frames, not both")
    if max(len(times), frames) > MOST_PICTURES:
        raise ContentError(
            f"{max(len(times), frames)} pictures are too many; a strip has at most {MOST_PICTURES}"
        )
    if not np.isfinite(np.array(times, np.float64)).all():
        raise ContentError("the times must be finite numbers of seconds")
    return np.array(times, np.float64) if times else np.linspace(0, duration, max(1, frames))
