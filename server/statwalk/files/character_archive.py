"""A checked character as one file: the arrays of a Character in NumPy's .npz, and a JSON tree of the objects
that the arrays belong to. Expressions are kept as text.

The process that reads an uploaded model writes the file, so that no other process has to read the model
again. The reader builds only the classes listed here, and no array may hold objects: the file can contain
numbers and names, nothing else.
"""

from __future__ import annotations

import json
import zipfile
from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.machine.definition.expression_lines import read_lines
from statwalk.maths.clamp_table import JointLimit
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel, Marker
from statwalk.motion.keys.channel_table import ChannelTable, ClipChannels
from statwalk.motion.keys.key_times import KeyTimes
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.bulge import Bulge
from statwalk.skin.collapses import Collapses, DetailLevel
from statwalk.skin.face_muscles import Muscle
from statwalk.skin.primitive import Primitive, Skin

FORMAT = 8
"""increase when a field of one of the classes changes: files of an older format are then written again"""
_TREE = "tree"
_OWN_FILE = "model_glb"
_COLLECTIONS: dict[str, type] = {"list": list, "tuple": tuple, "frozenset": frozenset}
"""sets are of names, written in their order"""
_CLASSES: dict[str, type] = {
    kind.__name__: kind
    for kind in (
        Bulge,
        Channel,
        Character,
        Clip,
        ClipChannels,
        Collapses,
        DetailLevel,
        JointLimit,
        KeyTimes,
        Marker,
        Muscle,
        Pose,
        Primitive,
        ChannelTable,
        Skeleton,
        Skin,
    )
}


def write_character(character: Character, file: Path) -> None:
    """Writes a character, without its .glb, to `file`."""
    writer = _Writer()
    lines = [[line.line, line.text] for line in character.expressions]
    root = writer.value(replace(character, expressions=()))
    content = {"format": FORMAT, "objects": writer.objects, "root": root, "expressions": lines}
    tree = json.dumps(content).encode()
    with file.open("wb") as opened:
        np.savez(opened, **{_TREE: np.frombuffer(tree, np.uint8)}, **writer.arrays)  # type: ignore[arg-type]


def read_character(file: Path, model_glb: bytes) -> Character:
    """Reads the character that `write_character` wrote, and adds its .glb.

    :raises ContentError: when the file is missing, damaged or of another format.
    """
    try:
        with file.open("rb") as opened, np.load(opened, allow_pickle=False) as arrays:
            tree = json.loads(arrays[_TREE].tobytes())
            if tree["format"] != FORMAT:
                raise ContentError(
                    "this checked character was written by another version of statwalk", file=str(file)
                )
            character = _Reader(tree["objects"], arrays).value(tree["root"])
            lines = read_lines([(line, text) for line, text in tree["expressions"]], ())
    except (OSError, EOFError, KeyError, TypeError, ValueError, zipfile.BadZipFile) as error:
        raise ContentError(f"this is no checked character: {error}", file=str(file)) from None
    if not isinstance(character, Character):
        raise ContentError("this is no checked character", file=str(file))
    return replace(character, model_glb=model_glb, expressions=lines)


class _Writer:
    """Turns objects into a tree; an object or array that is referred to several times is written once."""

    def __init__(self) -> None:
        self.arrays: dict[str, NDArray[Any]] = {}
        self.objects: list[Any] = []
        self.numbers: dict[int, dict[str, Any]] = {}
        self.kept: list[object] = []

    def value(self, value: object) -> Any:
        if value is None or isinstance(value, str | bool | int | float):
            return value
        if isinstance(value, np.integer | np.floating):
            return value.item()
        if id(value) not in self.numbers:
            node = self._node(value)
            self.kept.append(value)  # keeps the object alive: otherwise another object could get its id
            self.numbers[id(value)] = node
        return self.numbers[id(value)]

    def _node(self, value: Any) -> dict[str, Any]:
        if isinstance(value, np.ndarray):
            name = f"a{len(self.arrays)}"
            self.arrays[name] = value
            return {"array": name, "writable": bool(value.flags.writeable)}
        if type(value).__name__ in _CLASSES:
            entry = [type(value).__name__, {name: self.value(part) for name, part in _parts(value).items()}]
        elif isinstance(value, Mapping):
            entry = ["map", {str(name): self.value(part) for name, part in value.items()}]
        elif isinstance(value, list | tuple):
            entry = [type(value).__name__, [self.value(part) for part in value]]
        elif isinstance(value, frozenset):
            entry = ["frozenset", sorted(value)]
        else:
            raise TypeError(f"a character holds a {type(value).__name__}, which the archive cannot write")
        self.objects.append(entry)
        return {"object": len(self.objects) - 1}


def _parts(value: Any) -> dict[str, Any]:
    """Returns the constructor's arguments of an object of a listed class."""
    if is_dataclass(value):
        return {part.name: getattr(value, part.name) for part in fields(value) if part.name != _OWN_FILE}
    if isinstance(value, KeyTimes):
        return {"times": value.times}
    arguments: dict[str, Any] = value._asdict()
    return arguments


class _Reader:
    """Builds each object of a tree once. An object only refers to objects that stand before it."""

    def __init__(self, contents: list[Any], arrays: Any) -> None:
        self.arrays = arrays
        self.loaded: dict[str, NDArray[Any]] = {}
        self.built: list[Any] = []
        for kind, parts in contents:
            self.built.append(self._build(kind, parts))

    def value(self, node: Any) -> Any:
        if not isinstance(node, dict):
            return node
        return (
            self.built[node["object"]] if "object" in node else self._array(node["array"], node["writable"])
        )

    def _array(self, name: str, writable: bool) -> NDArray[Any]:
        if name not in self.loaded:
            self.loaded[name] = self.arrays[name]
            self.loaded[name].flags.writeable = writable
        return self.loaded[name]

    def _build(self, kind: str, parts: Any) -> Any:
        if kind in _COLLECTIONS:
            return _COLLECTIONS[kind](self.value(part) for part in parts)
        fields_by_name = {name: self.value(part) for name, part in parts.items()}
        return fields_by_name if kind == "map" else _CLASSES[kind](**fields_by_name)
