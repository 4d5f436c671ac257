"""Reads animations: channels and samplers become clips (glTF 2.0, 3.11)."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, cast

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.accessors import Accessors
from statwalk.files.gltf.allowance import Allowance, key_numbers
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.formats import MORPH_WEIGHTS, ROTATIONS, TRANSLATIONS, VECTORS, Allowed
from statwalk.files.gltf.key_times import SamplerTimes, TimeTable
from statwalk.files.gltf.names import unique
from statwalk.files.gltf.plain_clips import plain_tables
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip, duration_of
from statwalk.motion.keys.channel_table import ClipChannels

FORMATS: dict[str, Allowed] = {
    "translation": TRANSLATIONS,
    "rotation": ROTATIONS,
    "scale": VECTORS,
    "weights": MORPH_WEIGHTS,
}
INTERPOLATIONS = ("LINEAR", "STEP", "CUBICSPLINE")
Path = Literal["translation", "rotation", "scale", "weights"]
Interpolation = Literal["STEP", "LINEAR", "CUBICSPLINE"]


@dataclass
class Animations:
    """The animations of a document; `weight_span` is (first, count) of each node's morph weights in a
    pose.
    """

    document: Document
    accessors: Accessors
    joint_of: NDArray[np.int32]
    weight_span: dict[int, tuple[int, int]]
    rest: Pose
    numbers: Allowance = field(default_factory=key_numbers)

    def __post_init__(self) -> None:
        self.nodes, self.entries = self.document["nodes"], self.document["accessors"]
        self.times = TimeTable(self.accessors)

    def clips(self) -> dict[str, Clip]:
        """Returns every animation as a clip, by its name made unique, in the order of the file."""
        entries = self.document["animations"]
        plain = plain_tables(entries, self.accessors, self.times, self.joint_of, self.numbers)
        names = unique(check.labels(entries, "/animations"), "clip")
        return {
            name: self.clip(name, entry, f"/animations/{row}", plain.get(row))
            for row, (name, entry) in enumerate(zip(names, entries, strict=True))
        }

    def clip(self, name: str, entry: Json, place: str, plain: ClipChannels | None) -> Clip:
        """Returns an animation as a clip; `plain` are its channels if all of them are plain."""
        if plain is not None:
            return Clip(name, plain, plain.duration(), self.rest)
        channels = self.channels(entry, place)
        return Clip(name, channels, duration_of(channels), self.rest)

    def channels(self, entry: Json, place: str) -> tuple[Channel, ...]:
        """Returns the channels of an animation; channels that cannot be applied are left out, with a note."""
        samplers = check.objects(entry, "samplers", place, required=True)
        read_channels: dict[tuple[int, str], Channel] = {}
        for row, channel in enumerate(check.objects(entry, "channels", place, required=True)):
            read_channel = self.channel(channel, samplers, place, f"{place}/channels/{row}")
            if read_channel is not None and (read_channel.joint, read_channel.path) in read_channels:
                self.document.note("two channels of an animation move the same property; the first is used")
            elif read_channel is not None:
                read_channels[read_channel.joint, read_channel.path] = read_channel
        return tuple(read_channels.values())

    def channel(self, entry: Json, samplers: list[Json], animation: str, place: str) -> Channel | None:
        """Returns a channel; None if it has no node, or its property is unknown or missing."""
        row = check.required_reference(entry, "sampler", place, samplers, "sampler of this animation")
        sampler, where = samplers[row], f"{animation}/samplers/{row}"
        target = check.as_object(entry.get("target"), f"{place}/target")
        node = check.reference(target, "node", f"{place}/target", self.nodes, "node")
        path = check.text(target, "path", f"{place}/target")
        first, count = self.weight_span.get(-1 if node is None else node, (0, 0))
        if node is None or path not in FORMATS or (path == "weights" and not count):
            self.document.note(
                f"animation channels for {check.shown(path)} are left out, because they have no node with "
                "this property"
            )
            return None
        interpolation = check.one_of(sampler, "interpolation", where, INTERPOLATIONS, "LINEAR")
        keys = self.times.read(
            check.required_reference(sampler, "input", where, self.entries, "accessor"), f"{where}/input"
        )
        width = count if path == "weights" else 1
        values = self.values(sampler, path, interpolation, keys, width, where)
        return Channel.checked(
            int(self.joint_of[node]),
            cast("Path", path),
            keys.times,
            values,
            cast("Interpolation", interpolation),
            first,
        )

    def values(
        self, sampler: Json, path: str, interpolation: str, keys: SamplerTimes, width: int, place: str
    ) -> NDArray[np.float32]:
        """Returns the key values (K,n), or (K,3,n) of a cubic spline: in-tangent, value, out-tangent.

        :raises ModelError: when the number of values does not match the number of keys.
        """
        row = check.required_reference(sampler, "output", place, self.entries, "accessor")
        values = self.accessors.floats(row, FORMATS[path], f"{place}/output")
        key_count = len(keys.times) if keys.keys is None else len(self.accessors.array(sampler["input"]))
        expected = key_count * width * (3 if interpolation == "CUBICSPLINE" else 1)
        if len(values) != expected:
            raise ModelError(
                f"the output has {len(values)} elements; {key_count} keys need {expected}",
                place=f"{place}/output",
            )
        self.numbers.take(values.size, f"{place}/output")
        if path == "weights":
            values = values.reshape(-1, width)
        if interpolation == "CUBICSPLINE":
            values = values.reshape(key_count, 3, -1)
        return values if keys.keys is None else values[keys.keys]
