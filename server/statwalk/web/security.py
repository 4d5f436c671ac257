"""The guard: the outermost ASGI middleware, for HTTP and WebSocket.

It accepts a request that names this server (Host), comes from this server's page or from a program (Origin,
Sec-Fetch-Site), and has a bounded body: JSON, or a model at the address of an upload. It adds the security
headers to every response. A web page from another site gets nothing, even if it knows the port.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from statwalk.web.errors import Problem, answer
from statwalk.web.settings import LARGEST_BODY_BYTES, LARGEST_UPLOAD_BYTES

AUTHORITY = re.compile(r"(\[[0-9a-f:.]+\]|[a-z0-9.-]+)(?::([0-9]{1,5}))?")
SAFE_METHODS = frozenset({"GET", "HEAD", "OPTIONS"})
DEFAULT_PORTS = {"http": "80", "https": "443"}

CONTENT_SECURITY_POLICY = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self'",
        "img-src 'self' blob: data:",
        "connect-src 'self' blob: data:",  # GLTFLoader fetches a model's own textures from blob: addresses
        "worker-src 'self' blob:",
        "font-src 'self'",
        "base-uri 'none'",
        "form-action 'self'",
        "frame-ancestors 'none'",
        "object-src 'none'",
    )
)
SECURITY_HEADERS = {
    "content-security-policy": CONTENT_SECURITY_POLICY,
    "x-content-type-options": "nosniff",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "referrer-policy": "no-referrer",
}


def authority(text: str, default_port: str) -> tuple[str, str] | None:
    """Returns name and port of `host[:port]` in lower case; None if the text has another form."""
    match = AUTHORITY.fullmatch(text.lower())
    return (match[1], match[2] or default_port) if match else None


def _origin_authority(origin: str) -> tuple[str, str] | None:
    """Returns name and port of an Origin header; None for `null` and for any other scheme than http(s)."""
    scheme, separator, rest = origin.lower().partition("://")
    return authority(rest, DEFAULT_PORTS[scheme]) if separator and scheme in DEFAULT_PORTS else None


def _check_host(headers: Headers, hosts: Iterable[str]) -> tuple[str, str]:
    """Returns the Host header's name and port; the check prevents DNS rebinding.

    :raises Problem: 421, when there is not exactly one Host, or it is no name of this server.
    """
    values = headers.getlist("host")
    host = authority(values[0], "80") if len(values) == 1 else None
    if host is None or host[0] not in hosts:
        raise Problem(421, "this server has another name; use one of the known names as Host", known=hosts)
    return host


def _check_origin(headers: Headers, host: tuple[str, str]) -> None:
    """Programs send no Origin; browsers send it with every request that can change something.

    :raises Problem: 403, when the request comes from a page of another origin.
    """
    origins = headers.getlist("origin")
    if origins and (len(origins) > 1 or _origin_authority(origins[0]) != host):
        raise Problem(403, "requests from pages of another origin are refused")


def _check_fetch_site(headers: Headers) -> None:
    """Checks the header by which a browser names the requesting page's site.

    :raises Problem: 403, when it is another site.
    """
    if headers.get("sec-fetch-site", "none") not in ("same-origin", "none"):
        raise Problem(403, "requests from pages of another site are refused")


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
            raise Problem(415, f"the body must be {' or '.join(self.types)}", field="Content-Type")

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
MODEL = BodyRules(
    LARGEST_UPLOAD_BYTES,
    (
        "model/gltf-binary",
        "model/gltf+json",
        "application/zip",
        "application/x-zip-compressed",
        "application/octet-stream",
        "model/bvh",
        "text/plain",
    ),
)
UPLOAD = re.compile(r"/api/characters/[^/]+")


def _bodies(scope: Scope) -> BodyRules:
    """Returns the rules for a request's body: a model for an upload, JSON for everything else."""
    return MODEL if scope["method"] == "PUT" and UPLOAD.fullmatch(scope["path"]) else JSON


class Guard:
    """The outermost middleware; `hosts` are the server's names in lower case, IPv6 addresses in brackets."""

    def __init__(self, app: ASGIApp, hosts: Iterable[str]) -> None:
        self.app = app
        self.hosts = tuple(host.lower() for host in hosts)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Checks a request, and passes it on; answers a refused request itself, before any route runs."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        send = _with_security_headers(send)
        try:
            self.check(scope)
        except Problem as problem:
            await answer(problem.body())(scope, receive, send)
            return
        receive = _bodies(scope).counted(receive) if scope["type"] == "http" else receive
        await self.app(_with_head_as_get(scope), receive, send)

    def check(self, scope: Scope) -> None:
        """Checks the request line and the headers.

        :raises Problem: when the request is refused.
        """
        headers = Headers(scope=scope)
        host = _check_host(headers, self.hosts)
        if not scope["path"].startswith("/") or urlsplit(scope["path"]).netloc:
            raise Problem(400, "the request's target must be a path that begins with one /")
        _check_origin(headers, host)
        if scope["type"] == "websocket" or scope["method"] not in SAFE_METHODS:
            _check_fetch_site(headers)
            if scope["type"] == "http":
                _bodies(scope).check(headers)


def _with_head_as_get(scope: Scope) -> Scope:
    """Returns the scope of a HEAD request as a GET request; uvicorn leaves the body out."""
    return {**scope, "method": "GET"} if scope["type"] == "http" and scope["method"] == "HEAD" else scope


def _with_security_headers(send: Send) -> Send:
    """Returns `send` with the security headers on every response, also on a refused WebSocket upgrade."""

    async def send_with_headers(message: Message) -> None:
        if message["type"] in ("http.response.start", "websocket.http.response.start"):
            headers = MutableHeaders(raw=list(message.get("headers", [])))
            for name, value in SECURITY_HEADERS.items():
                headers.setdefault(name, value)
            message = {**message, "headers": headers.raw}
        await send(message)

    return send_with_headers
