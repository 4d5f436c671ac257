"""Writes clips as glTF animations (glTF 2.0, 3.11)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.files.gltf.builder import Builder
from statwalk.files.gltf.carried import clip_extras, in_extras
from statwalk.files.gltf.check import Json
from statwalk.maths import quat
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip

BAKED_RATE = 60
LARGEST_BAKED_KEYS = 36_000
GLTF_INTERPOLATIONS = ("STEP", "LINEAR", "CUBICSPLINE")


def animation(builder: Builder, character: Character, clip: Clip) -> Json | None:
    """Adds a clip's data; returns the animation, None for a clip without channels, which glTF does not
    allow.
    """
    if not clip.channels:
        return None
    samplers: list[Json] = []
    channels: list[Json] = []
    for channel in gltf_channels(clip):
        samplers.append(sampler(builder, channel))
        target = {"node": int(character.node_index[channel.joint]), "path": channel.path}
        channels.append({"sampler": len(samplers) - 1, "target": target})
    return in_extras({"name": clip.name, "samplers": samplers, "channels": channels}, clip_extras(clip))


def gltf_channels(clip: Clip) -> list[Channel]:
    """Returns the channels of a clip; channels whose interpolation glTF lacks become linear keys."""
    baked = (
        BakedClip(clip)
        if any(channel.interpolation not in GLTF_INTERPOLATIONS for channel in clip.channels)
        else None
    )
    return [
        channel if baked is None or channel.interpolation in GLTF_INTERPOLATIONS else baked.linear(channel)
        for channel in clip.channels
    ]


def sampler(builder: Builder, channel: Channel) -> Json:
    """Adds the keys of a channel; returns the sampler. Rotations are brought to unit length, as glTF requires
    (3.11).
    """
    is_rotation = channel.path == "rotation" and channel.interpolation != "CUBICSPLINE"
    values = np.ascontiguousarray(
        quat.normalize(channel.values) if is_rotation else channel.values, np.float32
    )
    width = 1 if channel.path == "weights" else values.shape[-1]
    return {
        "input": builder.array(
            channel.times if channel.times.dtype == np.float32 else channel.times.astype(np.float32),
            bounds=True,
        ),
        "output": builder.array(values.reshape(-1, width)),
        "interpolation": channel.interpolation,
    }


class BakedClip:
    """A clip sampled 60 times a second (less often if it is very long)."""

    def __init__(self, clip: Clip) -> None:
        count = min(LARGEST_BAKED_KEYS, int(np.ceil(clip.duration * BAKED_RATE)) + 1)
        self.times: NDArray[np.float32] = np.linspace(0, clip.duration, count).astype(np.float32)
        self.poses: Pose = clip.sample(self.times)

    def linear(self, channel: Channel) -> Channel:
        """Returns the channel as linear keys."""
        if channel.path == "weights":
            values = self.poses.weights[
                :, channel.weight_first : channel.weight_first + channel.values.shape[-1]
            ]
        else:
            values = getattr(self.poses, channel.path)[:, channel.joint]
        return Channel(channel.joint, channel.path, self.times, values, "LINEAR", channel.weight_first)
