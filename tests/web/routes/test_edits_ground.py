"""Uneven ground put below machines over REST: a shipped one, and one made of a model that was dropped."""

from pathlib import Path
from typing import Any

import httpx
import pytest
from paths import MACHINES
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio
STEP = "\nground: [{from: [-2, -2], to: [2, 2], height: 0.3}]\n"


@pytest.fixture
def app(tmp_path: Path) -> Any:
    """Not shared: machines are changed here."""
    return create_app(Settings(main_stage=False, data=tmp_path))


async def raised(client: httpx.AsyncClient, machine: str, more: str) -> httpx.Response:
    """The answer to a machine's text with some more lines."""
    path = f"/api/machines/{machine}"
    before = (await client.get(path)).json()
    body = {"text": before["text"] + more}
    return await client.put(path, json=body, headers={"If-Match": f'"{before["version"]}"'})


async def standing(client: httpx.AsyncClient, machine: str) -> str:
    body = {"clock": "manual", "actors": [{"machine": machine}]}
    return str((await client.post("/api/stages", json=body)).headers["Location"])


async def height(client: httpx.AsyncClient, stage: str) -> float:
    shown = await client.post(f"{stage}/step", json={"ticks": 90})
    return float(shown.json()["actors"][0]["position"][1])


async def test_ground_lifts_an_actor_that_stands_on_it(client: httpx.AsyncClient) -> None:
    stage = await standing(client, "faq-walker")
    assert await height(client, stage) == 0
    changed = await raised(client, "faq-walker", STEP)
    assert changed.status_code == 200
    assert (await client.get("/api/machines/faq-walker")).json()["ground"] == [
        {"corner": [-2, -2], "opposite": [2, 2], "heights": [0.3, 0.3, 0.3, 0.3]}
    ]
    assert await height(client, stage) == pytest.approx(0.3, abs=1e-3)


async def test_ground_below_a_dropped_model(client: httpx.AsyncClient) -> None:
    model = (MACHINES / "faq-walker" / "walker.glb").read_bytes()
    kind = {"content-type": "model/gltf-binary"}
    assert (await client.put("/api/characters/mine", content=model, headers=kind)).status_code == 201
    made = await client.post("/api/machines", json={"name": "mine", "character": "mine"})
    assert made.status_code == 201
    assert (await raised(client, "mine", f"foot_lock: true{STEP}")).status_code == 200
    assert await height(client, await standing(client, "mine")) == pytest.approx(0.3, abs=1e-3)


async def test_ground_that_no_foot_finds_is_refused(client: httpx.AsyncClient) -> None:
    model = (MACHINES / "faq-walker" / "walker.glb").read_bytes()
    kind = {"content-type": "model/gltf-binary"}
    await client.put("/api/characters/mine", content=model, headers=kind)
    await client.post("/api/machines", json={"name": "mine", "character": "mine"})
    refused = await raised(client, "mine", STEP)
    assert refused.status_code == 422
    assert "write `foot_lock: true` as well" in refused.text


@pytest.mark.parametrize(
    "piece", ["{from: [0, 0], to: [0, 1], height: 1}", "{from: [0, 0], to: [1, 1]}", "3"]
)
async def test_bad_ground_is_refused(client: httpx.AsyncClient, piece: str) -> None:
    refused = await raised(client, "faq-walker", f"\nground: [{piece}]\n")
    assert refused.status_code == 422
    assert (await client.get("/api/machines/faq-walker")).json()["ground"] == []
