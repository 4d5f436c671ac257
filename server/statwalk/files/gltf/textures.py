"""Copies the textures of a model into another file: samplers and images are renumbered, the bytes of images
move into the binary chunk.
"""

from __future__ import annotations

from typing import Any

import orjson

from statwalk.character.character import Character
from statwalk.files.gltf import check, container
from statwalk.files.gltf.builder import Builder
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.views import Views

Resources = dict[str, list[Json]]


def no_resources() -> Resources:
    """Returns empty lists of textures, images and samplers."""
    return {"textures": [], "images": [], "samplers": []}


def check_textures(document: Document, views: Views) -> None:
    """Checks the references of images, textures and materials.

    :raises ModelError: when a reference leads to no object.
    """
    for row, image in enumerate(document["images"]):
        if "bufferView" in image:
            views.open(
                check.required_reference(
                    image, "bufferView", f"/images/{row}", document["bufferViews"], "bufferView"
                )
            )
    for row, texture in enumerate(document["textures"]):
        check.reference(texture, "sampler", f"/textures/{row}", document["samplers"], "sampler")
        check.reference(texture, "source", f"/textures/{row}", document["images"], "image")
        for name, extension in check.mapping(texture, "extensions", f"/textures/{row}").items():
            if isinstance(extension, dict):
                check.reference(
                    extension,
                    "source",
                    f"/textures/{row}/extensions/{name[:60]}",
                    document["images"],
                    "image",
                )
    for row, material in enumerate(document["materials"]):
        _check_material(document, material, f"/materials/{row}")


def _check_material(document: Document, material: Json, place: str) -> None:
    """Checks all references to textures in a material, at any depth."""
    pending = [(place, material)]
    while pending:
        entry_place, entry = pending.pop()
        for key, value in entry.items():
            if isinstance(value, dict):
                pending.append((f"{entry_place}/{key[:60]}", value))
                if key.endswith("Texture"):
                    check.reference(
                        value, "index", f"{entry_place}/{key[:60]}", document["textures"], "texture"
                    )


def add_textures(builder: Builder, resources: Resources, character: Character) -> int:
    """Adds the textures, samplers and images of the character's model; returns the index of its first
    texture.
    """
    if not container.is_glb(character.model_glb):
        return 0
    text, binary = container.split(character.model_glb)
    root = orjson.loads(text)
    first_row = {kind: len(entries) for kind, entries in resources.items()}
    resources["samplers"] += root.get("samplers", [])
    resources["images"] += [_image_entry(builder, root, image, binary) for image in root.get("images", [])]
    resources["textures"] += [_texture_entry(texture, first_row) for texture in root.get("textures", [])]
    return first_row["textures"]


def _image_entry(builder: Builder, root: Json, image: Json, binary: memoryview | None) -> Json:
    """Returns an image with its bytes in the new file's binary chunk."""
    if "bufferView" not in image or binary is None:
        return image
    view = root["bufferViews"][image["bufferView"]]
    start = view.get("byteOffset", 0)
    return {**image, "bufferView": builder.data(bytes(binary[start : start + view["byteLength"]]))}


def _texture_entry(texture: Json, first_row: dict[str, int]) -> Json:
    """Returns a texture with its sampler's and image's indices in the new file."""
    first_of_field = {"sampler": first_row["samplers"], "source": first_row["images"]}
    entry: dict[str, Any] = {
        key: value + first_of_field.get(key, 0) if key in first_of_field else value
        for key, value in texture.items()
    }
    for name, extension in texture.get("extensions", {}).items():
        if isinstance(extension, dict) and "source" in extension:
            entry["extensions"] = {
                **entry["extensions"],
                name: {**extension, "source": extension["source"] + first_row["images"]},
            }
    return entry
