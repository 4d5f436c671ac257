"""The content of an MD2 file as arrays, in the units and along the axes of the file: x forward, y to the
left, z up.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.md2.md2_header import FRAME_HEAD_BYTES, TRIANGLE_BYTES, Header, read_header
from statwalk.maths.arrays import Floats

LARGEST_NUMBER = 1e6
"""of a frame's scale and place, in the file's units"""
FRAME_HEAD = np.dtype([("scale", "<f4", 3), ("origin", "<f4", 3), ("name", "S16")])


class Md2Content(NamedTuple):
    """The content of a file.

    skins              the names of pictures, which lie elsewhere
    skin_size          width and height of a skin in pixels
    coordinates        (C, 2) pixels of a skin, from its upper left corner
    corners            (T, 3) vertices of the triangles, clockwise seen from outside
    corner_coordinates (T, 3) rows of `coordinates`
    names              of the F frames
    positions          (F, V, 3) float32
    normals            (F, V) numbers of normals; 162 and more mean none
    """

    skins: tuple[str, ...]
    skin_size: tuple[int, int]
    coordinates: NDArray[np.int16]
    corners: NDArray[np.uint16]
    corner_coordinates: NDArray[np.uint16]
    names: tuple[str, ...]
    positions: NDArray[np.float32]
    normals: NDArray[np.uint8]


def read_content(data: bytes) -> Md2Content:
    """Reads the content of an MD2 file.

    :raises ModelError: when the file is refused; `place` is a byte, and the message names the frame.
    """
    header = read_header(data)
    corners, corner_coordinates = _triangles(data, header)
    names, positions, normals = _frames(data, header)
    return Md2Content(
        tuple(
            _text(row)
            for row in np.frombuffer(data, "S64", header.skins, _start(header.skins_at, header.skins))
        ),
        (header.skin_width, header.skin_height),
        np.frombuffer(
            data, "<i2", 2 * header.coordinates, _start(header.coordinates_at, header.coordinates)
        ).reshape(-1, 2),
        corners,
        corner_coordinates,
        names,
        positions,
        normals,
    )


def _start(first: int, count: int) -> int:
    """Returns where a part starts; the place of an empty part may be anything."""
    return first if count else 0


def _text(letters: bytes) -> str:
    """Returns a name, which ends at its first zero byte; letters that cannot be printed become ?."""
    text = letters.split(b"\0", 1)[0].decode("latin-1").strip()
    return "".join(letter if letter.isprintable() else "?" for letter in text)


def _triangles(data: bytes, header: Header) -> tuple[NDArray[np.uint16], NDArray[np.uint16]]:
    rows = np.frombuffer(data, "<u2", 6 * header.triangles, header.triangles_at).reshape(-1, 2, 3)
    for column, what, count in (
        (0, "vertex", header.vertices),
        (1, "texture coordinate", header.coordinates),
    ):
        if column and not count:
            continue
        wrong = np.argwhere(rows[:, column] >= count)
        if len(wrong):
            row, corner = wrong[0].tolist()
            raise ModelError(
                f"triangle {row} names {what} {rows[row, column, corner]}; there are {count:,}",
                place=f"byte {header.triangles_at + TRIANGLE_BYTES * row + 6 * column + 2 * corner}",
            )
    return rows[:, 0], rows[:, 1]


def _frames(data: bytes, header: Header) -> tuple[tuple[str, ...], NDArray[np.float32], NDArray[np.uint8]]:
    """Returns names, positions and numbers of normals: a position is scale · bytes + origin."""
    shape, steps = (header.frames,), (header.frame_bytes,)
    heads = np.ndarray(shape, FRAME_HEAD, data, header.frames_at, steps)
    names = tuple(_text(name) for name in heads["name"])
    numbers = np.stack([heads["scale"], heads["origin"]], 1)
    _check_numbers(numbers, names, header)
    points = np.ndarray(
        (*shape, header.vertices, 4), np.uint8, data, header.frames_at + FRAME_HEAD_BYTES, (*steps, 4, 1)
    )
    positions = points[..., :3] * numbers[:, :1] + numbers[:, 1:]
    return names, positions.astype(np.float32), points[..., 3]


def _check_numbers(numbers: Floats, names: tuple[str, ...], header: Header) -> None:
    """Checks the scale and the origin (F, 2, 3) of all frames."""
    wrong = np.argwhere(~(np.abs(numbers) <= LARGEST_NUMBER))
    if len(wrong):
        frame, row, axis = wrong[0].tolist()
        raise ModelError(
            f"frame {frame} ({names[frame]}): the {('scale', 'origin')[row]} along {'xyz'[axis]} is "
            f"{numbers[frame, row, axis]:g}; it should lie within {LARGEST_NUMBER:,.0f}",
            place=f"byte {header.frames_at + frame * header.frame_bytes + 12 * row + 4 * axis}",
        )
