"""The guard alone: which Host, Origin and body it lets in.

tests/reliability/test_r12_foreign_pages.py tries what it refuses on every route.
"""

import asyncio
from typing import Any

import pytest
from statwalk.web.same_origin import OwnNames
from statwalk.web.security import Guard
from statwalk.web.settings import LARGEST_BODY_BYTES, LOOPBACK

JSON = {"content-type": "application/json", "content-length": "2"}


async def inside(scope: Any, receive: Any, send: Any) -> None:
    if scope["type"] == "websocket":
        await send({"type": "websocket.accept"})
        return
    while (await receive()).get("more_body"):
        pass
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": b"in"})


def knock(
    kind: str = "http",
    method: str = "GET",
    path: str = "/api/stages",
    headers: Any = (),
    names: OwnNames = LOOPBACK,
    **given: str,
) -> list[Any]:
    """What comes back from the guard for a request with these headers (a mapping, or pairs)."""
    pairs = list(headers.items() if isinstance(headers, dict) else headers) + [
        (name.replace("_", "-"), value) for name, value in given.items()
    ]
    scope = {
        "type": kind,
        "method": method,
        "path": path,
        "query_string": b"",
        "headers": [(n.encode(), v.encode()) for n, v in pairs],
    }
    scope |= {"extensions": {"websocket.http.response": {}}}
    sent: list[Any] = []

    async def receive() -> Any:
        return {"type": "http.request", "body": b"{}"}

    async def send(message: Any) -> None:
        sent.append(message)

    asyncio.run(Guard(inside, names)(scope, receive, send))
    return sent


def status(**request: Any) -> int:
    first = knock(**request)[0]
    return 101 if first["type"] == "websocket.accept" else first["status"]


GOOD_HOSTS = ["127.0.0.1:8000", "localhost:8000", "[::1]:8000", "LOCALHOST:8000", "localhost"]


@pytest.mark.parametrize("kind", ["http", "websocket"])
@pytest.mark.parametrize("host", GOOD_HOSTS)
def test_own_names_are_let_in(kind: str, host: str) -> None:
    assert status(kind=kind, host=host) in (200, 101)


@pytest.mark.parametrize("origin", ["http://localhost:8000", "HTTP://LOCALHOST:8000"])
def test_the_own_origin_is_let_in_whatever_its_case(origin: str) -> None:
    assert status(kind="websocket", host="localhost:8000", origin=origin) == 101


def test_programs_without_origin_are_let_in() -> None:
    assert status(kind="websocket", host="localhost:8000") == 101


SHARED = OwnNames(("anim.example",), "https://anim.example")


@pytest.mark.parametrize(
    ("host", "origin", "is_own"),
    [
        ("anim.example", "https://anim.example", True),
        ("anim.example:443", "https://anim.example:443", True),
        ("anim.example:8000", "https://anim.example", True),  # a proxy may add its own port
        ("anim.example", "http://anim.example", False),
        ("anim.example:8443", "https://anim.example:8443", False),
        ("anim.example", "https://localhost", False),
    ],
)
def test_a_server_with_a_public_address_knows_only_the_page_there(
    host: str, origin: str, is_own: bool
) -> None:
    assert status(kind="websocket", names=SHARED, host=host, origin=origin) == (101 if is_own else 403)


@pytest.mark.parametrize(
    "kind", ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x", ""]
)
def test_a_body_must_be_json(kind: str) -> None:
    assert status(method="POST", host="localhost", headers=JSON | {"content-type": kind}) == 415


@pytest.mark.parametrize("length", [str(LARGEST_BODY_BYTES + 1), "99999999999999999999", "-1", "x"])
def test_a_body_that_says_it_is_too_long_is_refused_unread(length: str) -> None:
    assert status(method="POST", host="localhost", headers=JSON | {"content-length": length}) == 413
