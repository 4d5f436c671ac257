"""The door: one ASGI layer around everything, for HTTP and WebSocket alike.

It lets in who calls this server by a name of its own (Host), from a page of its own (Origin, Sec-Fetch-Site), with a body of a
bounded size: JSON, or a model where characters are uploaded. It puts the security headers on what goes out. A page on the internet
that knows the port gets nothing.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from statwalk.web.problem import Problem, answer
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
    """Name and port of `host[:port]`, lower case; None where it is not of that form."""
    match = AUTHORITY.fullmatch(text.lower())
    return (match[1], match[2] or default_port) if match else None


def origin_authority(origin: str) -> tuple[str, str] | None:
    """Name and port of an Origin header; None for `null` and whatever is no http origin."""
    scheme, separator, rest = origin.lower().partition("://")
    return authority(rest, DEFAULT_PORTS[scheme]) if separator and scheme in DEFAULT_PORTS else None


def check_host(headers: Headers, hosts: Iterable[str]) -> tuple[str, str]:
    """The one Host header's name and port; 421 where it is not a name of this server (DNS rebinding)."""
    given = headers.getlist("host")
    found = authority(given[0], "80") if len(given) == 1 else None
    if found is None or found[0] not in hosts:
        raise Problem(421, "this server does not answer to that Host; it answers to its loopback names", known=hosts)
    return found


def check_origin(headers: Headers, host: tuple[str, str]) -> None:
    """403 where a page of another origin asks. Programs send no Origin; browsers always do where it matters."""
    origins = headers.getlist("origin")
    if origins and (len(origins) > 1 or origin_authority(origins[0]) != host):
        raise Problem(403, "requests from pages of another origin are refused")


def check_fetch_site(headers: Headers) -> None:
    """403 where the browser itself says that another site's page asks."""
    if headers.get("sec-fetch-site", "none") not in ("same-origin", "none"):
        raise Problem(403, "requests from pages of another site are refused")


class Bodies(NamedTuple):
    """The bodies that a request may have: their length in bytes, and their content types."""

    most: int
    types: tuple[str, ...]

    def check(self, headers: Headers) -> None:
        """415 where a body is of another type, 413 where it says that it is too long."""
        length = headers.get("content-length", "0")
        if not length.isdecimal() or len(length) > 9 or int(length) > self.most:
            raise self.too_long()
        if int(length) == 0 and "transfer-encoding" not in headers:
            return
        if headers.get("content-type", "").partition(";")[0].strip().lower() not in self.types:
            raise Problem(415, f"the body must be {' or '.join(self.types)}", field="Content-Type")

    def too_long(self) -> Problem:
        """What a longer body gets."""
        return Problem(413, f"a body may have {self.most} bytes")

    def counted(self, receive: Receive) -> Receive:
        """`receive`, counting: a body without a length is cut off at the limit too."""
        taken = 0

        async def counted() -> Message:
            nonlocal taken
            message = await receive()
            taken += len(message.get("body", b""))
            if taken > self.most:
                raise self.too_long()
            return message

        return counted


JSON = Bodies(LARGEST_BODY_BYTES, ("application/json",))
MODEL = Bodies(
    LARGEST_UPLOAD_BYTES,
    ("model/gltf-binary", "model/gltf+json", "application/zip", "application/x-zip-compressed", "application/octet-stream"),
)
UPLOAD = re.compile(r"/api/characters/[^/]+")


def bodies(scope: Scope) -> Bodies:
    """What a request may bring: a model where a character is put, else JSON."""
    return MODEL if scope["method"] == "PUT" and UPLOAD.fullmatch(scope["path"]) else JSON


class Guard:
    """The outermost layer; `hosts` are the names this server answers to, in lower case, IPv6 in brackets."""

    def __init__(self, app: ASGIApp, hosts: Iterable[str]) -> None:
        self.app = app
        self.hosts = tuple(host.lower() for host in hosts)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Checks, then passes on; a refusal is answered here, before any route or accept."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        send = with_security_headers(send)
        try:
            self.check(scope)
        except Problem as problem:
            await answer(problem.body())(scope, receive, send)
            return
        receive = bodies(scope).counted(receive) if scope["type"] == "http" else receive
        await self.app(with_head_as_get(scope), receive, send)

    def check(self, scope: Scope) -> None:
        """Everything that can be said from the request line and the headers."""
        headers = Headers(scope=scope)
        host = check_host(headers, self.hosts)
        if not scope["path"].startswith("/") or urlsplit(scope["path"]).netloc:
            raise Problem(400, "the request's target must be a path")
        check_origin(headers, host)
        if scope["type"] == "websocket" or scope["method"] not in SAFE_METHODS:
            check_fetch_site(headers)
            if scope["type"] == "http":
                bodies(scope).check(headers)


def with_head_as_get(scope: Scope) -> Scope:
    """HEAD is answered as GET; the server that called leaves the body out."""
    return {**scope, "method": "GET"} if scope["type"] == "http" and scope["method"] == "HEAD" else scope


def with_security_headers(send: Send) -> Send:
    """`send`, adding the security headers to every response, a refused upgrade's too."""

    async def guarded(message: Message) -> None:
        if message["type"] in ("http.response.start", "websocket.http.response.start"):
            headers = MutableHeaders(raw=list(message.get("headers", [])))
            for name, value in SECURITY_HEADERS.items():
                headers.setdefault(name, value)
            message = {**message, "headers": headers.raw}
        await send(message)

    return guarded
