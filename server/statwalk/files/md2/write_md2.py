"""Writes a character as an MD2 file: the posed vertices of every clip ten times a second. FF4."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.md2.md2_content import FRAME_HEAD
from statwalk.files.md2.md2_frames import TakenFrames, check_count, taken_frames
from statwalk.files.md2.md2_header import (
    HEAD,
    MOST_COORDINATES,
    MOST_TRIANGLES,
    MOST_VERTICES,
    SKIN_BYTES,
    START,
    VERSION,
    Header,
)
from statwalk.files.md2.md2_skin import skin_names, skin_pixels
from statwalk.maths.arrays import Ints
from statwalk.skin.primitive import Primitive
from statwalk.skin.shading import triangles

_CORNER = np.dtype([("place", "<f4", 2), ("vertex", "<i4")])
_STRIP = np.dtype([("count", "<i4"), ("corners", _CORNER, 3)])


def write_md2(character: Character) -> bytes:
    """Returns the character as an MD2 file in inches, its floor 24 units below the origin.

    :raises ContentError: when it has no triangles, or too many frames, vertices or triangles.
    """
    drawn = [row for row, part in enumerate(character.parts) if part.mode >= 4]
    if not drawn:
        raise ContentError("an MD2 file holds a mesh; the character has no triangles", file=character.name)
    parts = [character.parts[row] for row in drawn]
    corners = _faces(parts)
    check_count("triangles", len(corners), MOST_TRIANGLES)
    frames = taken_frames(character, drawn)
    check_count("vertices", frames.points.shape[1], MOST_VERTICES)
    pixels, size = skin_pixels(character, parts)
    coordinates, rows = np.unique(pixels, axis=0, return_inverse=True)
    check_count("texture coordinates", len(coordinates), MOST_COORDINATES)
    mesh = _Mesh(frames.rows[corners], coordinates, rows.reshape(-1)[corners], size)
    return _file(mesh, skin_names(character), frames)


class _Mesh(NamedTuple):
    corners: Ints
    coordinates: Ints
    corner_coordinates: Ints
    skin_size: tuple[int, int]


def _faces(parts: Sequence[Primitive]) -> Ints:
    """Returns the corners (T, 3) of all triangles, clockwise seen from outside."""
    faces, first = [], 0
    for part in parts:
        order = np.arange(len(part.positions)) if part.indices is None else part.indices.astype(np.int64)
        faces.append(triangles(order, part.mode)[:, ::-1] + first)
        first += len(part.positions)
    return np.concatenate(faces)


def _file(mesh: _Mesh, skins: list[bytes], taken: TakenFrames) -> bytes:
    """Returns the bytes: head, skins, texture coordinates, triangles, frames, GL commands."""
    frame = np.dtype([("head", FRAME_HEAD), ("points", np.uint8, taken.points.shape[1:])])
    frames = np.empty(len(taken.heads), frame)
    frames["head"], frames["points"] = taken.heads, taken.points
    parts = [
        b"".join(name.ljust(SKIN_BYTES, b"\0") for name in skins),
        mesh.coordinates.astype("<i2").tobytes(),
        np.concatenate([mesh.corners, mesh.corner_coordinates], 1).astype("<u2").tobytes(),
        frames.tobytes(),
        _commands(mesh),
    ]
    starts = np.cumsum([HEAD.size, *map(len, parts)]).tolist()
    header = Header(
        *mesh.skin_size,
        frame.itemsize,
        len(skins),
        taken.points.shape[1],
        len(mesh.coordinates),
        len(mesh.corners),
        len(parts[4]) // 4,
        len(taken.heads),
        *starts,
    )
    return HEAD.pack(START, VERSION, *header) + b"".join(parts)


def _commands(mesh: _Mesh) -> bytes:
    """Returns the triangles again as Quake II draws them: strips of one triangle each, then a 0."""
    strips = np.empty(len(mesh.corners), _STRIP)
    strips["count"] = 3
    strips["corners"]["place"] = ((mesh.coordinates + 0.5) / mesh.skin_size)[mesh.corner_coordinates]
    strips["corners"]["vertex"] = mesh.corners
    return strips.tobytes() + struct.pack("<i", 0)
