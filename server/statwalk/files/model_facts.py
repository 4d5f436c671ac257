"""Says what is in a model, for somebody who looks at it: meshes, materials and textures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import orjson

from statwalk.character.character import Character
from statwalk.files.gltf import container
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.model_textures import textures_of
from statwalk.files.image_size import image_size
from statwalk.skin.primitive import TRIANGLES, Primitive

STRIP, FAN = 5, 6


class MaterialFacts(NamedTuple):
    """A material; `textures`: by the name of its place in glTF, an index into the model's images."""

    name: str
    textures: dict[str, int]
    alpha: str
    double_sided: bool


class ImageFacts(NamedTuple):
    """An image that a material may show; `size` in pixels, None: not known."""

    name: str
    type: str
    bytes: int
    size: tuple[int, int] | None


class ModelFacts(NamedTuple):
    """What is in a model; `mesh_names` by the index of the mesh, without the unnamed ones."""

    mesh_names: dict[int, str]
    materials: list[MaterialFacts]
    images: list[ImageFacts]


def triangles(part: Primitive) -> int:
    """Returns the number of triangles that a primitive draws."""
    corners = len(part.positions if part.indices is None else part.indices)
    if part.mode == TRIANGLES:
        return corners // 3
    return max(0, corners - 2) if part.mode in (STRIP, FAN) else 0


def target_names(character: Character, part: Primitive) -> list[str]:
    """Returns the names of the morph targets of a primitive."""
    count = 0 if part.target_positions is None else len(part.target_positions)
    of_column = {column: name for name, columns in character.targets.items() for column in columns}
    return [of_column[column] for column in range(part.weight_first, part.weight_first + count)]


def model_facts(character: Character) -> ModelFacts:
    """Returns what is in the model of a character; the materials are in the order of the parts' indices."""
    resources, images = textures_of(character.model_glb)
    return ModelFacts(
        mesh_names(character.model_glb),
        [_material(material, resources["textures"]) for material in character.materials],
        [
            ImageFacts(
                str(image.get("name", "")), str(image.get("mimeType", "")), len(data), image_size(data)
            )
            for image, data in zip(resources["images"], images, strict=True)
        ],
    )


def mesh_names(model: bytes) -> dict[int, str]:
    """Returns the names of the meshes of a .glb by their numbers, without the unnamed ones."""
    if not container.is_glb(model):
        return {}
    text, _ = container.split(model)
    meshes = orjson.loads(bytes(text)).get("meshes", ())
    return {index: str(mesh["name"]) for index, mesh in enumerate(meshes) if mesh.get("name")}


def _material(material: Mapping[str, Any], textures: list[Json]) -> MaterialFacts:
    shown = {place: _image(textures, index) for place, index in _places(material)}
    return MaterialFacts(
        str(material.get("name", "")),
        {place: image for place, image in shown.items() if image is not None},
        str(material.get("alphaMode", "OPAQUE")),
        bool(material.get("doubleSided", False)),
    )


def _places(material: Mapping[str, Any]) -> Iterator[tuple[str, int]]:
    """Yields each place of a texture, and the index of the texture.

    In glTF and in all extensions a key that refers to a texture ends in `Texture`.
    """
    for key, value in material.items():
        if isinstance(value, dict) and key != "extras":
            if key.endswith("Texture") and isinstance(value.get("index"), int):
                yield key, value["index"]
            else:
                yield from _places(value)


def _image(textures: list[Json], index: int) -> int | None:
    """The image of a texture, also one that only an extension names."""
    if not 0 <= index < len(textures):
        return None
    texture = textures[index]
    sources = [texture, *texture.get("extensions", {}).values()]
    return next((source["source"] for source in sources if "source" in source), None)
