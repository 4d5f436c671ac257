"""What the stream refuses: wrong messages, too many, too long, and connections that may not be."""

import contextlib

import httpx
import pytest
from serving import PATIENCE, serving
from statwalk.services.limits import Limits
from statwalk.web.app import create_app
from statwalk.web.settings import Settings
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


def test_a_refused_member_is_named_with_what_would_be_right(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        viewer.say(type="event", event="JUMP", actr=1)
        assert viewer.text("error")["detail"] == "event.actr: there is no such member; did you mean actor?"


def test_a_message_that_is_too_long_ends_the_connection(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        viewer.socket.send("x" * (65 << 10))
        with pytest.raises(ConnectionClosed) as closed:
            viewer.text("pong")
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1009


def flood(address: str) -> int:
    """The code with which a viewer is cut off that says too much."""
    with Watcher(address, "/api/stages/main") as viewer:
        with contextlib.suppress(ConnectionClosed):
            for _ in range(2_000):
                viewer.say(type="ping")
        with pytest.raises(ConnectionClosed) as closed:
            viewer.text("nothing")
    assert closed.value.rcvd is not None
    return closed.value.rcvd.code


def test_who_floods_is_cut_off_and_does_not_come_straight_back() -> None:
    """A server of its own: for the next seconds nobody from here may open a socket to it."""
    with serving(create_app(Settings(limits=Limits(cooling_seconds=60.0)))) as address:
        assert flood(address) == 4029
        with pytest.raises(InvalidStatus) as refused:
            connect(f"ws://{address}/api/stages/main/stream", open_timeout=PATIENCE)
        assert httpx.get(f"http://{address}/api/stages/main", timeout=PATIENCE).status_code == 200
    assert refused.value.response.status_code == 429
    assert 1 <= int(refused.value.response.headers["retry-after"]) <= 60


def test_who_has_waited_comes_back() -> None:
    with serving(create_app(Settings(limits=Limits(cooling_seconds=0.0)))) as address:
        assert (flood(address), flood(address)) == (4029, 4029)


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
        connect(f"ws://{address}{path}", open_timeout=PATIENCE, **options)
    assert refused.value.response.status_code == status
