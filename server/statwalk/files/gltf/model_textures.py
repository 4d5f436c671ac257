"""The textures of a model apart from it: samplers, textures and images, and the bytes of each image."""

from __future__ import annotations

import base64
import binascii
from typing import NamedTuple

import orjson

from statwalk.errors import ModelError
from statwalk.files.gltf import container
from statwalk.files.gltf.builder import Builder
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.textures import Resources

KINDS = ("samplers", "textures", "images")
PLACES = ("bufferView", "uri")
"""where an image's bytes are in a model"""


class ModelTextures(NamedTuple):
    """glTF objects by kind, the images without the place of their bytes; and the bytes of each image."""

    resources: Resources
    images: tuple[bytes, ...]


def textures_of(model: bytes) -> ModelTextures:
    """Returns the textures of a .glb; without a model there are no textures."""
    if not container.is_glb(model):
        return ModelTextures({kind: [] for kind in KINDS}, ())
    text, binary = container.split(model)
    root = orjson.loads(bytes(text))
    resources = {kind: list(root.get(kind, ())) for kind in KINDS}
    images = tuple(_bytes(root, image, binary or memoryview(b"")) for image in resources["images"])
    resources["images"] = [
        {key: value for key, value in image.items() if key not in PLACES} for image in resources["images"]
    ]
    return ModelTextures(resources, images)


def _bytes(root: Json, image: Json, binary: memoryview) -> bytes:
    if "bufferView" in image:
        view = root["bufferViews"][image["bufferView"]]
        start = view.get("byteOffset", 0)
        return bytes(binary[start : start + view["byteLength"]])
    try:
        return base64.b64decode(str(image.get("uri", "")).partition(",")[2])
    except binascii.Error:
        raise ModelError("the data URI of an image is no base64", place="/images") from None


def add_to(builder: Builder, textures: ModelTextures) -> Resources:
    """Adds the bytes of the images to a file that is written; returns its samplers, textures and images."""
    images = [
        {**image, "bufferView": builder.data(data)}
        for image, data in zip(textures.resources["images"], textures.images, strict=True)
    ]
    return {**textures.resources, "images": images}
