"""Whatever a viewer says on its socket, it is answered, and the socket lives on."""

import json
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from watcher import Watcher

HUGE = 99_999_999_999_999_999_999
ODD = [
    "9" * 30,
    str(HUGE),
    f"-{HUGE}",
    str(2**64),
    str(2**63),
    str(2**53),
    "1e999",
    "NaN",
    "-Infinity",
    '"\\ud800"',
    "[[]]",
    "{}",
    "true",
]
MESSAGES = [
    '{"type": "ping", "ref": %s}',
    '{"type": "event", "event": "FORWARD", "ref": %s}',
    '{"type": "event", "event": "FORWARD", "actor": %s}',
    '{"type": "event", "event": "FORWARD", "tick": %s}',
    '{"type": "event", "event": %s, "ref": 1}',
    '{"type": "set", "parameter": "speed", "value": %s}',
    '{"type": "set", "parameter": "none", "value": 1, "ref": %s}',
    '{"type": "ack", "tick": %s}',
    '{"type": "look", "tick": %s, "ref": 1}',
    '{"type": "frames", "frames": %s}',
    '{"type": "name", "name": %s}',
    '{"type": "watch", "actor": %s}',
    '{"type": "follow", "viewer": %s}',
    '{"type": "camera", "position": [%s, 0, 0], "target": [0, 0, 0]}',
    '{"type": %s}',
    '{"type": "nothing", "ref": %s}',
    "%s",
]


def answered(viewer: Watcher, text: str, ref: int) -> bool:
    """Sends a message and a ping after it; whether the pong comes."""
    viewer.socket.send(text)
    viewer.say(type="ping", ref=ref)
    while (pong := viewer.text("pong"))["ref"] != ref:
        pass
    return bool(pong)


@pytest.mark.parametrize("message", MESSAGES)
def test_odd_values_do_not_end_the_socket(address: str, stage: str, message: str) -> None:
    with Watcher(address, stage) as viewer:
        assert all(answered(viewer, message % odd, ref) for ref, odd in enumerate(ODD))


def test_a_ref_that_cannot_be_said_again_is_named(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        viewer.say(type="ping", ref=HUGE)
        error = viewer.text("error")
    assert (error["status"], error["ref"], error["errors"][0]["field"].split(".")[:2]) == (
        422,
        None,
        ["ping", "ref"],
    )


NUMBERS = st.integers(-HUGE, HUGE) | st.floats(allow_nan=False)
VALUES = st.recursive(
    st.none() | st.booleans() | NUMBERS | st.text(max_size=20),
    lambda inner: st.lists(inner, max_size=3),
    max_leaves=5,
)
NAMES = st.sampled_from(
    [
        "type",
        "ref",
        "event",
        "actor",
        "kind",
        "tick",
        "parameter",
        "value",
        "frames",
        "name",
        "viewer",
        "target",
    ]
)
KINDS = ["ping", "event", "set", "ack", "look", "live", "frames", "name", "watch", "camera", "follow"]
SENSIBLE = st.sampled_from(KINDS).map(lambda kind: {"type": kind, "event": "FORWARD"})


@settings(max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(sensible=SENSIBLE, odd=st.dictionaries(NAMES, VALUES, max_size=4))
def test_any_message_is_answered(
    address: str, stage: str, sensible: dict[str, Any], odd: dict[str, Any]
) -> None:
    with Watcher(address, stage) as viewer:
        assert answered(viewer, json.dumps(sensible | odd), 1)
