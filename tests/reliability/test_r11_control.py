"""The control of R-11: a server that checks no frames answers otherwise than the standard says."""

import pytest
import raw_frames
from frame_cases import CASES, Case
from raw_frames import CLOSE, Echo, RawPeer
from serving import serving
from websockets.frames import Frame

SECONDS = 1.0
"""after which a server that should have closed the connection has not"""
WRONG = {name: case for name, case in CASES.items() if case.code == 1002}


def is_closed_with(address: str, case: Case) -> int:
    """The code with which a server closes the connection after a case; 0: it does not."""
    with RawPeer(address) as peer:
        peer.send(case.sent, case.pieces)
        try:
            *_, last = peer.receive_all()
        except TimeoutError:
            return 0
        return int.from_bytes(last[1][:2], "big") if last[0] == CLOSE else 0


def test_r11_a_server_that_checks_no_frames_is_found_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Frame, "check", lambda _: None)
    monkeypatch.setattr(raw_frames, "PATIENCE", SECONDS)
    with serving(Echo()) as address:
        assert any(is_closed_with(address, case) != 1002 for case in WRONG.values())
