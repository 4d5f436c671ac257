"""Writes a character as a file of its own: .glb, .gltf with its data inside, or a zip of the .glb."""

from __future__ import annotations

import base64

import orjson

from statwalk.character.character import Character
from statwalk.files.gltf import container
from statwalk.files.gltf.write import model_glb
from statwalk.files.zipped import zipped


def write_glb(character: Character) -> bytes:
    """Returns the character's own model with all that it holds, or a .glb made of the character."""
    return character.model_glb or model_glb(character)


def write_gltf(character: Character) -> bytes:
    """Returns a .gltf whose binary data are inside, as a data URI."""
    text, binary = container.split(write_glb(character))
    document = orjson.loads(bytes(text))
    if binary is not None and document.get("buffers"):
        data = bytes(binary[: document["buffers"][0]["byteLength"]])
        uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
        document["buffers"][0]["uri"] = uri
    return orjson.dumps(document)


def write_zip(character: Character) -> bytes:
    """Returns a zip with the .glb."""
    return zipped({"model.glb": write_glb(character)})
