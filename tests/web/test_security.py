"""The guard alone: which Host, Origin, Sec-Fetch-Site and body it lets in. tests/web/test_matrix.py tries it
on every route.
"""

import asyncio
from typing import Any

import pytest
from statwalk.web.security import SECURITY_HEADERS, Guard
from statwalk.web.settings import LARGEST_BODY_BYTES, LOOPBACK_HOSTS

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
    kind: str = "http", method: str = "GET", path: str = "/api/stages", headers: Any = (), **given: str
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

    asyncio.run(Guard(inside, LOOPBACK_HOSTS)(scope, receive, send))
    return sent


def status(**request: Any) -> int:
    first = knock(**request)[0]
    return 101 if first["type"] == "websocket.accept" else first["status"]


GOOD_HOSTS = ["127.0.0.1:8000", "localhost:8000", "[::1]:8000", "LOCALHOST:8000", "localhost"]
BAD_HOSTS = [
    "evil.example",
    "127.0.0.1.evil.example",
    "localhost.evil.example",
    "127.0.0.1@evil",
    "127.0.0.1:8000@evil",
    "evil.example:8000",
    "localhost:port",
    "localhost:",
    "localhost:8000:8000",
    "",
    " localhost",
    "[::1",
    "::1",
    "0.0.0.0:8000",
    "2130706433",
    "localhost/",
]


@pytest.mark.parametrize("kind", ["http", "websocket"])
@pytest.mark.parametrize("host", GOOD_HOSTS)
def test_own_names_are_let_in(kind: str, host: str) -> None:
    assert status(kind=kind, host=host) in (200, 101)


@pytest.mark.parametrize("kind", ["http", "websocket"])
@pytest.mark.parametrize("host", BAD_HOSTS)
def test_other_names_are_refused(kind: str, host: str) -> None:
    assert status(kind=kind, host=host) == 421


@pytest.mark.parametrize("kind", ["http", "websocket"])
def test_no_host_and_two_hosts_are_refused(kind: str) -> None:
    assert status(kind=kind) == 421
    assert status(kind=kind, headers=[("host", "localhost:8000")] * 2) == 421


BAD_ORIGINS = [
    "https://evil.example",
    "null",
    "http://localhost:9999",
    "http://localhost",
    "http://localhost.evil.example:8000",
    "http://evil.example/localhost:8000",
    "http://localhost:8000.evil.example",
    "http://localhost:8000@evil.example",
    "http://127.0.0.1:8000",
    "localhost:8000",
    "file://localhost:8000",
    "",
]


@pytest.mark.parametrize(
    "request_",
    [{"kind": "websocket"}, {"method": "GET"}, {"method": "POST"}],
    ids=["websocket", "get", "post"],
)
@pytest.mark.parametrize("origin", BAD_ORIGINS)
def test_foreign_origins_are_refused(request_: dict[str, str], origin: str) -> None:
    assert status(**request_, host="localhost:8000", origin=origin) == 403


@pytest.mark.parametrize("origin", ["http://localhost:8000", "HTTP://LOCALHOST:8000"])
def test_the_own_origin_is_let_in_whatever_its_case(origin: str) -> None:
    assert status(kind="websocket", host="localhost:8000", origin=origin) == 101


def test_programs_without_origin_are_let_in() -> None:
    assert status(kind="websocket", host="localhost:8000") == 101


@pytest.mark.parametrize("site", ["cross-site", "same-site", "nonsense"])
def test_unsafe_methods_from_another_site_are_refused(site: str) -> None:
    assert status(method="POST", host="localhost:8000", sec_fetch_site=site) == 403
    assert status(kind="websocket", host="localhost:8000", sec_fetch_site=site) == 403


def test_a_link_from_another_site_may_open_the_page() -> None:
    assert status(host="localhost:8000", sec_fetch_site="cross-site", path="/") == 200


@pytest.mark.parametrize(
    "kind", ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x", ""]
)
def test_a_body_must_be_json(kind: str) -> None:
    assert status(method="POST", host="localhost", headers=JSON | {"content-type": kind}) == 415


@pytest.mark.parametrize("length", [str(LARGEST_BODY_BYTES + 1), "99999999999999999999", "-1", "x"])
def test_a_body_that_says_it_is_too_long_is_refused_unread(length: str) -> None:
    assert status(method="POST", host="localhost", headers=JSON | {"content-length": length}) == 413


@pytest.mark.parametrize("path", ["@google.com", "http://evil.example/", "//evil.example/", "", "*"])
def test_the_target_must_be_a_path(path: str) -> None:
    assert status(host="localhost", path=path) == 400


@pytest.mark.parametrize("host", ["localhost", "evil.example"])
def test_every_answer_has_the_security_headers(host: str) -> None:
    headers = {name.decode(): value.decode() for name, value in knock(host=host)[0]["headers"]}
    assert headers.items() >= SECURITY_HEADERS.items()
