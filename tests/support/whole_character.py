"""A small character that has every kind of part that a file format may hold or lose, and the comparison of
two characters to the last bit.
"""

from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np
import orjson
from statwalk.character.character import Character
from statwalk.files.gltf import container, read_model
from statwalk.files.gltf.model_textures import ModelTextures
from statwalk.files.gltf.write import model_glb
from statwalk.machine.definition.expression_definition import CLOCKS
from statwalk.machine.definition.expression_lines import read_lines
from statwalk.maths import pose as poses
from statwalk.motion.clip import Channel, Clip, Marker
from statwalk.rig.joint_types import axis_limits, joint
from statwalk.rig.skeleton import Skeleton
from tiny_model import model

PIXEL = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010806000000"
    "1f15c4890000000d49444154789c6360f8cf500f0003860180"
    "5a34ba5c0000000049454e44ae426082"
)
"""a PNG of one pixel"""
TEXTURES = ModelTextures(
    {
        "samplers": [{"magFilter": 9728}],
        "textures": [{"sampler": 0, "source": 0}],
        "images": [{"mimeType": "image/png", "name": "pixel"}],
    },
    (PIXEL,),
)
LINES = ((3, "half = knee.rotate_x / 2"), (4, "hip.rotate_y = half"))


def whole() -> Character:
    """The tiny model with what it lacks: colours, texture, limits, chain, expressions, markers, curves."""
    tiny = read_model(model(), "whole")
    (part,) = tiny.parts
    colours = np.array([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 0.5]], np.float32)
    places = np.array([[0, 0], [1, 0], [0, 1]], np.float32)
    painted = replace(part, material=0, attributes={"COLOR_0": colours, "TEXCOORD_0": places})
    material = {"name": "paint", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
    character = replace(
        tiny,
        parts=(painted,),
        materials=(material,),
        clips={**tiny.clips, "Curves": _curves(tiny)},
        limits={
            "hip": axis_limits(((-1.0, 1.0), (-0.5, 0.5), (0.0, 0.1)), None),
            "knee": joint("helical", {"angle": (-1.0, 2.0)}, pitch=0.25),
        },
        chains={"leg": ("hip", "knee")},
        expressions=read_lines(LINES, (), CLOCKS),
    )
    return replace(character, model_glb=model_glb(character, TEXTURES))


def _curves(tiny: Character) -> Clip:
    times = np.array([0.0, 0.25, 0.5, 1.0])
    ways = np.array([[0, 0, 0], [0, 1, 0], [0, 1, 1], [0, 0, 0.5]])
    tangents = np.stack([ways * 0.1, ways, -ways * 0.1], 1).astype(np.float32)
    channels = (
        Channel(0, "translation", times, ways, "NURBS", key_weights=np.array([1.0, 2, 0.5, 1])),
        Channel(1, "translation", times.astype(np.float32), tangents, "CUBICSPLINE"),
        Channel(1, "scale", times[:1], np.array([[1.0, 2, 1]]), "STEP"),
        Channel(2, "weights", times, np.array([[0.0], [1], [0.5], [0]]), "LINEAR"),
    )
    return Clip("Curves", channels, 1.0, tiny.bind_pose, (Marker("tap", 0.25), Marker("né", 1.0)), loop=True)


def straight(count: int) -> Character:
    """Joints that hang on each other in one line, without a mesh."""
    skeleton = Skeleton(tuple(f"j{row}" for row in range(count)), np.arange(-1, count - 1, dtype=np.int32))
    return Character("straight", skeleton, np.arange(count, dtype=np.int32), poses.rest(count))


def textures_in(data: bytes) -> list[dict[str, Any]]:
    """The images of a .glb."""
    text, _ = container.split(data)
    images: list[dict[str, Any]] = orjson.loads(bytes(text)).get("images", [])
    return images


def difference(ours: Any, theirs: Any, place: str = "character") -> str:
    """Where two characters, or parts of them, are not the same to the last bit; empty: nowhere.

    What the file is called and how it was read (`notes`, `model_glb`, `made`) is left out.
    """
    if isinstance(ours, np.ndarray):
        same = (
            ours.dtype == theirs.dtype and ours.shape == theirs.shape and ours.tobytes() == theirs.tobytes()
        )
        return "" if same else place
    if is_dataclass(ours):
        pairs = {
            entry.name: (getattr(ours, entry.name, None), getattr(theirs, entry.name, None))
            for entry in fields(ours)
            if entry.name not in ("notes", "model_glb", "made", "name")
        }
        if "channels" in pairs:
            pairs["channels"] = (tuple(ours.channels), tuple(theirs.channels))
        return _first(pairs, place)
    if hasattr(ours, "items"):
        if list(ours) != list(theirs):
            return place
        return _first({name: (ours[name], theirs[name]) for name in ours}, place)
    if isinstance(ours, tuple):
        if len(ours) != len(theirs):
            return place
        return _first(dict(enumerate(zip(ours, theirs, strict=True))), place)
    return "" if ours == theirs else place


def _first(pairs: dict[Any, tuple[Any, Any]], place: str) -> str:
    found = (difference(*pair, f"{place}.{name}") for name, pair in pairs.items())
    return next(filter(None, found), "")
