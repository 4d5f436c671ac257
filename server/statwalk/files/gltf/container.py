"""The GLB container: a header of 12 bytes, a JSON chunk, and a binary chunk (glTF 2.0, 4.4)."""

from __future__ import annotations

import struct

from statwalk.errors import ModelError

MAGIC, VERSION = b"glTF", 2
JSON_CHUNK, BIN_CHUNK = 0x4E4F534A, 0x004E4942
HEADER, CHUNK_HEADER = struct.Struct("<4sII"), struct.Struct("<II")


def is_glb(data: bytes) -> bool:
    """Returns whether the bytes claim to be a GLB container."""
    return data[:4] == MAGIC


def split(data: bytes) -> tuple[memoryview, memoryview | None]:
    """Returns the JSON chunk, and the binary chunk or None.

    Chunks of unknown type and bytes after the end are ignored.

    :raises ModelError: when the container does not match its header; `place` is a byte offset.
    """
    length = _checked_length(data)
    view = memoryview(data)[:length]
    chunks: list[tuple[int, memoryview]] = []
    offset = HEADER.size
    while offset + CHUNK_HEADER.size <= length and len(chunks) < 2:
        size, kind = CHUNK_HEADER.unpack_from(data, offset)
        start = offset + CHUNK_HEADER.size
        if start + size > length:
            raise ModelError(
                f"the chunk's header says {size} bytes, but only {length - start} are left",
                place=f"byte {offset}",
            )
        chunks.append((kind, view[start : start + size]))
        offset = start + size
    if not chunks or chunks[0][0] != JSON_CHUNK or not chunks[0][1]:
        raise ModelError("the first chunk must be JSON and must not be empty", place=f"byte {HEADER.size}")
    return chunks[0][1], chunks[1][1] if len(chunks) > 1 and chunks[1][0] == BIN_CHUNK else None


def _checked_length(data: bytes) -> int:
    """Returns the length in the header, after the header is checked."""
    if len(data) < HEADER.size:
        raise ModelError(f"the file has {len(data)} bytes; a GLB header has {HEADER.size}", place="byte 0")
    _, version, length = HEADER.unpack_from(data)
    if version != VERSION:
        raise ModelError(f"the container has version {version}; it must be {VERSION}", place="byte 4")
    if length > len(data):
        raise ModelError(f"the header says {length} bytes, but the file has {len(data)}", place="byte 8")
    return int(length)


def join(text: bytes, binary: bytes | memoryview) -> bytes:
    """Returns a GLB of a JSON text and binary data; both are padded to 4 bytes, JSON with spaces, binary with
    zeros.
    """
    text = text + b" " * (-len(text) % 4)
    zeros = b"\0" * (-len(binary) % 4)
    chunks: list[bytes | memoryview] = [CHUNK_HEADER.pack(len(text), JSON_CHUNK), text]
    if len(binary):
        chunks += [CHUNK_HEADER.pack(len(binary) + len(zeros), BIN_CHUNK), binary, zeros]
    body = b"".join(chunks)
    return HEADER.pack(MAGIC, VERSION, HEADER.size + len(body)) + body
