"""glTF material objects in another file than their own: texture indices shifted, or the textures left out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from statwalk.files.glb.check import Json

DEEPEST = 8


def moved(material: Mapping[str, Any], first_texture: int | None, depth: int = 0) -> Json:
    """The material with its texture indices counted from `first_texture`, or without textures (None).

    Wherever glTF or an extension names a texture, the key ends in `Texture`. Extensions nested deeper than any known are left out.
    """
    out: Json = {}
    for key, value in material.items():
        if not isinstance(value, dict):
            out[key] = value
        elif key.endswith("Texture") and "index" in value and first_texture is not None:
            out[key] = {**value, "index": value["index"] + first_texture}
        elif not key.endswith("Texture") and depth < DEEPEST:
            out[key] = moved(value, first_texture, depth + 1)
    return out


def extensions_used(entries: Iterable[Any]) -> list[str]:
    """The names of all extensions in the objects, as `extensionsUsed` must declare them."""
    names: set[str] = set()
    ready = list(entries)
    while ready:
        entry = ready.pop()
        if isinstance(entry, dict):
            extensions = entry.get("extensions")
            names |= set(extensions) if isinstance(extensions, dict) else set()
            ready += [value for key, value in entry.items() if key != "extras"]
    return sorted(names)
