"""Adds a clip to a model: an animation more in its .glb, everything else as it was."""

from __future__ import annotations

from typing import Any

import orjson

from statwalk.character.character import Character
from statwalk.files.gltf import container, json_text
from statwalk.files.gltf.builder import Builder
from statwalk.files.gltf.write_animations import animation
from statwalk.motion.clip import Clip


def model_with_clip(character: Character, clip: Clip) -> bytes:
    """Returns the character's model with the clip as one more animation; textures and extensions stay."""
    text, binary = container.split(character.model_glb)
    document: dict[str, Any] = orjson.loads(bytes(text))
    builder = Builder(
        bytearray(binary or b""), list(document.get("bufferViews", ())), list(document.get("accessors", ()))
    )
    added = animation(builder, character, clip)
    if added is None:
        return character.model_glb
    document["animations"] = [*document.get("animations", ()), added]
    return container.join(json_text.dumps(builder.finished(document)), bytes(builder.binary))
