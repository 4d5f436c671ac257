"""Materials and textures: glTF's JSON objects, and the bytes of the images."""

from __future__ import annotations

from typing import Any

import orjson

from statwalk.errors import ContentError
from statwalk.files.chunk.chunk_tree import Chunk, ChunkReader, joined, refuse
from statwalk.files.chunk.records import Tag
from statwalk.files.gltf.model_textures import KINDS, ModelTextures

DEEPEST = 32


def object_chunk(tag: Tag, value: Any) -> bytes:
    """Returns a chunk of a JSON object.

    :raises ContentError: when the object is nested too deep.
    """
    try:
        return joined(tag, orjson.dumps(value))
    except orjson.JSONEncodeError as error:
        raise ContentError(f"a material or texture cannot be written as JSON: {error}") from None


def read_object(chunk: Chunk) -> dict[str, Any]:
    """Returns the JSON object in a chunk.

    :raises ModelError: when it is no JSON, no object, or nested too deep.
    """
    try:
        value = orjson.loads(bytes(chunk.content))
    except orjson.JSONDecodeError as error:
        raise refuse(chunk, f"this is no JSON: {error}") from None
    if not isinstance(value, dict):
        raise refuse(chunk, "this must be a JSON object")
    _check_depth(chunk, value)
    return value


def _check_depth(chunk: Chunk, value: dict[str, Any]) -> None:
    level: list[Any] = [value]
    for _ in range(DEEPEST):
        values = (part.values() if isinstance(part, dict) else part for part in level)
        level = [below for part in values for below in part if isinstance(below, dict | list)]
        if not level:
            return
    raise refuse(chunk, f"JSON may be nested {DEEPEST} deep at most")


def texture_chunk(textures: ModelTextures) -> bytes:
    """Returns the TEXT chunk of textures."""
    images = [joined("IMAG", image) for image in textures.images]
    return joined("TEXT", object_chunk("INFO", textures.resources), *images)


def read_textures(reader: ChunkReader, chunk: Chunk) -> ModelTextures:
    """Returns the textures in a TEXT chunk.

    :raises ModelError: when INFO is missing, or has not as many images as the chunk.
    """
    parts = list(reader.inside(chunk, 0, ("INFO", "IMAG")))
    infos = [read_object(part) for part in parts if part.tag == "INFO"]
    images = tuple(bytes(part.content) for part in parts if part.tag == "IMAG")
    if len(infos) != 1:
        raise refuse(chunk, f"textures have one INFO, not {len(infos)}")
    resources: dict[str, Any] = {kind: infos[0].get(kind, []) for kind in KINDS}
    for kind, entries in resources.items():
        if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
            raise refuse(chunk, f"{kind} must be an array of objects")
    if len(resources["images"]) != len(images):
        raise refuse(chunk, f"INFO has {len(resources['images'])} images, the chunk {len(images)}")
    if any({"uri", "bufferView"} & entry.keys() for entry in resources["images"]):
        raise refuse(chunk, "the bytes of an image are in its IMAG chunk; it has no uri and no bufferView")
    return ModelTextures(resources, images)
