"""The answers of every route to bodies that nobody should send, and to paths that lead nowhere.

tests/reliability/test_r12_foreign_pages.py tries the guard on every route.
"""

import asyncio
from typing import Any

import httpx
import pytest
from hostile import HOSTILE
from live_routes import ask, filled, live_routes
from statwalk.web.app import create_app
from statwalk.web.settings import LARGEST_BODY_BYTES, Settings

APP = create_app(Settings(folders=(), main_stage=False))
OWN = "http://localhost:8000"
ROUTES = [(method, filled(path)) for method, path in live_routes(APP)]


@pytest.mark.parametrize(("method", "path"), ROUTES)
def test_every_route_is_reached_from_the_own_page(method: str, path: str) -> None:
    headers = {"host": "localhost:8000", "origin": OWN}
    one_cell = "cell=STAT/CROUCH" if path.endswith("/measure") else ""  # all cells take half a minute
    assert asyncio.run(ask(APP, method, path, headers, query=one_cell)).status not in (403, 421, 500)


POSTS = [path for method, path in ROUTES if method == "POST"]
WITH_JSON = [
    (method, path)
    for method, path in ROUTES
    if method in ("POST", "PUT", "PATCH") and path != "/api/characters/faq-walker"
]


async def post(
    path: str, content: Any, kind: str = "application/json", method: str = "POST"
) -> httpx.Response:
    transport = httpx.ASGITransport(APP)
    async with httpx.AsyncClient(transport=transport, base_url=OWN) as client:
        return await client.request(method, path, content=content, headers={"content-type": kind})


@pytest.mark.parametrize(("method", "path"), WITH_JSON)
@pytest.mark.parametrize("body", HOSTILE.values(), ids=HOSTILE)
def test_hostile_json_is_a_client_error(method: str, path: str, body: bytes) -> None:
    answer = asyncio.run(post(path, body, method=method))
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
    assert asyncio.run(ask(APP, "GET", path, {"host": "localhost"})).status == 404
