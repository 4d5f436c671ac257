"""The guard: the outermost ASGI middleware, for HTTP and WebSocket.

It accepts a request that names this server, comes from this server's page or from a program (`same_origin`),
and has a bounded body: JSON, or a model at the address of an upload. It adds the security headers to every
response. A web page from another site gets nothing, even if it knows the port.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from starlette.datastructures import Headers
from starlette.responses import Response
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from statwalk.files.model_formats import FORMATS
from statwalk.services.access.authenticator import Authenticator
from statwalk.services.access.roles import Grant
from statwalk.web.errors import Problem, answer
from statwalk.web.gate import GRANT, Gate
from statwalk.web.same_origin import OwnNames, check_fetch_site
from statwalk.web.security_headers import PRIVATE, SECURITY_HEADERS, with_headers
from statwalk.web.settings import LARGEST_BODY_BYTES, LARGEST_UPLOAD_BYTES

SAFE_METHODS = frozenset({"GET", "HEAD", "OPTIONS"})


class BodyRules(NamedTuple):
    """The bodies that a request may have: at most `most` bytes, of one of the content `types`."""

    most: int
    types: tuple[str, ...]

    def check(self, headers: Headers) -> None:
        """Checks the headers that describe a body.

        :raises Problem: 413, when Content-Length is too large; 415, when the content type is another one.
        """
        length = headers.get("content-length", "0")
        if not length.isdecimal() or len(length) > 9 or int(length) > self.most:
            raise self._too_long()
        if int(length) == 0 and "transfer-encoding" not in headers:
            return
        if headers.get("content-type", "").partition(";")[0].strip().lower() not in self.types:
            raise Problem(415, f"the Content-Type must be {' or '.join(self.types)}", field="Content-Type")

    def _too_long(self) -> Problem:
        return Problem(413, f"the body is too large; it may have {self.most} bytes at most")

    def counted(self, receive: Receive) -> Receive:
        """Returns `receive` with a count of bytes, for bodies without Content-Length.

        The wrapped function raises `Problem` 413 when the body exceeds the limit.
        """
        taken = 0

        async def counted() -> Message:
            nonlocal taken
            message = await receive()
            taken += len(message.get("body", b""))
            if taken > self.most:
                raise self._too_long()
            return message

        return counted


JSON = BodyRules(LARGEST_BODY_BYTES, ("application/json",))
OTHER_TYPES = ("application/octet-stream", "application/x-zip-compressed", "text/plain")
"""content types of models that name no format"""
MODEL = BodyRules(
    LARGEST_UPLOAD_BYTES, tuple(dict.fromkeys((*(row.media_type for row in FORMATS), *OTHER_TYPES)))
)
ZIP = BodyRules(
    LARGEST_UPLOAD_BYTES, ("application/zip", "application/x-zip-compressed", "application/octet-stream")
)
UPLOADS = (
    (re.compile(r"/api/characters/[^/]+"), MODEL),
    (re.compile(r"/api/machines/[^/]+/import\.zip"), ZIP),
)


def _bodies(scope: Scope) -> BodyRules:
    """Returns the rules for a request's body: of an upload its own, JSON for everything else."""
    uploads = UPLOADS if scope["method"] == "PUT" else ()
    return next((rules for path, rules in uploads if path.fullmatch(scope["path"])), JSON)


class Guard:
    """The outermost middleware of a server with these names, and with tokens if it has an authenticator."""

    def __init__(self, app: ASGIApp, names: OwnNames, authenticator: Authenticator | None = None) -> None:
        self.app, self.names, self.gate = app, names, Gate(authenticator, names)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Checks a request, and passes it on; answers a refused request itself, before any route runs."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        send = with_headers(send, SECURITY_HEADERS | (PRIVATE if self.gate.authenticator else {}))
        try:
            admitted = self.admit(scope)
        except Problem as problem:
            await answer(problem.body(), dict(problem.headers or {}))(scope, receive, send)
            return
        if isinstance(admitted, Response):
            await admitted(scope, receive, send)
            return
        receive = _bodies(scope).counted(receive) if scope["type"] == "http" else receive
        await self.app({**_with_head_as_get(scope), GRANT: admitted}, receive, send)

    def admit(self, scope: Scope) -> Grant | Response:
        """Returns what the sender of a request may do, or the answer to a browser that signs in.

        :raises Problem: when the request is refused.
        """
        headers = Headers(scope=scope)
        host = self.names.check_host(headers)
        if not scope["path"].startswith("/") or scope["path"].startswith("//"):
            raise Problem(400, "the request's target must be a path that begins with one /")
        self.names.check_origin(headers, host)
        check_fetch_site(scope, headers)
        if signed_in := self.gate.sign_in(scope, headers, host):
            return signed_in
        grant = self.gate.admit(scope, headers, host)
        if scope["type"] == "http" and scope["method"] not in SAFE_METHODS:
            _bodies(scope).check(headers)
        return grant


def _with_head_as_get(scope: Scope) -> Scope:
    """Returns the scope of a HEAD request as a GET request; uvicorn leaves the body out."""
    return {**scope, "method": "GET"} if scope["type"] == "http" and scope["method"] == "HEAD" else scope
