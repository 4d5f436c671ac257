"""Copies glTF material objects into another file: texture indices are shifted, or textures are left out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from statwalk.files.gltf.check import Json

DEEPEST = 8


def with_textures_from(material: Mapping[str, Any], first_texture: int | None, depth: int = 0) -> Json:
    """Returns the material with its texture indices counted from `first_texture`; with None textures are left
    out.

    In glTF and in all extensions a key that refers to a texture ends in `Texture`. Extensions that are nested
    deeper than any known one are left out.
    """
    out: Json = {}
    for key, value in material.items():
        if not isinstance(value, dict):
            out[key] = value
        elif key.endswith("Texture") and "index" in value and first_texture is not None:
            out[key] = {**value, "index": value["index"] + first_texture}
        elif not key.endswith("Texture") and depth < DEEPEST:
            out[key] = with_textures_from(value, first_texture, depth + 1)
    return out


def extensions_used(entries: Iterable[Any]) -> list[str]:
    """Returns the names of all extensions in the objects, as `extensionsUsed` must declare them."""
    names: set[str] = set()
    pending = list(entries)
    while pending:
        entry = pending.pop()
        if isinstance(entry, dict):
            extensions = entry.get("extensions")
            names |= set(extensions) if isinstance(extensions, dict) else set()
            pending += [value for key, value in entry.items() if key != "extras"]
    return sorted(names)
