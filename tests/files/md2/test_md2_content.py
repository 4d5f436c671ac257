"""The content of an MD2 file as arrays, against a file made by hand."""

import numpy as np
import pytest
from md2_models import FACES, NAMES, PIXELS, md2, units, with_bytes, with_field
from statwalk.files.md2.md2_content import read_content


def test_it_is_what_was_written() -> None:
    content = read_content(md2())
    assert content.skins == ("players/tetra.pcx",)
    assert content.skin_size == (32, 16)
    assert content.coordinates.tolist() == [list(pixel) for pixel in PIXELS]
    assert content.corners.tolist() == [list(face) for face in FACES]
    assert content.corner_coordinates[3].tolist() == [2, 4, 3]
    assert content.names == NAMES
    assert content.normals.tolist() == [[0, 32, 52, 104]] * len(NAMES)
    assert content.positions == pytest.approx(np.array([units(frame) for frame in range(len(NAMES))]))


def test_frames_may_stand_apart() -> None:
    """A frame may have more bytes than it needs: here two frames' as one."""
    data = bytearray(with_field("frame_bytes", 2 * 56))
    data[40:44] = (3).to_bytes(4, "little")
    assert read_content(bytes(data)).names == NAMES[:5:2]


def test_no_texture_coordinates_at_all() -> None:
    assert len(read_content(with_field("coordinates", 0)).coordinates) == 0


def test_letters_that_cannot_be_printed_do_not_leave_the_file() -> None:
    assert read_content(with_bytes(68, "<4B", 27, 10, 228, 0)).skins == ("??ä",)
