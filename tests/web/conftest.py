"""A client without a socket, and a server with one."""

from collections.abc import AsyncIterator, Iterator
from typing import Any

import httpx
import pytest
from serving import PATIENCE, serving
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

OWN = "http://localhost"


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


@pytest.fixture(scope="session")
def app() -> Any:
    return create_app(Settings(main_stage=False))


@pytest.fixture
async def client(app: Any) -> AsyncIterator[httpx.AsyncClient]:
    """A client of an app that many tests share: the stages that a test opens go with the test."""
    async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url=OWN) as client:
        before = {stage["id"] for stage in (await client.get("/api/stages")).json()}
        yield client
        for stage in (await client.get("/api/stages")).json():
            if stage["id"] not in before:
                await client.delete(f"/api/stages/{stage['id']}")


@pytest.fixture(scope="session")
def address() -> Iterator[str]:
    """A server on a free port, with the stage `main` in real time."""
    with serving(create_app()) as address:
        yield address


@pytest.fixture
def rest(address: str) -> Iterator[httpx.Client]:
    """A client of a server that many tests share: the stages that a test opens go with the test."""
    with httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
        before = {stage["id"] for stage in rest.get("/api/stages").json()}
        yield rest
        for stage in rest.get("/api/stages").json():
            if stage["id"] not in before:
                rest.delete(f"/api/stages/{stage['id']}")


@pytest.fixture
def stage(rest: httpx.Client) -> Iterator[str]:
    """The path of a stage with a manual clock and one walker on it."""
    opened = rest.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}]})
    yield opened.headers["Location"]
    rest.delete(opened.headers["Location"])
