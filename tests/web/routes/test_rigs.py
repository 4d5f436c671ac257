"""Rigging over REST: a child process does it, the result is an uploaded character, refusals say why."""

from collections.abc import AsyncIterator
from pathlib import Path

import httpx
import pytest
from rig_shapes import cylinder, human, mesh
from statwalk.files.gltf import read_model
from uploads import make, opened, put

pytestmark = pytest.mark.anyio


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


async def rig(client: httpx.AsyncClient, name: str, **body: object) -> httpx.Response:
    return await client.post(f"/api/characters/{name}/rig", json=body)


async def test_a_mesh_becomes_a_character_that_a_machine_plays(client: httpx.AsyncClient) -> None:
    plain = await put(client, "figure", mesh(*human()).model_glb)
    assert plain.json()["skins"] == 0
    answer = await rig(client, "figure", skeleton="human")
    assert answer.status_code == 201, answer.text
    assert answer.headers["Location"] == "/api/characters/figure"
    assert (answer.json()["skins"], answer.json()["joints"]) == (1, 22)
    model = read_model((await client.get("/api/characters/figure/model.glb")).content, "figure")
    assert model.parts[0].skin == 0
    made = await make(client, "figure", character="figure", mapping={"Bend": "BEND"})
    assert made.status_code == 201, made.text
    bones = (await client.get("/api/characters/figure/bones")).json()
    assert set(bones["needed"]) <= bones["bones"].keys()


async def test_a_new_name_leaves_the_mesh_as_it_was(client: httpx.AsyncClient) -> None:
    await put(client, "post", mesh(*cylinder()).model_glb)
    answer = await rig(client, "post", character="bending-post", weights="nearest")
    assert answer.status_code == 201, answer.text
    assert answer.json()["name"] == "bending-post"
    assert (await client.get("/api/characters/post")).json()["clips"] == []


async def test_a_refusal_says_what_to_do(client: httpx.AsyncClient) -> None:
    await put(client, "post", mesh(*cylinder()).model_glb)
    answer = await rig(client, "post", skeleton="mammal")
    assert answer.status_code == 422
    assert "its legs must be apart" in answer.json()["detail"]
    assert (await rig(client, "post", skeleton="own")).status_code == 422
    assert (await rig(client, "post", skeleton="humn")).status_code == 422
    assert (await rig(client, "nobody", character="somebody")).status_code == 404


async def test_a_character_of_the_server_stays(client: httpx.AsyncClient) -> None:
    assert (await rig(client, "walker", skeleton="own")).status_code == 409
