"""Answers a request with a method that its address does not have: 405, and OPTIONS, with a true Allow header.

FastAPI's router names only the methods of the first route that fits a path; several routers share paths here,
and the page's files fit every path.
"""

from __future__ import annotations

from fastapi import Request
from starlette.routing import Match, Mount

METHODS = ("GET", "POST", "PUT", "PATCH", "DELETE")


def allowed_methods(request: Request) -> list[str]:
    """Returns the methods that the address of a request has, HEAD and OPTIONS included; empty if no route has
    the address. The page's files do not count.
    """
    routes = [route for route in request.app.routes if not isinstance(route, Mount)]
    scopes = {method: {**request.scope, "method": method} for method in METHODS}
    found = [
        method
        for method, scope in scopes.items()
        if any(route.matches(scope)[0] is Match.FULL for route in routes)
    ]
    return with_implied(found)


def with_implied(methods: list[str]) -> list[str]:
    """Returns the methods with HEAD after GET, which the server answers alike, and OPTIONS; empty stays
    empty.
    """
    if not methods:
        return []
    return [*(["GET", "HEAD"] if "GET" in methods else []), *(m for m in methods if m != "GET"), "OPTIONS"]
