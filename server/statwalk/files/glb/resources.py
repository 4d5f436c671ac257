"""The bytes that buffers and images point at: the binary chunk, `data:` addresses, files beside the model; never anything else."""

from __future__ import annotations

import base64
import binascii
from pathlib import Path, PurePosixPath
from urllib.parse import unquote, unquote_to_bytes

from statwalk.errors import ModelError

LARGEST_RESOURCE_BYTES = 256 << 20


def resource(uri: str, folder: Path | None, place: str) -> bytes:
    """The bytes at a `data:` address or in a file beside the model. Raises ModelError for addresses that lead anywhere else."""
    return data_uri(uri, place) if uri[:5].lower() == "data:" else sibling(uri, folder, place).read_bytes()


def data_uri(uri: str, place: str) -> bytes:
    """The bytes written in a `data:` address (RFC 2397)."""
    head, comma, body = uri.partition(",")
    if not comma:
        raise ModelError("a data: address needs a comma before its data", place=place)
    if not head.endswith(";base64"):
        return unquote_to_bytes(body)
    try:
        return base64.b64decode(unquote(body), validate=True)
    except (binascii.Error, ValueError) as error:
        raise ModelError(f"the data: address is not base64: {error}", place=place) from None


def sibling(uri: str, folder: Path | None, place: str) -> Path:
    """The file a relative address names, which must be a regular file inside the model's folder."""
    name = unquote(uri)
    path = PurePosixPath(name)
    if folder is None or ":" in name or "\\" in name or "\0" in name or path.is_absolute() or ".." in path.parts:
        raise ModelError(f"{name[:60]!r} must be a data: address or a file beside the model", place=place)
    home = folder.resolve()
    file = (home / path).resolve()
    if not file.is_relative_to(home) or not file.is_file():
        raise ModelError(f"there is no file {name[:60]!r} beside the model", place=place)
    if file.stat().st_size > LARGEST_RESOURCE_BYTES:
        raise ModelError(f"the file {name[:60]!r} is larger than {LARGEST_RESOURCE_BYTES >> 20} MiB", place=place)
    return file
