"""Reads the bytes that buffers and images refer to: `data:` URIs and files in the model's folder, nothing
else.
"""

from __future__ import annotations

import base64
import binascii
from pathlib import Path, PurePosixPath
from urllib.parse import unquote, unquote_to_bytes

from statwalk.errors import ModelError

LARGEST_RESOURCE_BYTES = 256 << 20


def resource(uri: str, folder: Path | None, place: str) -> bytes:
    """Returns the bytes of a `data:` URI or of a file in the model's folder.

    :raises ModelError: when the URI is neither, or its data are wrong or too large.
    """
    return _data_uri(uri, place) if uri[:5].lower() == "data:" else _sibling(uri, folder, place).read_bytes()


def _data_uri(uri: str, place: str) -> bytes:
    """Returns the bytes in a `data:` URI (RFC 2397)."""
    header, comma, data = uri.partition(",")
    if not comma:
        raise ModelError("a data: URI needs a comma before its data", place=place)
    if not header.endswith(";base64"):
        return unquote_to_bytes(data)
    try:
        return base64.b64decode(unquote(data), validate=True)
    except (binascii.Error, ValueError) as error:
        raise ModelError(f"the data: URI is not base64: {error}", place=place) from None


def _sibling(uri: str, folder: Path | None, place: str) -> Path:
    """Returns the path that a relative URI names, which must be a regular file inside the model's folder."""
    name = unquote(uri)
    path = PurePosixPath(name)
    if (
        folder is None
        or ":" in name
        or "\\" in name
        or "\0" in name
        or path.is_absolute()
        or ".." in path.parts
    ):
        raise ModelError(f"{name[:60]!r} must be a data: URI or a file in the model's folder", place=place)
    model_folder = folder.resolve()
    file = (model_folder / path).resolve()
    if not file.is_relative_to(model_folder) or not file.is_file():
        raise ModelError(f"the model's folder has no file {name[:60]!r}", place=place)
    if file.stat().st_size > LARGEST_RESOURCE_BYTES:
        raise ModelError(
            f"the file {name[:60]!r} is larger than {LARGEST_RESOURCE_BYTES >> 20} MiB", place=place
        )
    return file
