"""The textures of a model in another file: samplers and images counted anew, images as bytes of the binary chunk."""

from __future__ import annotations

from typing import Any

import orjson

from statwalk.character import Character
from statwalk.files.glb import check, container
from statwalk.files.glb.builder import Builder
from statwalk.files.glb.check import Json
from statwalk.files.glb.document import Document
from statwalk.files.glb.views import Views

Resources = dict[str, list[Json]]


def no_resources() -> Resources:
    """Textures, images and samplers: none yet."""
    return {"textures": [], "images": [], "samplers": []}


def check_textures(document: Document, views: Views) -> None:
    """Images, textures and samplers that point at what is there; materials that point at textures."""
    for row, image in enumerate(document["images"]):
        if "bufferView" in image:
            views.open(check.required_reference(image, "bufferView", f"/images/{row}", document["bufferViews"], "bufferView"))
    for row, texture in enumerate(document["textures"]):
        check.reference(texture, "sampler", f"/textures/{row}", document["samplers"], "sampler")
        check.reference(texture, "source", f"/textures/{row}", document["images"], "image")
        for name, extension in check.mapping(texture, "extensions", f"/textures/{row}").items():
            if isinstance(extension, dict):
                check.reference(extension, "source", f"/textures/{row}/extensions/{name[:60]}", document["images"], "image")
    for row, material in enumerate(document["materials"]):
        check_material(document, material, f"/materials/{row}")


def check_material(document: Document, material: Json, place: str) -> None:
    """The textures that a material names, wherever in it."""
    ready = [(place, material)]
    while ready:
        where, entry = ready.pop()
        for key, value in entry.items():
            if isinstance(value, dict):
                ready.append((f"{where}/{key[:60]}", value))
                if key.endswith("Texture"):
                    check.reference(value, "index", f"{where}/{key[:60]}", document["textures"], "texture")


def add_textures(builder: Builder, resources: Resources, character: Character) -> int:
    """Bring the textures, samplers and images of the character's model along; the index of its first texture."""
    if not container.is_glb(character.model_glb):
        return 0
    text, binary = container.split(character.model_glb)
    root = orjson.loads(text)
    first = {kind: len(listed) for kind, listed in resources.items()}
    resources["samplers"] += root.get("samplers", [])
    resources["images"] += [image_entry(builder, root, image, binary) for image in root.get("images", [])]
    resources["textures"] += [texture_entry(texture, first) for texture in root.get("textures", [])]
    return first["textures"]


def image_entry(builder: Builder, root: Json, image: Json, binary: memoryview | None) -> Json:
    """An image, its bytes in the new file's binary chunk."""
    if "bufferView" not in image or binary is None:
        return image
    view = root["bufferViews"][image["bufferView"]]
    start = view.get("byteOffset", 0)
    return {**image, "bufferView": builder.data(bytes(binary[start : start + view["byteLength"]]))}


def texture_entry(texture: Json, first: dict[str, int]) -> Json:
    """A texture whose sampler and image are counted in the new file."""
    shift = {"sampler": first["samplers"], "source": first["images"]}
    out: dict[str, Any] = {key: value + shift.get(key, 0) if key in shift else value for key, value in texture.items()}
    for name, extension in texture.get("extensions", {}).items():
        if isinstance(extension, dict) and "source" in extension:
            out["extensions"] = {**out["extensions"], name: {**extension, "source": extension["source"] + first["images"]}}
    return out
