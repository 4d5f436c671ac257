"""Sizes of images, against the JSON of the models and a header written by hand."""

import struct

import pytest
from statwalk.files.image_size import image_size

PNG = b"\x89PNG\r\n\x1a\n" + struct.pack(">I4sII", 13, b"IHDR", 640, 480)
COMMENT = b"\xff\xfe" + struct.pack(">H", 6) + b"abcd"
FRAME = b"\xff\xc2" + struct.pack(">HBHH", 11, 8, 480, 640) + b"\x01\x01\x11\x00"
IMAGES = {
    "png": (PNG, (640, 480)),
    "jpeg": (b"\xff\xd8" + FRAME, (640, 480)),
    "jpeg with a comment first": (b"\xff\xd8" + COMMENT + FRAME, (640, 480)),
    "webp": (b"RIFF\0\0\0\0WEBPVP8 ", None),
    "a png that is cut off": (PNG[:20], None),
    "a jpeg that is cut off": (b"\xff\xd8" + COMMENT, None),
    "nothing": (b"", None),
}


@pytest.mark.parametrize(("data", "size"), IMAGES.values(), ids=IMAGES)
def test_the_header_tells_the_size(data: bytes, size: tuple[int, int] | None) -> None:
    assert image_size(data) == size
