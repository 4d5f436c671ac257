"""Levels of detail over REST: listed, found by a child process, and coarser models; refusals say why."""

from collections.abc import AsyncIterator
from pathlib import Path

import httpx
import pytest
from rig_shapes import human, mesh
from statwalk.files.gltf import read_model
from uploads import opened, put

pytestmark = pytest.mark.anyio


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


async def test_an_upload_gets_levels_and_coarser_models(client: httpx.AsyncClient) -> None:
    await put(client, "figure", mesh(*human()).model_glb)
    address = "/api/characters/figure"
    assert (await client.get(f"{address}/levels")).json() == []
    refused = await client.get(f"{address}/lod.glb?share=0.5")
    assert (refused.status_code, "POST" in refused.json()["detail"]) == (422, True)
    answer = await client.post(f"{address}/lod", json={})
    assert answer.status_code == 201, answer.text
    levels = (await client.get(f"{address}/levels")).json()
    assert levels[0]["error"] == 0
    assert [level["triangles"] for level in levels] == sorted(
        (level["triangles"] for level in levels), reverse=True
    )
    for level in levels[1:]:
        glb = (await client.get(f"{address}/lod.glb", params={"error": level["error"]})).content
        part = read_model(glb, "figure").parts[0]
        assert len(part.indices) // 3 <= level["triangles"]


async def test_wrong_wishes_are_refused(client: httpx.AsyncClient) -> None:
    await put(client, "figure", mesh(*human()).model_glb)
    await client.post("/api/characters/figure/lod", json={"character": "coarse"})
    assert (await client.get("/api/characters/figure/levels")).json() == []
    address = "/api/characters/coarse/lod.glb"
    for wish in (
        "",
        "?error=-1",
        "?share=2",
        "?vertices=0",
        "?vertices=1",
        "?error=0.1&share=0.5",
        "?error=nan",
    ):
        assert (await client.get(address + wish)).status_code == 422, wish
    assert (await client.get("/api/characters/nobody/levels")).status_code == 404
