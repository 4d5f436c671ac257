"""The head of an MD2 file: 17 whole numbers, checked against the file before any memory is taken.

0 "IDP2"   4 version 8   8 skin width   12 skin height   16 bytes of a frame
20 skins   24 vertices   28 texture coordinates   32 triangles   36 GL commands   40 frames: how many
44 skins   48 texture coordinates   52 triangles   56 frames   60 GL commands   64 end: at which byte
"""

from __future__ import annotations

import struct
from typing import NamedTuple

from statwalk.errors import ModelError

START = b"IDP2"
VERSION = 8
HEAD = struct.Struct("<4s16i")
SKIN_BYTES, COORDINATE_BYTES, TRIANGLE_BYTES, VERTEX_BYTES = 64, 4, 12, 4
FRAME_HEAD_BYTES = 40
MOST_FRAMES, MOST_VERTICES, MOST_TRIANGLES, MOST_SKINS = 1_024, 65_535, 65_535, 1_024
MOST_COORDINATES = 65_536
LARGEST_SKIN = 65_536


class Header(NamedTuple):
    """The numbers of the head, after the version, in the order of the file."""

    skin_width: int
    skin_height: int
    frame_bytes: int
    skins: int
    vertices: int
    coordinates: int
    triangles: int
    commands: int
    frames: int
    skins_at: int
    coordinates_at: int
    triangles_at: int
    frames_at: int
    commands_at: int
    end: int


FIRST_AT = 8
"""the byte of the first field of `Header`"""


def read_header(data: bytes) -> Header:
    """Reads the head; every part that it names then lies inside the file.

    GL commands, which repeat the triangles, may lie anywhere: nobody reads them.

    :raises ModelError: when a number is impossible; `place` is its byte.
    """
    if not data.startswith(START):
        raise ModelError("this is no MD2 file: it must start with IDP2", place="byte 0")
    if len(data) < HEAD.size:
        raise ModelError(f"the head has {HEAD.size} bytes; the file ends before", place=f"byte {len(data)}")
    _, version, *numbers = HEAD.unpack_from(data)
    if version != VERSION:
        raise ModelError(f"the version is {VERSION}, not {version}", place="byte 4")
    header = Header(*numbers)
    _check_counts(header)
    _check_places(header, len(data))
    return header


def byte_of(field: str) -> str:
    """Returns the place of a field of the head, for errors."""
    return f"byte {FIRST_AT + 4 * Header._fields.index(field)}"


def _check_counts(header: Header) -> None:
    for field, what, least, most in (
        ("skins", "skins", 0, MOST_SKINS),
        ("vertices", "vertices", 1, MOST_VERTICES),
        ("coordinates", "texture coordinates", 0, MOST_COORDINATES),
        ("triangles", "triangles", 1, MOST_TRIANGLES),
        ("frames", "frames", 1, MOST_FRAMES),
    ):
        count = getattr(header, field)
        if not least <= count <= most:
            raise ModelError(f"a model has {least} to {most:,} {what}, not {count:,}", place=byte_of(field))
    for field in ("skin_width", "skin_height"):
        size = getattr(header, field)
        if header.coordinates and not 1 <= size <= LARGEST_SKIN:
            raise ModelError(
                f"a skin is 1 to {LARGEST_SKIN:,} pixels wide and high, not {size:,}", place=byte_of(field)
            )
    needed = FRAME_HEAD_BYTES + VERTEX_BYTES * header.vertices
    if header.frame_bytes < needed:
        raise ModelError(
            f"a frame of {header.vertices:,} vertices has {needed:,} bytes, not {header.frame_bytes:,}",
            place=byte_of("frame_bytes"),
        )


def _check_places(header: Header, size: int) -> None:
    for field, count, width, what in (
        ("skins_at", header.skins, SKIN_BYTES, "skins"),
        ("coordinates_at", header.coordinates, COORDINATE_BYTES, "texture coordinates"),
        ("triangles_at", header.triangles, TRIANGLE_BYTES, "triangles"),
        ("frames_at", header.frames, header.frame_bytes, "frames"),
    ):
        first = getattr(header, field)
        if count and not HEAD.size <= first <= size - count * width:
            raise ModelError(
                f"the {what} should lie between byte {HEAD.size} and the end of the file, byte {size:,}; "
                f"{count:,} of {width:,} bytes from byte {first:,} do not",
                place=byte_of(field),
            )
    if header.end > size:
        raise ModelError(
            f"the file should have {header.end:,} bytes; it ends at byte {size:,}", place=byte_of("end")
        )
