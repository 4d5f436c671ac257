"""Root motion: what a clip does to the character's place and heading is taken out of the pose and moves the actor instead.

A place is a row x, z (metres), yaw (radians about +Y; a turn to the left is positive, +Z is forward). The root joint keeps its
height, pitch and roll. A motion that is played once gives all its way to the root; of one that loops the root takes the even part,
a straight line or an arc of constant speed, and the sway about it stays in the pose, so that the heading does not wag.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from statwalk.maths import quat, transform
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.elementary import atan2, sin, sincos
from statwalk.motion.channel import Channel
from statwalk.motion.clip import Clip

SAMPLES_PER_SECOND = 240  # of the root's channels in the clip without its root motion
_UP = np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True, eq=False)
class RootTrack:
    """Where the root of a motion is at which time; straight between its times."""

    times: Floats
    """(K,) float64 seconds"""
    places: Floats
    """(K, 3) float64: x, z, yaw"""

    def at(self, times: Floats) -> Floats:
        """Places (N, 3) at `times` (N,) seconds; beyond the ends the ends."""
        if len(self.times) == 1:
            standing: Floats = self.places.repeat(len(times), 0)
            return standing
        key = (self.times.searchsorted(times, "right") - 1).clip(0, len(self.times) - 2)
        part = (times - self.times[key]) / (self.times[key + 1] - self.times[key])
        start = self.places[key]
        here: Floats = start + (self.places[key + 1] - start) * part.clip(0, 1)[:, None]
        return here

    def displacement(self, start: Floats, end: Floats, wraps: Ints) -> Floats:
        """From `start` to `end` (N,) seconds through `wraps` (N,) repeats: x, z, yaw (N, 3) in the frame of the actor at `start`."""
        origin, now = self.at(start), self.at(end)
        if not wraps.any():
            return relative(origin, now)
        first, last = self.places[:1], self.places[-1:]
        way = relative(origin, np.where(wraps[:, None] > 0, last, now))
        for done in range(1, int(wraps.max()) + 1):
            lap = relative(first, np.where((wraps == done)[:, None], now, last))
            way = np.where((wraps >= done)[:, None], compose(way, lap), way)
        return way


STANDING = RootTrack(np.zeros(1), np.zeros((1, 3)))


def compose(place: Floats, way: Floats) -> Floats:
    """Where one is after `way` (N, 3), given in the frame of `place` (N, 3)."""
    sine, cosine = sincos(place[:, 2])
    x, z = way[:, 0], way[:, 1]
    return place + np.stack([x * cosine + z * sine, z * cosine - x * sine, way[:, 2]], -1)


def relative(origin: Floats, place: Floats) -> Floats:
    """`place` (N, 3) in the frame of `origin` (N, 3)."""
    way = place - origin
    sine, cosine = sincos(origin[:, 2])
    x, z = way[:, 0], way[:, 1]
    return np.stack([x * cosine - z * sine, z * cosine + x * sine, way[:, 2]], -1)


def extract(clip: Clip, joint: int, loop: bool, frame: Floats | None = None) -> tuple[Clip, RootTrack]:
    """The clip with `joint` in place, and the way it would have gone.

    `frame` (3, 4): where the joint's parent stands in the character's space (default: it has none). No keys on the joint: no way.
    """
    if all(channel.joint != joint for channel in clip.channels) or clip.duration <= 0:
        return clip, STANDING
    frame = transform.from_trs(np.zeros(3), quat.IDENTITY, np.ones(3)) if frame is None else frame
    times = _times(clip, joint)
    pose = clip.sample(times)
    position = transform.apply(frame, pose.translation[:, joint].astype(np.float64))
    turn = quat.mul(_rotation_of(frame), pose.rotation[:, joint].astype(np.float64))
    rest = quat.mul(_rotation_of(frame), clip.rest.rotation[joint].astype(np.float64))
    places = np.concatenate([position[:, ::2], _yaw(quat.mul(turn, quat.conjugate(rest)))[:, None]], -1)
    path = _even(times / clip.duration, places) if loop else places
    in_place = _in_place(clip, joint, frame, times, (position, turn, path))
    return in_place, RootTrack(times, path)


def _times(clip: Clip, joint: int) -> Floats:
    """The joint's own key times and a fine grid between them, as float32 can tell them apart."""
    keys = [channel.times for channel in clip.channels if channel.joint == joint]
    grid = np.arange(0, clip.duration, 1 / SAMPLES_PER_SECOND)
    every = np.unique(np.concatenate([grid, [clip.duration], *keys]).astype(np.float32))
    return every.astype(np.float64)


def _rotation_of(frame: Floats) -> Floats:
    """The rotation (4,) of a matrix T·R·S (3, 4)."""
    columns = frame[:, :3]
    lengths = np.sqrt(columns[0] * columns[0] + columns[1] * columns[1] + columns[2] * columns[2])
    return quat.from_matrix(columns / lengths)


def _yaw(turn: Floats) -> Floats:
    """The twist about +Y of rotations (K, 4), radians without jumps of a whole turn."""
    half = np.unwrap(atan2(turn[:, 1], turn[:, 3]), period=np.pi)
    return 2 * half


def _even(part: Floats, places: Floats) -> Floats:
    """The arc of constant speed and turn from the first place to the last, at `part` (K,) 0…1 of the way."""
    first, last = places[:1], places[-1:]
    whole = relative(first, last)
    x, z, yaw = whole[0]
    half = yaw / 2
    is_straight = abs(sin(half)) < 1e-9
    chord = part if is_straight else sin(part * half) / sin(half)
    sine, cosine = sincos((part - 1) * half)
    way = np.stack([(x * cosine + z * sine) * chord, (z * cosine - x * sine) * chord, yaw * part], -1)
    return compose(first.repeat(len(part), 0), way)


def _in_place(clip: Clip, joint: int, frame: Floats, times: Floats, moving: tuple[Floats, Floats, Floats]) -> Clip:
    """The clip with the joint's translation and rotation seen from the path: `moving` is position, rotation and path."""
    position, turn, path = moving
    seen = relative(path, np.concatenate([position[:, ::2], path[:, 2:]], -1))
    still = np.stack([seen[:, 0], position[:, 1], seen[:, 1]], -1)
    back = quat.from_axis_angle(_UP, -path[:, 2])
    rotation = quat.mul(quat.conjugate(_rotation_of(frame)), quat.mul(back, turn))
    translation = transform.apply(transform.invert(frame), still)
    keys = times.astype(np.float32)
    ours = (
        Channel(joint, "translation", keys, translation.astype(np.float32)),
        Channel(joint, "rotation", keys, rotation.astype(np.float32)),
    )
    others = tuple(channel for channel in clip.channels if channel.joint != joint or channel.path in ("scale", "weights"))
    return replace(clip, channels=(*ours, *others))
