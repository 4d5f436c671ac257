"""Packs a .gltf with its buffers and images into one .glb; all other content passes through untouched."""

from __future__ import annotations

from typing import Any

import orjson

from statwalk.errors import ModelError
from statwalk.files.gltf import check, container, json_text
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.resources import resource
from statwalk.files.gltf.views import Views

SIGNATURES = {b"\x89PNG": "image/png", b"\xff\xd8\xff": "image/jpeg"}


def stands_alone(document: Document) -> bool:
    """Returns whether the document refers to no other file."""
    entries = [*document["buffers"], *document["images"]]
    return all(str(entry.get("uri", "data:")).startswith("data:") for entry in entries)


def packed(document: Document, views: Views) -> bytes:
    """Returns the document as a GLB: one buffer, images as buffer views.

    An image that cannot be read is replaced by a white pixel, with a note.

    :raises ModelError: when a buffer is missing or too short, or the document cannot be written.
    """
    for row in range(len(document["bufferViews"])):
        views.open(row)
    binary = bytearray()
    used = sorted({view["buffer"] for view in document["bufferViews"]})
    starts = {row: append(binary, views.buffer(row)) for row in used}
    buffer_views = [_moved(view, starts) for view in document["bufferViews"]]
    images = [
        _packed_image(document, views, row, binary, buffer_views) for row in range(len(document["images"]))
    ]
    root: Json = {**document.root, "buffers": [{"byteLength": len(binary)}]}
    if not binary:
        del root["buffers"]
    if buffer_views:
        root["bufferViews"] = buffer_views
    if images:
        root["images"] = images
    try:
        return container.join(json_text.dumps(root), bytes(binary))
    except orjson.JSONEncodeError as error:
        raise ModelError(f"the document cannot be written again: {error}", place="/") from None


def append(binary: bytearray, data: bytes | memoryview) -> int:
    """Appends bytes at the next multiple of 4; returns their offset."""
    binary += b"\0" * (-len(binary) % 4)
    start = len(binary)
    binary += data
    return start


def _moved(view: Json, starts: dict[int, int]) -> Json:
    """Returns the view with its offset in the joint buffer."""
    start = starts[view["buffer"]] + view.get("byteOffset", 0)
    return {**view, "buffer": 0, "byteOffset": start}


def _packed_image(
    document: Document, views: Views, row: int, binary: bytearray, buffer_views: list[Any]
) -> Json:
    """Returns the image with its bytes in a buffer view."""
    image, place = document["images"][row], f"/images/{row}"
    if "uri" not in image:
        return image
    other_fields = {key: value for key, value in image.items() if key != "uri"}
    try:
        data = resource(check.text(image, "uri", place), views.folder, f"{place}/uri")
    except ModelError as error:
        document.note(f"an image is left out: {error.message}")
        data = BLANK_PNG
    mime_type = next(
        (mime_type for signature, mime_type in SIGNATURES.items() if data.startswith(signature)),
        image.get("mimeType", "image/png"),
    )
    buffer_views.append({"buffer": 0, "byteOffset": append(binary, data), "byteLength": len(data)})
    return {**other_fields, "bufferView": len(buffer_views) - 1, "mimeType": mime_type}


# One white pixel, in place of an image that cannot be read.
BLANK_PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d4948445200000001000000010802000000907753de"
    "0000000c4944415478da63f8ffff3f0005fe02fe331295140000000049454e44ae426082"
)
