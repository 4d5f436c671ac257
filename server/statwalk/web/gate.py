"""The gate: who sends a request, by a token in a cookie or in the Authorization header, and whether they may.

`GET /?token=…` signs a browser in: the token moves from the address to a cookie.
"""

from __future__ import annotations

import re
import time
from collections.abc import Mapping
from typing import Any
from urllib.parse import parse_qs, urlsplit

from starlette.datastructures import Headers
from starlette.requests import cookie_parser
from starlette.responses import HTMLResponse, RedirectResponse, Response
from starlette.types import Scope

from statwalk.services.access.authenticator import Authenticator
from statwalk.services.access.roles import EVERYTHING, AccessRole, Grant
from statwalk.web.client_address import address_of
from statwalk.web.errors import Problem
from statwalk.web.needed_roles import SOCKET, Need, need_of
from statwalk.web.same_origin import PAGES, OwnNames, authority

GRANT = "statwalk.grant"
"""the key in the ASGI scope of what the sender of a request may do"""
UNKNOWN_SENDER = (
    "this server needs a token: open the link that it printed or that you were given, or send the header "
    "Authorization: Bearer TOKEN"
)
STAGE_ID = re.compile(r"[0-9A-Za-z_-]{1,64}")
MAY = {"view": "look", "drive": "look and drive", "admin": "do everything"}
NOBODY = Grant("", "view")
ONCE_MORE = (
    '<!doctype html><link rel="icon" href="data:,"><meta http-equiv="refresh" content="0;url={0}">'
    "<title>statwalk</title>"
)
FROM_A_LINK = ("cross-site", "same-site")


class Gate:
    """Lets requests in that a token allows; without an authenticator everyone may do everything."""

    def __init__(self, authenticator: Authenticator | None, names: OwnNames) -> None:
        self.authenticator, self.names = authenticator, names

    def admit(self, scope: Scope, headers: Headers, host: str) -> Grant:
        """Returns what the sender of a request may do.

        :raises Problem: 401, without a token that counts; 403, when it does not allow the request.
        """
        if self.authenticator is None:
            return EVERYTHING
        need = need_of(scope["method"] if scope["type"] == "http" else SOCKET, scope["path"])
        if need.role is None:
            return NOBODY
        token, is_cookie = self._token(headers, host)
        grant = self.authenticator.grant_of(token, time.monotonic())
        if grant is None:
            raise Problem(401, UNKNOWN_SENDER, headers={"WWW-Authenticate": 'Bearer realm="statwalk"'})
        if is_cookie and scope["type"] == "websocket" and "origin" not in headers:
            raise Problem(403, "a socket with a cookie needs an Origin; programs send Authorization")
        _check(need, grant)
        return grant

    def sign_in(self, scope: Scope, headers: Headers, host: str) -> Response | None:
        """Returns the answer to a request that opens the page with a token in its address, else None.

        A browser leaves the cookie out of what a link on another site opens; such a page opens itself once
        more.
        """
        if self.authenticator is None or not _opens_a_page(scope):
            return None
        query = parse_qs(scope["query_string"].decode("latin-1"))
        token = query.get("token", [""])[0]
        is_known = token and self.authenticator.grant_of(token, time.monotonic())
        from_link = headers.get("sec-fetch-site") in FROM_A_LINK
        if not is_known and (token or not from_link):
            return None
        target = _target(scope["path"], query.get("stage", [""])[0])
        answer = HTMLResponse(ONCE_MORE.format(target)) if from_link else RedirectResponse(target, 303)
        answer.headers["Cache-Control"] = "no-store"
        if is_known:
            answer.headers["Set-Cookie"] = self._cookie(token, host)
        return answer

    def _token(self, headers: Headers, host: str) -> tuple[str, bool]:
        """Returns the token of a request, and whether it is a cookie; Authorization comes first."""
        if "authorization" in headers:
            scheme, _, token = headers["authorization"].partition(" ")
            return (token.strip() if scheme.lower() == "bearer" else ""), False
        cookies = cookie_parser(headers.get("cookie", ""))
        return cookies.get(self._cookie_name(host), ""), True

    def _cookie(self, token: str, host: str) -> str:
        secure = "; Secure" if self.names.public_url else ""
        return f"{self._cookie_name(host)}={token}; HttpOnly; SameSite=Strict; Path=/{secure}"

    def _cookie_name(self, host: str) -> str:
        """Returns the name with the port: browsers send a cookie to all ports of a host."""
        if self.names.public_url:
            return f"__Host-statwalk_{urlsplit(self.names.public_url).port or 443}"
        _, port = authority(host, "80") or ("", "")
        return f"statwalk_{port}"


def sender_of(scope: Mapping[str, Any]) -> str:
    """Returns whose token an admitted request has, by the token's hash; without a token the address."""
    grant: Grant = scope.get(GRANT, EVERYTHING)
    return grant.digest or address_of(scope)


def _opens_a_page(scope: Scope) -> bool:
    return scope["type"] == "http" and scope["method"] == "GET" and scope["path"] in PAGES


def _target(path: str, stage: str) -> str:
    """Returns where a page is without the token."""
    path = "/" if path == "/index.html" else path
    return f"{path}?stage={stage}" if STAGE_ID.fullmatch(stage) else path


def _check(need: Need, grant: Grant) -> None:
    """Checks that a grant reaches so far.

    :raises Problem: 403, when it does not.
    """
    if not need.is_met_by(grant.stage):
        raise Problem(403, beyond(grant.stage))
    if need.role is not None:
        check_role(grant, need.role)


def check_role(grant: Grant, role: AccessRole) -> None:
    """Checks that a grant has a role, or one that may do more.

    :raises Problem: 403, when it has not.
    """
    if not grant.allows(role):
        raise Problem(403, f"you may only {MAY[grant.role]}; this needs the role {role}")


def beyond(stage: str | None) -> str:
    """Returns why a link to a stage does not reach what was asked for."""
    return f"your link shows stage {stage}, and nothing else of this server"
