"""Reads the width and the height of PNG and JPEG images from their headers."""

from __future__ import annotations

PNG, JPEG = b"\x89PNG\r\n\x1a\n", b"\xff\xd8"
FRAMES = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}
"""the JPEG markers that begin a frame, and tell its size"""
ALONE = frozenset({0x01, *range(0xD0, 0xD9)})
"""the JPEG markers without a length"""


def image_size(data: bytes) -> tuple[int, int] | None:
    """Returns width and height in pixels; None for another format, or a header that is cut off."""
    if data.startswith(PNG) and len(data) >= 24:
        return int.from_bytes(data[16:20]), int.from_bytes(data[20:24])
    return _jpeg_size(data) if data.startswith(JPEG) else None


def _jpeg_size(data: bytes) -> tuple[int, int] | None:
    at = 2
    while at + 9 <= len(data) and data[at] == 0xFF:
        marker = data[at + 1]
        if marker in FRAMES:
            return int.from_bytes(data[at + 7 : at + 9]), int.from_bytes(data[at + 5 : at + 7])
        at += 2 if marker in ALONE else 2 + int.from_bytes(data[at + 2 : at + 4])
    return None
