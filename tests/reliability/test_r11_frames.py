"""R-11: each WebSocket frame that RFC 6455 allows is answered, each other one closes its connection with the
right code, and the server goes on serving others.

The protocol class is the product's, the application an echo.
"""

from collections.abc import Iterator

import pytest
from frame_cases import CASES, HELLO, Case, in_parts
from raw_frames import BINARY, CLOSE, TEXT, Echo, RawPeer, close, frame
from serving import serving


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    with serving(Echo()) as address:
        yield address


@pytest.fixture(scope="module")
def neighbour(address: str) -> Iterator[RawPeer]:
    """Another viewer of the same server, from the first case to the last."""
    with RawPeer(address) as neighbour:
        yield neighbour


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_frame_is_answered_as_the_standard_says(address: str, neighbour: RawPeer, case: Case) -> None:
    with RawPeer(address) as peer:
        peer.send(case.sent, case.pieces)
        if case.code is None:
            assert tuple(peer.receive() for _ in case.back) == case.back
            peer.send(close(1000))
        *back, last = peer.receive_all()
        assert tuple(back) == case.back[: len(back)]  # what is wrong may end the connection before an echo
        assert (last[0], int.from_bytes(last[1][:2], "big")) == (
            CLOSE,
            1000 if case.code is None else case.code,
        )
    neighbour.send(frame(TEXT, HELLO))
    assert neighbour.receive() == (TEXT, HELLO)


def test_a_peer_that_leaves_within_a_frame_harms_nobody(address: str, neighbour: RawPeer) -> None:
    whole = in_parts(HELLO, HELLO)
    for length in range(len(whole)):
        with RawPeer(address) as peer:
            peer.send(whole[:length])
    neighbour.send(frame(BINARY, HELLO))
    assert neighbour.receive() == (BINARY, HELLO)
