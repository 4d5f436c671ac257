"""Animations: channels and samplers as clips (glTF 2.0, 3.11)."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, cast

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.glb import check
from statwalk.files.glb.accessors import Accessors
from statwalk.files.glb.allowance import Allowance, key_numbers
from statwalk.files.glb.check import Json
from statwalk.files.glb.document import Document
from statwalk.files.glb.formats import MORPH_WEIGHTS, ROTATIONS, TRANSLATIONS, VECTORS, Allowed
from statwalk.files.glb.keytimes import KeyTimes, TimeTable
from statwalk.files.glb.names import unique
from statwalk.files.glb.plain_clips import plain_tables
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip, duration_of
from statwalk.motion.keytable import KeyTable

FORMATS: dict[str, Allowed] = {"translation": TRANSLATIONS, "rotation": ROTATIONS, "scale": VECTORS, "weights": MORPH_WEIGHTS}
INTERPOLATIONS = ("LINEAR", "STEP", "CUBICSPLINE")
Path = Literal["translation", "rotation", "scale", "weights"]
Interpolation = Literal["STEP", "LINEAR", "CUBICSPLINE"]


@dataclass
class Animations:
    """The animations of a document; `weight_span` says where each node's morph weights are in a pose."""

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
        """Every animation as a clip, by its name made unique, in the order of the file."""
        entries = self.document["animations"]
        plain = plain_tables(entries, self.accessors, self.times, self.joint_of, self.numbers)
        names = unique(check.labels(entries, "/animations"), "clip")
        return {
            name: self.clip(name, entry, f"/animations/{row}", plain.get(row))
            for row, (name, entry) in enumerate(zip(names, entries, strict=True))
        }

    def clip(self, name: str, entry: Json, place: str, plain: KeyTable | None) -> Clip:
        """One animation, with its channels where they are plain."""
        if plain is not None:
            return Clip(name, plain, plain.duration(), self.rest)
        channels = self.channels(entry, place)
        return Clip(name, channels, duration_of(channels), self.rest)

    def channels(self, entry: Json, place: str) -> tuple[Channel, ...]:
        """The channels one by one. Those that nothing here understands are left out, and noted."""
        samplers = check.objects(entry, "samplers", place)
        found: dict[tuple[int, str], Channel] = {}
        for row, channel in enumerate(check.objects(entry, "channels", place)):
            made = self.channel(channel, samplers, place, f"{place}/channels/{row}")
            if made is not None and (made.joint, made.path) in found:
                self.document.note("two channels of an animation move the same property; the first counts")
            elif made is not None:
                found[made.joint, made.path] = made
        return tuple(found.values())

    def channel(self, entry: Json, samplers: list[Json], animation: str, place: str) -> Channel | None:
        """One channel; None where it has no node or moves a property that is unknown or not there."""
        row = check.required_reference(entry, "sampler", place, samplers, "sampler of this animation")
        sampler, where = samplers[row], f"{animation}/samplers/{row}"
        target = check.as_object(entry.get("target"), f"{place}/target")
        node = check.reference(target, "node", f"{place}/target", self.nodes, "node")
        path = check.text(target, "path", f"{place}/target")
        first, count = self.weight_span.get(-1 if node is None else node, (0, 0))
        if node is None or path not in FORMATS or (path == "weights" and not count):
            self.document.note(f"animation channels for {check.shown(path)} of nothing that has it are left out")
            return None
        kind = check.one_of(sampler, "interpolation", where, INTERPOLATIONS, "LINEAR")
        keys = self.times.read(check.required_reference(sampler, "input", where, self.entries, "accessor"), f"{where}/input")
        width = count if path == "weights" else 1
        values = self.values(sampler, path, kind, keys, width, where)
        return Channel.checked(int(self.joint_of[node]), cast("Path", path), keys.times, values, cast("Interpolation", kind), first)

    def values(self, sampler: Json, path: str, kind: str, keys: KeyTimes, width: int, place: str) -> NDArray[np.float32]:
        """(K,n) key values, or (K,3,n) of a cubic spline: in-tangent, value, out-tangent."""
        row = check.required_reference(sampler, "output", place, self.entries, "accessor")
        values = self.accessors.floats(row, FORMATS[path], f"{place}/output")
        given = len(keys.times) if keys.keys is None else len(self.accessors.array(sampler["input"]))
        expected = given * width * (3 if kind == "CUBICSPLINE" else 1)
        if len(values) != expected:
            raise ModelError(f"it has {len(values)} elements; {given} keys need {expected}", place=f"{place}/output")
        self.numbers.take(values.size, f"{place}/output")
        if path == "weights":
            values = values.reshape(-1, width)
        if kind == "CUBICSPLINE":
            values = values.reshape(given, 3, -1)
        return values if keys.keys is None else values[keys.keys]
