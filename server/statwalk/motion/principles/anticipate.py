"""Anticipation: a small counter-motion before the move."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.easing import smoothstep
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel
from statwalk.motion.principles.chosen_joints import check_joints
from statwalk.motion.principles.resample import PER_SECOND, grid, line, values_of

MOST_AMOUNT, MOST_SECONDS = 2.0, 10.0


def anticipate(clip: Clip, amount: float, seconds: float, joints: Collection[int] | None = None) -> Clip:
    """Returns the clip with `seconds` of counter-motion before it: the pose moves against the way that the
    clip goes in its own first `seconds`, `amount` times as far, and leaves it over the same time.

    Both ways start and end at rest (smoothstep). Scales, weights and held keys only wait. `joints`: rows of
    the joints that take part; None: all. The clip no longer repeats.

    :raises ContentError: when `amount` is not 0 to 2, `seconds` not above 0 and up to 10, or there is no such
        joint.
    """
    check_joints(clip, joints or ())
    if not (0 <= amount <= MOST_AMOUNT and 0 < seconds <= MOST_SECONDS):
        raise ContentError(
            f"an anticipation should have an amount of 0 to {MOST_AMOUNT:g} and up to {MOST_SECONDS:g} "
            f"seconds, it has {amount:g} and {seconds:g}"
        )
    before = np.linspace(0, seconds, int(np.ceil(seconds * PER_SECOND)) + 1)[:-1]
    times = np.concatenate([before, seconds + grid(clip)])
    own = np.maximum(times - seconds, 0)
    poses, ahead = clip.sample(own), clip.sample(np.array([0.0, min(seconds, clip.duration)]))
    share = amount * np.where(times < seconds, smoothstep(times / seconds), 1 - smoothstep(own / seconds))

    def prepared(channel: Channel) -> Channel:
        if channel.interpolation == "STEP":
            return replace(channel, times=(channel.times + seconds).astype(np.float32))
        values = values_of(channel, poses)
        if channel.path in ("translation", "rotation") and (joints is None or channel.joint in joints):
            values = _countered(values, values_of(channel, ahead), share, channel.path == "rotation")
        return line(channel, times, values)

    markers = tuple(marker._replace(time=marker.time + seconds) for marker in clip.markers)
    channels = tuple(prepared(channel) for channel in clip.channels)
    return replace(clip, channels=channels, duration=clip.duration + seconds, markers=markers, loop=False)


def _countered(values: Floats, ahead: Floats, share: Floats, is_turn: bool) -> Floats:
    """Values (K, n) moved by `share` (K,) times the way back from ahead[1] to ahead[0]."""
    exact, (start, end) = values.astype(np.float64), ahead.astype(np.float64)
    if not is_turn:
        return np.asarray(exact + share[:, None] * (start - end))
    way = quat.to_rotation_vector(quat.mul(quat.conjugate(end), start))
    return quat.mul(exact, quat.from_rotation_vector(share[:, None] * way))
