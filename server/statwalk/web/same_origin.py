"""Which requests come from this server's own page, or from a program, and which from another site's page.

Three headers tell: Host names the server that the client believes to speak to, Origin the page that asks, and
Sec-Fetch-Site how that page is related to the server.
"""

from __future__ import annotations

import re
from typing import NamedTuple
from urllib.parse import urlsplit

from starlette.datastructures import Headers
from starlette.types import Scope

from statwalk.web.errors import Problem

AUTHORITY = re.compile(r"(\[[0-9a-f:.]+\]|[a-z0-9.-]+)(?::([0-9]{1,5}))?")
DEFAULT_PORTS = {"http": "80", "https": "443"}
PAGES = frozenset({"/", "/index.html", "/curves.html"})
"""what a link on another site may open"""
FROM_ELSEWHERE = "requests from pages of another site are refused"


def authority(text: str, default_port: str) -> tuple[str, str] | None:
    """Returns name and port of `host[:port]` in lower case; None if the text has another form."""
    match = AUTHORITY.fullmatch(text.lower())
    return (match[1], match[2] or default_port) if match else None


class OwnNames(NamedTuple):
    """The names of a server: `hosts` in lower case, IPv6 addresses in brackets.

    `public_url`: the https:// address at which others reach it, if it has one; only the page there is its
    own.
    """

    hosts: tuple[str, ...]
    public_url: str = ""

    def check_host(self, headers: Headers) -> str:
        """Returns the Host header; the check prevents DNS rebinding.

        :raises Problem: 421, when there is not exactly one Host, or it is no name of this server.
        """
        values = headers.getlist("host")
        host = authority(values[0], "") if len(values) == 1 else None
        if host is None or host[0] not in self.hosts:
            raise Problem(
                421, "this server has another name; use one of the known names as Host", known=self.hosts
            )
        return values[0]

    def check_origin(self, headers: Headers, host: str) -> None:
        """Programs send no Origin; browsers send it with every request that can change something.

        :raises Problem: 403, when the request comes from a page of another origin.
        """
        origins = headers.getlist("origin")
        if origins and (len(origins) > 1 or not self._is_own(origins[0], host)):
            raise Problem(403, "requests from pages of another origin are refused")

    def _is_own(self, origin: str, host: str) -> bool:
        """Returns whether an Origin is this server's; behind a proxy with TLS it is https, on port 443."""
        scheme, separator, rest = origin.lower().partition("://")
        if not separator or scheme not in DEFAULT_PORTS:
            return False
        port = DEFAULT_PORTS[scheme]
        if self.public_url:
            return scheme == "https" and authority(rest, port) == authority(
                urlsplit(self.public_url).netloc, port
            )
        return authority(rest, port) == authority(host, port)


def check_fetch_site(scope: Scope, headers: Headers) -> None:
    """Checks the header by which a browser says how the page that asks is related to this server.

    A link on another site may open the page; nothing else of this server answers to another site.

    :raises Problem: 403, when the request comes from another site.
    """
    sites = set(headers.getlist("sec-fetch-site"))
    if not sites <= {"same-origin", "none"} and not _opens_a_page(scope, headers):
        raise Problem(403, FROM_ELSEWHERE)


def _opens_a_page(scope: Scope, headers: Headers) -> bool:
    """Returns whether a browser asks for a page to show it in a tab of its own."""
    return (
        scope["type"] == "http"
        and scope["method"] == "GET"
        and scope["path"] in PAGES
        and headers.getlist("sec-fetch-mode") == ["navigate"]
        and headers.getlist("sec-fetch-dest") == ["document"]
    )
