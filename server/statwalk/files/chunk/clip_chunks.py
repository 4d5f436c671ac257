"""The clips: an ANIM chunk for each, with its markers and the keys of its channels."""

from __future__ import annotations

from dataclasses import dataclass, field

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.chunk.array_pool import ArrayPool, PoolWriter, below
from statwalk.files.chunk.chunk_tree import Chunk, ChunkReader, joined, refuse
from statwalk.files.chunk.records import ANIM, CHAN, INTERPOLATIONS, MARK, PATHS
from statwalk.files.gltf.allowance import Allowance, key_numbers
from statwalk.files.gltf.check import LATEST
from statwalk.motion.clip import Channel, Clip, Marker

FLOATS = "f4 f8"
PLAIN = ("STEP", "LINEAR", "CUBICSPLINE")
ROUNDING = 1e-6
"""of the duration: how far its last key, as a 32-bit float, may lie beyond it"""


def clip_chunk(pool: PoolWriter, name: str, clip: Clip) -> bytes:
    """Returns the ANIM chunk of a clip."""
    markers = [joined("MARK", MARK.pack(marker.time) + marker.name.encode()) for marker in clip.markers]
    channels = [_channel_chunk(pool, channel) for channel in clip.channels]
    record = ANIM.pack(clip.duration, int(clip.loop))
    return joined("ANIM", record, joined("NAME", name.encode()), *markers, *channels)


def _channel_chunk(pool: PoolWriter, channel: Channel) -> bytes:
    kinds = PATHS.index(channel.path), INTERPOLATIONS.index(channel.interpolation)
    arrays = (channel.times, channel.values, getattr(channel, "key_weights", None))
    rows = (pool.add(values) for values in arrays)
    return joined("CHAN", CHAN.pack(channel.joint, *kinds, channel.weight_first, *rows))


@dataclass
class ClipReader:
    """Reads ANIM chunks; counts the numbers of keys, which many channels may share."""

    reader: ChunkReader
    pool: ArrayPool
    character: Character
    """without clips"""
    clips: dict[str, Clip] = field(default_factory=dict)
    numbers: Allowance = field(default_factory=key_numbers)

    def take(self, chunk: Chunk) -> None:
        """Reads a clip.

        :raises ModelError: when a name occurs twice, or a marker, a time or a channel is wrong.
        """
        duration, loop = chunk.record(ANIM)
        name, inside = self.reader.name(chunk, ANIM.size, ("MARK", "CHAN"))
        if name in self.clips or loop > 1 or not 0 <= duration <= LATEST:
            raise refuse(
                chunk, f"a clip has a name of its own and a duration from 0 on; {name[:60]!r} has not"
            )
        markers = tuple(_marker(part, duration) for part in inside if part.tag == "MARK")
        channels = tuple(self._channel(part) for part in inside if part.tag == "CHAN")
        if any(float(channel.times[-1]) > duration * (1 + ROUNDING) for channel in channels):
            raise refuse(chunk, f"a key of {name[:60]!r} comes after its end at {duration:g} s")
        clip = Clip(name, channels, duration, self.character.bind_pose, markers, bool(loop))
        self._check(chunk, clip)
        self.clips[name] = clip

    def _channel(self, chunk: Chunk) -> Channel:
        joint, path, interpolation, first, *arrays = chunk.record(CHAN)
        below(chunk, joint, len(self.character.skeleton), "the joint")
        below(chunk, path, len(PATHS), "the path")
        below(chunk, interpolation, len(INTERPOLATIONS), "the interpolation")
        times = self.pool.array(chunk, arrays[0], "the times", FLOATS, (None,))
        is_cubic = INTERPOLATIONS[interpolation] == "CUBICSPLINE"
        shape = (len(times), 3, None) if is_cubic else (len(times), None)
        values = self.pool.array(chunk, arrays[1], "the values", FLOATS, shape)
        weights = self.pool.optional(chunk, arrays[2], "the weights of keys", FLOATS, (len(times),))
        self.numbers.take(values.size + len(times), f"byte {chunk.place}")
        if not values.size or float(times[0]) < 0:
            raise refuse(chunk, "a channel has keys, and the first is at 0 s or later")
        if PATHS[path] == "weights":
            room = len(self.character.bind_pose.weights) - values.shape[-1] + 1
            below(chunk, first, room, "the first morph weight")
        try:
            return Channel(joint, PATHS[path], times, values, INTERPOLATIONS[interpolation], first, weights)
        except ContentError as error:
            raise refuse(chunk, error.message) from None

    def _check(self, chunk: Chunk, clip: Clip) -> None:
        """Refuses a clip that cannot be sampled."""
        moved = [(channel.joint, channel.path) for channel in clip.channels]
        if len(set(moved)) < len(moved):
            raise refuse(chunk, f"two channels of {clip.name[:60]!r} move the same property")
        if all(channel.interpolation in PLAIN for channel in clip.channels):
            return
        try:
            clip.tracks  # noqa: B018 - refuses a B-spline that cannot pass through its keys
        except ContentError as error:
            raise refuse(chunk, error.message) from None


def _marker(chunk: Chunk, duration: float) -> Marker:
    (time,) = chunk.record(MARK)
    if not 0 <= time <= duration:
        raise refuse(chunk, f"a marker is at {time:g} s; the clip lasts {duration:g} s")
    return Marker(chunk.text(MARK.size), time)
