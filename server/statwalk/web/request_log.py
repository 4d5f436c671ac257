"""The outermost middleware: gives each request an id, logs it, and counts its answer.

It never logs a query string, which may hold a secret.
"""

from __future__ import annotations

import logging
import re
import secrets
import time
from dataclasses import dataclass
from typing import Any

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from uvicorn._types import WebSocketScope

from statwalk.web.log_format import DETAILS, REQUEST_ID
from statwalk.web.metrics import Metrics

ID_HEADER = "x-request-id"
ID = re.compile(r"[\x21-\x7e]{1,64}")
FACTS = "statwalk.facts"
"""the key in the ASGI scope of the request's facts"""
CUT = "statwalk.cut"
"""the key in the state of a connection, which outlives the copies of its scope, of why the server cut it"""
LONGEST_PATH = 200
FIRST_REFUSAL = 400
STARTS = ("http.response.start", "websocket.http.response.start", "websocket.accept")
log = logging.getLogger("statwalk.requests")


@dataclass
class RequestFacts:
    """What the log and the metrics say of a request; the layers inside fill it in."""

    status: int = 0
    """the HTTP status of the answer, 101 for a socket; 0 if there was none"""
    closed: int = 0
    """the code with which the server closed the socket"""
    limit: str = ""
    """the limit that refused the request"""
    scope: Scope | None = None
    """the scope that the router has completed"""

    @property
    def route(self) -> str:
        """The template of the route; `other` where the path belongs to none."""
        path = getattr((self.scope or {}).get("route"), "path", "")
        return path if isinstance(path, str) and path else "other"


def note_scope(scope: Scope) -> None:
    """Notes the scope that the router will complete; for HEAD it is a copy."""
    facts = scope.get(FACTS)
    if isinstance(facts, RequestFacts):
        facts.scope = scope


def note_limit(scope: Scope, limit: str) -> None:
    """Notes the name of the limit that refuses a request."""
    facts = scope.get(FACTS)
    if isinstance(facts, RequestFacts):
        facts.limit = limit


def note_cut(scope: WebSocketScope, code: int, limit: str) -> None:
    """Notes that the server cuts a socket that takes no close frame: the code that it should have got, and
    the limit.
    """
    scope.get("state", {})[CUT] = code, limit


def _id_of(scope: Scope) -> str:
    """Returns the client's X-Request-ID if it is short and printable, else a new id."""
    wanted = Headers(scope=scope).get(ID_HEADER, "")
    return wanted if ID.fullmatch(wanted) else secrets.token_hex(8)


class RequestLog:
    """Wraps the whole application, so that also what the guard refuses has an id and is counted."""

    def __init__(self, app: ASGIApp, metrics: Metrics) -> None:
        self.app, self.metrics = app, metrics

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answers a request with its id, and counts and logs the answer."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        request_id, facts, began = _id_of(scope), RequestFacts(), time.perf_counter()
        REQUEST_ID.set(request_id)  # each request has a task of its own, and with it a context
        inner = {**scope, FACTS: facts}
        facts.scope = inner

        async def send_with_id(message: Message) -> None:
            await send(_noted(message, request_id, facts))

        try:
            await self.app(inner, receive, send_with_id)
        finally:
            self._count(scope, facts, time.perf_counter() - began)

    def _count(self, scope: Scope, facts: RequestFacts, seconds: float) -> None:
        method = scope.get("method", "GET")
        self.metrics.count_answer(method, facts.route, facts.status)
        if cut := scope.get("state", {}).get(CUT):
            facts.closed, facts.limit = cut
        for status in (facts.status, facts.closed):
            if status >= FIRST_REFUSAL:
                self.metrics.count_refusal(status, facts.limit)
        log.info(
            "%s %s %d", method, _path(scope), facts.status, extra={DETAILS: _details(scope, facts, seconds)}
        )


def _noted(message: Message, request_id: str, facts: RequestFacts) -> Message:
    """Returns the message, with the id if it begins the answer; notes its status or close code."""
    if message["type"] == "websocket.close":
        facts.closed = message.get("code", 1000)
    if message["type"] not in STARTS:
        return message
    facts.status = message.get("status", 101)
    headers = MutableHeaders(raw=list(message.get("headers", [])))
    headers[ID_HEADER] = request_id
    return {**message, "headers": headers.raw}


def _path(scope: Scope) -> str:
    """Returns the path as it was sent, without the query."""
    raw: bytes = scope.get("raw_path") or scope["path"].encode("utf-8", "replace")
    return raw.partition(b"?")[0].decode("latin-1")[:LONGEST_PATH]


def _details(scope: Scope, facts: RequestFacts, seconds: float) -> dict[str, Any]:
    client = scope.get("client")
    return {
        "method": scope.get("method", "GET"),
        "path": _path(scope),
        "route": facts.route,
        "status": facts.status,
        "closed": facts.closed,
        "limit": facts.limit,
        "client": client[0] if client else "",
        "milliseconds": round(seconds * 1_000, 1),
    }
