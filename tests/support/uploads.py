"""A client that uploads characters and makes machines of them, on a server with a data folder of its own."""

from pathlib import Path
from typing import Any

import httpx
import tiny_model
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

BINARY = {"content-type": "application/octet-stream"}


def opened(folder: Path) -> httpx.AsyncClient:
    """A client of a server that keeps its data in a folder."""
    transport = httpx.ASGITransport(create_app(Settings(main_stage=False, data=folder)))
    return httpx.AsyncClient(transport=transport, base_url="http://localhost")


async def put(
    client: httpx.AsyncClient, name: str = "tiny", data: Any = None, **headers: str
) -> httpx.Response:
    return await client.put(
        f"/api/characters/{name}",
        content=tiny_model.model() if data is None else data,
        headers=BINARY | headers,
    )


async def make(client: httpx.AsyncClient, name: str = "robot", **body: Any) -> httpx.Response:
    return await client.post("/api/machines", json={"name": name, "character": "tiny"} | body)


async def names(client: httpx.AsyncClient, kind: str) -> list[str]:
    return [one["name"] for one in (await client.get(f"/api/{kind}")).json()]


def files_of(folder: Path) -> list[str]:
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())
