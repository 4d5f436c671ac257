"""What the skin of an MD2 file is to a character: pixels for texture coordinates, and names of pictures that
lie elsewhere, which the material keeps.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.files.md2.md2_header import SKIN_BYTES
from statwalk.skin.primitive import Primitive

SKIN_SIZE = (256, 256)
_KEPT = "md2_skin"
_COLOUR = {"baseColorFactor": [0.72, 0.69, 0.64, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.8}


def skin_material(names: Sequence[str], size: tuple[int, int]) -> dict[str, Any]:
    """Returns a material of one colour that remembers the skins' names, and their width and height."""
    skin = {"width": size[0], "height": size[1], "names": list(names)}
    name = names[0] if names and names[0] else "skin"
    return {"name": name, "pbrMetallicRoughness": _COLOUR, "extras": {_KEPT: skin}}


def skin_names(character: Character) -> list[bytes]:
    """Returns the names of pictures in the MD2 file that the character came from."""
    names = _skin(character).get("names", [])
    return [name.encode("latin-1", "replace")[: SKIN_BYTES - 1] for name in names]


def skin_pixels(
    character: Character, parts: Sequence[Primitive]
) -> tuple[NDArray[np.int16], tuple[int, int]]:
    """Returns the pixels (V, 2) of all vertices of some parts on a skin, and the skin's size."""
    skin = _skin(character)
    size = (int(skin["width"]), int(skin["height"])) if skin else SKIN_SIZE
    places = np.concatenate(
        [part.attributes.get("TEXCOORD_0", np.zeros((len(part.positions), 2), np.float32)) for part in parts]
    )
    pixels = np.rint(places.astype(np.float64) * size - 0.5)
    return np.clip(np.nan_to_num(pixels), -(1 << 15), (1 << 15) - 1).astype(np.int16), size


def _skin(character: Character) -> Mapping[str, Any]:
    """Returns what a character that came from an MD2 file remembers of its skins; {} for other characters."""
    extras = [material.get("extras") for material in character.materials]
    skins = [entry.get(_KEPT) for entry in extras if isinstance(entry, dict)]
    return next((skin for skin in skins if isinstance(skin, dict) and _is_skin(skin)), {})


def _is_skin(skin: Mapping[str, Any]) -> bool:
    sizes = [skin.get(key) for key in ("width", "height")]
    names = skin.get("names")
    return (
        all(type(size) is int and 0 < size <= 1 << 15 for size in sizes)
        and isinstance(names, list)
        and all(isinstance(name, str) for name in names)
    )
