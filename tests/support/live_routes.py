"""Every route that an application has, and one request to any of them without a server."""

import asyncio
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute

SOCKET = "WEBSOCKET"


class Asked(NamedTuple):
    """What came back: 101 for an accepted WebSocket."""

    status: int
    headers: dict[str, str]
    body: bytes

    @property
    def text(self) -> str:
        return self.body.decode(errors="replace")


def unguarded(app: Any) -> Any:
    """The application inside of its guards."""
    while not hasattr(app, "routes"):
        app = app.app
    return app


def live_routes(app: Any) -> list[tuple[str, str]]:
    """(method or WEBSOCKET, path as the route is written) of all routes of an app inside of guards."""
    return sorted(set(_routes(unguarded(app).routes)))


def _routes(routes: Iterable[BaseRoute]) -> Iterator[tuple[str, str]]:
    for route in routes:
        if hasattr(route, "original_router"):  # what newer FastAPI makes of an included router
            yield from _routes(route.original_router.routes)
        elif isinstance(route, Mount):
            yield "GET", route.path + "/"
        elif isinstance(route, WebSocketRoute):
            yield SOCKET, route.path
        elif isinstance(route, Route):
            yield from ((method, route.path) for method in route.methods or () if method != "HEAD")
        else:
            raise AssertionError(f"{route} is a kind of route that no test would reach")


def filled(path: str, stage: str = "main", name: str = "faq-walker") -> str:
    """The path with its parameters filled in."""
    values = {"stage_id": stage, "actor_id": "1", "name": name, "machine": name, "suffix": "glb"}
    for parameter, value in (values | {"link_id": "1", "number": "1"}).items():
        path = path.replace(f"{{{parameter}}}", value)
    assert "{" not in path, f"{path}: say here what to fill in"
    return path


Headers = Mapping[str, str] | Iterable[tuple[str, str]]


async def ask(
    app: Any, method: str, path: str, headers: Headers = (), body: bytes = b"", query: str = ""
) -> Asked:
    """Sends one request to an ASGI application."""
    kind = "websocket" if method == SOCKET else "http"
    pairs = headers.items() if isinstance(headers, Mapping) else headers
    scope = {
        "type": kind,
        "method": method,
        "path": path,
        "raw_path": path.encode(),
        "query_string": query.encode(),
        "root_path": "",
        "headers": [(name.encode(), value.encode()) for name, value in pairs],
        "subprotocols": [],
        "extensions": {"websocket.http.response": {}},
        "server": ("127.0.0.1", 8000),
        "client": ("127.0.0.1", 50_000),
        "scheme": "http",
        "http_version": "1.1",
    }
    first = [
        {"type": "websocket.connect"}
        if kind == "websocket"
        else {"type": "http.request", "body": body, "more_body": False}
    ]
    sent: list[Any] = []

    async def receive() -> Any:
        return first.pop() if first else await asyncio.Event().wait()

    async def send(message: Any) -> None:
        sent.append(message)

    await app(scope, receive, send)
    if sent[0]["type"] == "websocket.accept":
        return Asked(101, {}, b"")
    fields = {name.decode().lower(): value.decode() for name, value in sent[0].get("headers", ())}
    return Asked(sent[0]["status"], fields, b"".join(part.get("body", b"") for part in sent[1:]))
