"""What the stream refuses: wrong messages, too many, too long, and connections that may not be."""

import contextlib

import pytest
from watcher import Watcher
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

WRONG = {
    "not json": "{",
    "no object": "[]",
    "no type": "{}",
    "unknown type": '{"type": "explode"}',
    "NaN": '{"type": "ack", "tick": NaN}',
    "text for a number": '{"type": "ack", "tick": "1"}',
    "unknown member": '{"type": "live", "please": true}',
    "unknown event": '{"type": "event", "event": "DANCE"}',
    "no such tick": '{"type": "look", "tick": 99999}',
    "unknown actor": '{"type": "event", "event": "FORWARD", "actor": 999}',
}


@pytest.mark.parametrize("message", WRONG.values(), ids=WRONG)
def test_a_wrong_message_is_answered_and_the_viewer_stays(address: str, stage: str, message: str) -> None:
    with Watcher(address, stage) as viewer:
        viewer.socket.send(message)
        assert 400 <= viewer.text("error")["status"] < 500
        viewer.say(type="ping", ref=1)
        assert viewer.text("pong")["ref"] == 1


def test_an_unknown_event_is_answered_with_those_there_are(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        viewer.say(type="event", event="DANCE", ref="x")
        error = viewer.text("error")
    assert error["ref"] == "x"
    assert "FORWARD" in error["known"]


def test_a_message_that_is_too_long_ends_the_connection(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        viewer.socket.send("x" * (65 << 10))
        with pytest.raises(ConnectionClosed) as closed:
            viewer.text("pong")
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1009


def test_who_floods_is_cut_off(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        with contextlib.suppress(ConnectionClosed):
            for _ in range(2_000):
                viewer.say(type="ping")
        with pytest.raises(ConnectionClosed) as closed:
            viewer.text("nothing")
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 4029


@pytest.mark.parametrize(
    ("path", "options", "status"),
    [
        ("/api/stages/nowhere/stream", {}, 404),
        ("/api/stages/main/stream?frames=film", {}, 422),
        ("/api/stages/main/stream", {"subprotocols": ["statwalk.v9"]}, 400),
        ("/api/stages/main/stream", {"origin": "https://evil.example"}, 403),
    ],
)
def test_refused_before_the_upgrade(address: str, path: str, options: dict, status: int) -> None:
    with pytest.raises(InvalidStatus) as refused:
        connect(f"ws://{address}{path}", **options)
    assert refused.value.response.status_code == status
