"""At every address, 405 and OPTIONS name just the methods that the address answers to."""

import asyncio
from pathlib import Path
from typing import Any

import httpx
import pytest
from statwalk.web.allowed_methods import METHODS
from statwalk.web.app import create_app, openapi_document
from statwalk.web.settings import Settings

PATHS = openapi_document()["paths"]
PLACES = {
    "name": "faq-walker",
    "stage_id": "none",
    "actor_id": "1",
    "suffix": "bvh",
    "link_id": "1",
    "number": "1",
}


@pytest.fixture(scope="module", params=["with the page", "without"])
def app(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Any:
    folder: Path = tmp_path_factory.mktemp("dist")
    if request.param == "with the page":
        (folder / "index.html").write_text("<!doctype html>")
    return create_app(Settings(page=folder, main_stage=False))


def ask(app: Any, method: str, path: str) -> httpx.Response:
    async def asked() -> httpx.Response:
        async with httpx.AsyncClient(
            transport=httpx.ASGITransport(app), base_url="http://localhost"
        ) as client:
            return await client.request(method, path)

    return asyncio.run(asked())


@pytest.mark.parametrize("path", PATHS)
def test_an_address_of_the_api(app: Any, path: str) -> None:
    described = {method.upper() for method in PATHS[path]}
    expected = described | {"OPTIONS"} | ({"HEAD"} if "GET" in described else set())
    filled = path.format(**PLACES)
    for method in sorted({"OPTIONS", *METHODS} - described):
        answer = ask(app, method, filled)
        assert answer.status_code == (204 if method == "OPTIONS" else 405), method
        assert set(answer.headers["Allow"].split(", ")) == expected, method


@pytest.mark.parametrize("method", ["OPTIONS", "POST", "DELETE"])
def test_the_page(app: Any, method: str) -> None:
    answer = ask(app, method, "/")
    assert answer.status_code == (204 if method == "OPTIONS" else 405)
    assert answer.headers["Allow"] == "GET, HEAD, OPTIONS"


@pytest.mark.parametrize("method", ["OPTIONS", "GET", "PUT"])
@pytest.mark.parametrize("path", ["/api/nothing", "/nothing.txt"])
def test_an_address_that_nothing_has_allows_nothing(app: Any, method: str, path: str) -> None:
    answer = ask(app, method, path)
    assert (answer.status_code, answer.headers.get("Allow")) == (404, None)
