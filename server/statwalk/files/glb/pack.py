"""A .gltf with its buffers and images as one .glb; all else in it passes through untouched."""

from __future__ import annotations

from typing import Any

import orjson

from statwalk.errors import ModelError
from statwalk.files.glb import check, container
from statwalk.files.glb.check import Json
from statwalk.files.glb.document import Document
from statwalk.files.glb.resources import resource
from statwalk.files.glb.views import Views

SIGNATURES = {b"\x89PNG": "image/png", b"\xff\xd8\xff": "image/jpeg"}


def stands_alone(document: Document) -> bool:
    """Whether nothing in the document points at another file."""
    entries = [*document["buffers"], *document["images"]]
    return all(str(entry.get("uri", "data:")).startswith("data:") for entry in entries)


def packed(document: Document, views: Views) -> bytes:
    """The document as a GLB: one buffer, images as buffer views. An image that cannot be had is left out, and noted."""
    for row in range(len(document["bufferViews"])):
        views.open(row)
    binary = bytearray()
    used = sorted({view["buffer"] for view in document["bufferViews"]})
    starts = {row: append(binary, views.buffer(row)) for row in used}
    buffer_views = [moved(view, starts) for view in document["bufferViews"]]
    images = [packed_image(document, views, row, binary, buffer_views) for row in range(len(document["images"]))]
    root: Json = {**document.root, "buffers": [{"byteLength": len(binary)}]}
    if not binary:
        del root["buffers"]
    if buffer_views:
        root["bufferViews"] = buffer_views
    if images:
        root["images"] = images
    try:
        return container.join(orjson.dumps(root), bytes(binary))
    except orjson.JSONEncodeError as error:
        raise ModelError(f"the document cannot be written again: {error}", place="/") from None


def append(binary: bytearray, data: bytes | memoryview) -> int:
    """Add bytes at the next multiple of 4; where they start."""
    binary += b"\0" * (-len(binary) % 4)
    start = len(binary)
    binary += data
    return start


def moved(view: Json, starts: dict[int, int]) -> Json:
    """The view on the one buffer that holds them all."""
    start = starts[view["buffer"]] + view.get("byteOffset", 0)
    return {**view, "buffer": 0, "byteOffset": start}


def packed_image(document: Document, views: Views, row: int, binary: bytearray, buffer_views: list[Any]) -> Json:
    """The image with its bytes in a buffer view."""
    image, place = document["images"][row], f"/images/{row}"
    if "uri" not in image:
        return image
    rest = {key: value for key, value in image.items() if key != "uri"}
    try:
        data = resource(check.text(image, "uri", place), views.folder, f"{place}/uri")
    except ModelError as error:
        document.note(f"an image is left out: {error.message}")
        data = BLANK_PNG
    kind = next((kind for signature, kind in SIGNATURES.items() if data.startswith(signature)), image.get("mimeType", "image/png"))
    buffer_views.append({"buffer": 0, "byteOffset": append(binary, data), "byteLength": len(data)})
    return {**rest, "bufferView": len(buffer_views) - 1, "mimeType": kind}


# One white pixel: what a texture whose file is missing shows.
BLANK_PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de"
    "0000000c4944415478da63f8ffff3f0005fe02fe331295140000000049454e44ae426082"
)
