"""Copies glTF material objects into another file: texture indices are shifted, or textures are left out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from statwalk.files.gltf.check import Json

DEEPEST = 8


def shallow(value: Any, depth: int = 0) -> Any:
    """Returns the value without objects and lists that are nested deeper than in any known material."""
    if isinstance(value, dict):
        members = value.items()
        return {key: shallow(member, depth + 1) for key, member in members if _is_kept(member, depth)}
    if isinstance(value, list):
        return [shallow(member, depth + 1) for member in value if _is_kept(member, depth)]
    return value


def _is_kept(member: Any, depth: int) -> bool:
    return depth < DEEPEST or not isinstance(member, dict | list)


def with_textures_from(material: Mapping[str, Any], first_texture: int | None) -> Json:
    """Returns the (shallow) material with its texture indices counted from `first_texture`; with None
    textures are left out.

    In glTF and in all extensions a key that refers to a texture ends in `Texture`.
    """
    out: Json = {}
    for key, value in material.items():
        if not isinstance(value, dict):
            out[key] = value
        elif key.endswith("Texture") and "index" in value and first_texture is not None:
            out[key] = {**value, "index": value["index"] + first_texture}
        elif not key.endswith("Texture"):
            out[key] = with_textures_from(value, first_texture)
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
