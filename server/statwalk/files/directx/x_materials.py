"""The materials of a .x mesh as glTF materials: colours, and how rough the surface is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from statwalk.errors import TextError
from statwalk.files.directx.x_numbers import NumberReader
from statwalk.files.directx.x_objects import REFERENCE, DataObject
from statwalk.maths.arrays import Ints

MATERIAL, TEXTURES = "material", ("texturefilename", "normalmapfilename", "effectinstance")
MOST_MATERIALS = 1_024


@dataclass
class XMaterials:
    """The materials of the file, each once; `named` are the materials outside meshes, by name."""

    notes: list[str]
    named: dict[str, DataObject] = field(default_factory=dict)
    read: list[Mapping[str, Any]] = field(default_factory=list)
    row_of: dict[int, int] = field(default_factory=dict)

    def rows(self, mesh: DataObject, faces: int) -> Ints:
        """Returns the material (F,) of each face of a mesh, -1 for none.

        :raises TextError: when the list of materials is wrong.
        """
        found = next(mesh.of_kind("meshmateriallist"), None)
        if found is None:
            return np.full(faces, -1)
        numbers = NumberReader(found)
        declared = int(numbers.floats(1, "the number of materials")[0])
        count = numbers.count("faces with a material")
        materials = [row for part in found.parts if (row := self._row(part)) is not None]
        if declared < 1 or not materials:
            return np.full(faces, -1)
        chosen = numbers.indices(count, declared, "the material of a face")
        if count and int(chosen.max()) >= len(materials):
            raise TextError(
                f"the list has {len(materials)} materials, but a face has number {int(chosen.max())}",
                place=found.place,
            )
        padded = np.concatenate([chosen, np.full(max(faces - count, 0), chosen[-1] if count else 0)])
        rows: Ints = np.array(materials)[padded[:faces]]
        return rows

    def _row(self, part: DataObject) -> int | None:
        """Returns the row of a material or of a reference to one; None for other objects."""
        material = self.named.get(part.name) if part.kind == REFERENCE else part
        if material is None:
            raise TextError(f"the file has no material {part.name[:60]!r}", place=part.place)
        if material.kind != MATERIAL:
            return None
        if id(material) not in self.row_of:
            if len(self.read) >= MOST_MATERIALS:
                raise TextError(f"the file has more than {MOST_MATERIALS} materials", place=part.place)
            self.row_of[id(material)] = len(self.read)
            self.read.append(self._material(material))
        return self.row_of[id(material)]

    def _material(self, part: DataObject) -> Mapping[str, Any]:
        """Returns a material; colours are taken over as they are."""
        numbers = NumberReader(part)
        red, green, blue, alpha, power = numbers.floats(5, "a colour and its power").tolist()
        specular, emissive = (numbers.floats(3, "a colour").clip(0, 1).tolist() for _ in range(2))
        for texture in (
            name for kind in TEXTURES for inner in part.of_kind(kind) for name in inner.strings[:1]
        ):
            note = f"the picture {texture[:80]!r} is left out: a .x file is read without its pictures"
            if texture and note not in self.notes:
                self.notes.append(note)
        base = [min(max(value, 0.0), 1.0) for value in (red, green, blue, alpha)]
        material: dict[str, Any] = {
            "name": part.name or f"material {len(self.read)}",
            "pbrMetallicRoughness": {
                "baseColorFactor": base,
                "metallicFactor": 0.0,
                "roughnessFactor": roughness_of(power) if any(specular) else 1.0,
            },
        }
        if any(emissive):
            material["emissiveFactor"] = emissive
        return material | ({"alphaMode": "BLEND"} if base[3] < 1 else {})


def roughness_of(power: float) -> float:
    """Returns the roughness of a surface whose highlight has the exponent `power`."""
    return float(np.sqrt(2 / (max(power, 0.0) + 2)))


def power_of(roughness: float) -> float:
    """Returns the exponent of a highlight; the inverse of `roughness_of`."""
    return 2 / max(roughness, 0.01) ** 2 - 2
