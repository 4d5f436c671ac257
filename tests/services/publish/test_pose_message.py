"""The pose message, byte by byte as docs/api.md says it, and back."""

import struct

import numpy as np
import pytest
from statwalk.maths.pose import Pose
from statwalk.services.publish import pose_message
from statwalk.stage.state.frame import CastFrame, Frame

N, J, W, L = 2, 3, 1, 1
RANDOM = np.random.default_rng(1)
ARRAYS = {
    "translation": RANDOM.random((N, J, 3), np.float32),
    "rotation": RANDOM.random((N, J, 4), np.float32),
    "scale": RANDOM.random((N, J, 3), np.float32),
    "weights": RANDOM.random((N, W), np.float32),
}
HEADING = np.array([0.0, np.pi / 2])
CAST = CastFrame(
    role=None,  # type: ignore[arg-type]  # the message does not say whose poses these are
    ids=np.array([1, 2]),
    pose=Pose(**ARRAYS),
    root_position=np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]),
    heading=HEADING,
    state=np.array([[4], [5]], np.int16),
    phase=np.array([[0.25], [0.5]]),
    blend=np.array([[1.0], [0.0]]),
)
FRAME = Frame(7, "00000000deadbeef", (CAST, CAST), (), ())
DATA = pose_message.encode(FRAME, epoch=3, head=9)


def test_the_header() -> None:
    assert struct.unpack_from("<IIIIQII", DATA) == (0x31575453, 3, 7, 9, 0xDEADBEEF, 2, len(DATA))
    assert DATA[:4] == b"STW1"


def test_the_length_is_what_the_layout_gives() -> None:
    cast = 16 + 4 * N * (J * 10 + W + 7 + 3 * L)
    assert len(DATA) == 32 + 2 * cast


def test_the_first_cast_lies_where_it_should() -> None:
    assert struct.unpack_from("<IIII", DATA, 32) == (N, J, W, L)
    assert np.array_equal(np.frombuffer(DATA, "<f4", N * J * 3, 48), ARRAYS["translation"].ravel())


def test_what_is_decoded_is_what_was_encoded() -> None:
    message = pose_message.decode(DATA)
    assert (message.epoch, message.tick, message.head, message.hash) == (3, 7, 9, 0xDEADBEEF)
    for cast in message.casts:
        assert all(np.array_equal(getattr(cast, name), array) for name, array in ARRAYS.items())
        assert cast.state.tolist() == [[4], [5]]
        assert cast.phase.tolist() == [[0.25], [0.5]]


def test_the_root_is_a_place_and_a_turn_about_y() -> None:
    half = np.sqrt(0.5)
    root = pose_message.decode(DATA).casts[0].root
    assert np.allclose(root, [[1, 2, 3, 0, 0, 0, 1], [4, 5, 6, 0, half, 0, half]])


@pytest.mark.parametrize(
    "data",
    [b"", DATA[:20], DATA[:-1], b"glTF" + DATA[4:]],
    ids=["nothing", "no header", "cut short", "a GLB"],
)
def test_other_bytes_are_refused(data: bytes) -> None:
    with pytest.raises(ValueError, match="pose message"):
        pose_message.decode(data)
