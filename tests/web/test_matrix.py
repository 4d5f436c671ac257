"""The guard on every route there is, HTTP and WebSocket, and the answers to bodies that nobody
should send.
"""

import asyncio
from collections.abc import Iterator
from typing import Any

import httpx
import pytest
from fastapi.routing import APIRoute
from hostile import HOSTILE
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from statwalk.web.app import create_app
from statwalk.web.settings import LARGEST_BODY_BYTES, Settings

APP = create_app(Settings(folders=(), main_stage=False))
OWN = "http://localhost:8000"


def every_route(routes: list[BaseRoute]) -> Iterator[tuple[str, str]]:
    """(method or WEBSOCKET, path with its parameters filled in)."""
    for route in routes:
        if hasattr(route, "original_router"):  # what newer FastAPI makes of an included router
            yield from every_route(route.original_router.routes)
        elif isinstance(route, Mount):
            yield "GET", route.path + "/"
        elif isinstance(route, WebSocketRoute):
            yield "WEBSOCKET", filled(route.path)
        elif isinstance(route, APIRoute | Route):
            yield from ((method, filled(route.path)) for method in sorted(route.methods or ()))


def filled(path: str) -> str:
    return (
        path.replace("{stage_id}", "main")
        .replace("{actor_id}", "1")
        .replace("{name}", "faq-walker")
        .replace("{machine}", "faq-walker")
    )


ROUTES = sorted(set(every_route(APP.app.routes)))


def ask(method: str, path: str, headers: dict[str, str], body: bytes = b"") -> int:
    """The status that comes back; for a WebSocket that of the refused upgrade, or 101."""
    kind = "websocket" if method == "WEBSOCKET" else "http"
    scope = {
        "type": kind,
        "method": method,
        "path": path,
        "raw_path": path.encode(),
        "query_string": b"",
        "root_path": "",
    }
    scope |= {
        "headers": [(name.encode(), value.encode()) for name, value in headers.items()],
        "subprotocols": [],
    }
    scope |= {
        "extensions": {"websocket.http.response": {}},
        "server": ("127.0.0.1", 8000),
        "scheme": "http",
        "http_version": "1.1",
    }
    sent: list[Any] = []

    first = [
        {"type": "websocket.connect"}
        if kind == "websocket"
        else {"type": "http.request", "body": body, "more_body": False}
    ]

    async def receive() -> Any:
        return first.pop() if first else await asyncio.Event().wait()

    async def send(message: Any) -> None:
        sent.append(message)

    asyncio.run(APP(scope, receive, send))
    return 101 if sent[0]["type"] == "websocket.accept" else sent[0]["status"]


def test_the_table_is_not_empty() -> None:
    methods = {method for method, _ in ROUTES}
    assert methods >= {"GET", "POST", "DELETE", "WEBSOCKET"}
    assert len(ROUTES) > 20


@pytest.mark.parametrize(("method", "path"), ROUTES)
@pytest.mark.parametrize("host", ["evil.example", "localhost.evil.example", "127.0.0.1@evil"])
def test_no_route_answers_to_a_foreign_host(method: str, path: str, host: str) -> None:
    assert ask(method, path, {"host": host}) == 421


@pytest.mark.parametrize(("method", "path"), ROUTES)
@pytest.mark.parametrize("origin", ["https://evil.example", "null", "http://localhost:9999"])
def test_no_route_answers_to_a_foreign_page(method: str, path: str, origin: str) -> None:
    assert ask(method, path, {"host": "localhost:8000", "origin": origin}) == 403


@pytest.mark.parametrize(("method", "path"), [route for route in ROUTES if route[0] not in ("GET", "HEAD")])
def test_no_route_that_changes_something_answers_to_another_site(method: str, path: str) -> None:
    assert ask(method, path, {"host": "localhost:8000", "sec-fetch-site": "cross-site"}) == 403


@pytest.mark.parametrize(("method", "path"), ROUTES)
def test_every_route_is_reached_from_the_own_page(method: str, path: str) -> None:
    assert ask(method, path, {"host": "localhost:8000", "origin": OWN}) not in (403, 421, 500)


POSTS = [path for method, path in ROUTES if method == "POST"]


async def post(path: str, content: Any, kind: str = "application/json") -> httpx.Response:
    transport = httpx.ASGITransport(APP)
    async with httpx.AsyncClient(transport=transport, base_url=OWN) as client:
        return await client.post(path, content=content, headers={"content-type": kind})


@pytest.mark.parametrize("path", POSTS)
@pytest.mark.parametrize("body", HOSTILE.values(), ids=HOSTILE)
def test_hostile_json_is_a_client_error(path: str, body: bytes) -> None:
    answer = asyncio.run(post(path, body))
    assert 400 <= answer.status_code < 500
    assert answer.headers["content-type"] == "application/problem+json"


@pytest.mark.parametrize("path", POSTS)
def test_a_form_is_no_body(path: str) -> None:
    assert asyncio.run(post(path, b"{}", "text/plain")).status_code == 415


def test_a_body_without_a_length_is_cut_off_at_the_limit() -> None:
    async def endless() -> Any:
        for _ in range(LARGEST_BODY_BYTES // 1024 + 2):
            yield b" " * 1024

    assert asyncio.run(post("/api/stages", endless())).status_code == 413


@pytest.mark.parametrize(
    "path",
    [
        "/api/nothing",
        "/../../etc/passwd",
        "/%2e%2e%2fetc/passwd",
        "/assets/..%5c..%5cx",
        "/api/stages/%00",
        "/x" * 2_000,
    ],
)
def test_paths_that_lead_nowhere_are_not_found(path: str) -> None:
    assert ask("GET", path, {"host": "localhost"}) == 404
