"""Writes clips as AnimationSets: rotation, scale and position keys of each joint that moves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.directx.left_handed import mirrored, rotation_keys
from statwalk.files.directx.x_animation import LAST_TICK, POSITION, ROTATION, SCALE
from statwalk.files.directx.x_number_text import float_words
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip
from statwalk.motion.keys.channel import Path
from statwalk.motion.principles.resample import grid, values_of

KINDS: dict[Path, int] = {"rotation": ROTATION, "scale": SCALE, "translation": POSITION}
RATES = (24, 25, 30, 60, 100, 120, 1_000, 4_800, 48_000)
"""ticks a second that are tried, from the coarsest"""
FINE_RATE, FINEST_RATE = 4_800, 1_000_000
CLOSE = 2e-6
"""seconds by which a key may be moved"""


class _Track(NamedTuple):
    """Keys of one property of a joint: times (K,) in seconds and values (K, n)."""

    path: Path
    times: Floats
    values: Floats


def clip_texts(character: Character, joints: Sequence[str], sets: Sequence[str]) -> Iterator[str]:
    """Yields AnimTicksPerSecond and an AnimationSet for each clip; `joints` and `sets` are the names in the
    file.
    """
    if not character.clips:
        return
    moves = [_Moves(clip) for clip in character.clips.values()]
    rate = _rate_of(moves)
    yield f"AnimTicksPerSecond {{\n{rate};\n}}\n"
    for name, move in zip(sets, moves, strict=True):
        yield f"AnimationSet {name} {{"
        for joint, tracks in move.by_joint(rate):
            options = f"AnimationOptions {{\n{int(not move.clip.loop)};\n1;\n}}"
            yield f"Animation {{\n{{{joints[joint]}}}\n{options}"
            for track in tracks:
                yield _keys_text(track, rate)
            yield "}"
        yield "}\n"


class _Moves:
    """The keys of a clip as a .x file has them: linear, and of all three properties of each joint that
    moves."""

    def __init__(self, clip: Clip) -> None:
        self.clip = clip
        self.tracks: dict[int, dict[Path, Channel]] = {}
        for channel in clip.channels:
            if channel.path != "weights":
                self.tracks.setdefault(channel.joint, {})[channel.path] = channel
        self.jumps = any(channel.interpolation == "STEP" for channel in clip.channels)

    @property
    def times(self) -> Floats:
        """Returns the times of all keys, and the duration."""
        every = [self._key_times(channel) for tracks in self.tracks.values() for channel in tracks.values()]
        return np.concatenate([*every, [self.clip.duration]]).astype(np.float64)

    def by_joint(self, rate: int) -> Iterator[tuple[int, list[_Track]]]:
        """Yields the joints that move with their keys; the first joint's keys last as long as the clip."""
        tracks = self.tracks or {0: {}}
        for number, (joint, channels) in enumerate(sorted(tracks.items())):
            made = [self._track(joint, path, channels.get(path), rate) for path in KINDS]
            yield joint, [self._held(track) if number == 0 else track for track in made]

    def _held(self, track: _Track) -> _Track:
        if track.times[-1] >= self.clip.duration:
            return track
        return track._replace(
            times=np.append(track.times, self.clip.duration),
            values=np.concatenate([track.values, track.values[-1:]]),
        )

    @cached_property
    def _grid(self) -> Floats:
        return grid(self.clip)

    @cached_property
    def _poses(self) -> Pose:
        return self.clip.sample(self._grid)

    def _key_times(self, channel: Channel) -> Floats:
        return channel.times if channel.interpolation in ("STEP", "LINEAR") else self._grid

    def _track(self, joint: int, path: Path, channel: Channel | None, rate: int) -> _Track:
        if channel is None:
            return _Track(path, np.zeros(1), getattr(self.clip.rest, path)[joint : joint + 1])
        times = self._key_times(channel).astype(np.float64)
        if channel.interpolation == "LINEAR":
            return _Track(path, times, channel.values)
        if channel.interpolation != "STEP":
            return _Track(path, times, values_of(channel, self._poses))
        before = np.maximum(times[1:] - 1 / rate, times[:-1])
        places = np.arange(2 * len(times) - 1)
        return _Track(path, np.insert(times, places[1 : len(times)], before), channel.values[places // 2])


def _rate_of(moves: Sequence[_Moves]) -> int:
    """Returns the coarsest ticks a second that hold the times of all keys, or the finest that a file can."""
    times = np.unique(np.concatenate([move.times for move in moves]))
    least = FINE_RATE if any(move.jumps for move in moves) else 1
    finest = int(min(FINEST_RATE, LAST_TICK / max(float(times[-1]), 1.0)))
    if finest < 1:
        raise ContentError(f"a clip lasts {times[-1]:g} s; a .x file counts to {LAST_TICK} ticks")
    fitting = (rate for rate in RATES if least <= rate <= finest and _rounding(times, rate) <= CLOSE)
    return next(fitting, finest)


def _rounding(times: Floats, rate: int) -> float:
    return float(np.abs(np.round(times * rate) / rate - times).max())


def _keys_text(track: _Track, rate: int) -> str:
    """Returns an AnimationKey; of keys in the same tick the last counts."""
    ticks = np.round(track.times * rate).astype(np.int64)
    kept = np.flatnonzero(np.append(ticks[1:] != ticks[:-1], True))
    values: Floats = track.values[kept].astype(np.float64)
    if track.path == "rotation":
        values = rotation_keys(quat.normalize(values))
    elif track.path == "translation":
        values = mirrored(values)
    words, width = iter(float_words(values)), values.shape[1]
    rows = zip(ticks[kept].tolist(), zip(*(words,) * width, strict=True), strict=True)
    lines = ";;,\n".join(f"{tick};{width};{','.join(row)}" for tick, row in rows)
    return f"AnimationKey {{\n{KINDS[track.path]};\n{len(kept)};\n{lines};;;\n}}"
