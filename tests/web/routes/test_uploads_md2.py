"""MD2 files over REST: uploaded through the child process, made a machine, played; refused with the byte."""

from collections.abc import AsyncIterator
from pathlib import Path

import httpx
import pytest
from md2_models import HOSTILE_MD2, md2
from uploads import BINARY, make, names, opened, put

pytestmark = pytest.mark.anyio


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


async def put_with(client: httpx.AsyncClient, query: str) -> httpx.Response:
    return await client.put(f"/api/characters/tetra?{query}", content=md2(), headers=BINARY)


async def weights(client: httpx.AsyncClient, machine: str, ticks: int) -> list[float]:
    """The morph weights of an actor of the machine after some ticks."""
    stage = {"clock": "manual", "actors": [{"machine": machine}]}
    url = (await client.post("/api/stages", json=stage)).headers["Location"]
    await client.post(f"{url}/step", json={"ticks": ticks})
    shown: list[float] = (await client.get(f"{url}/actors/1/pose")).json()["weights"]
    return shown


async def test_an_md2_becomes_a_machine_that_plays(client: httpx.AsyncClient) -> None:
    taken = await put(client, "tetra", md2())
    assert taken.status_code == 201, taken.text
    facts = taken.json()
    assert (facts["joints"], facts["clips"], facts["vertices"], facts["notes"]) == (1, 3, 7, [])
    mapping = (await client.get("/api/characters/tetra/mapping")).json()["mapping"]
    assert mapping == {"stand": "STAT", "pain1": "PAIN1", "jump": "JUMP"}
    made = await make(client, "md2", character="tetra", mapping=mapping)
    assert made.status_code == 201, made.text
    assert await weights(client, "md2", 9) == pytest.approx([0.5, 0.5, 0, 0, 0, 0], abs=1e-6)


async def test_its_frames_are_switched_on_request(client: httpx.AsyncClient) -> None:
    assert (await put_with(client, "inbetween=switched&scale=2")).status_code == 201
    await make(client, "stiff", character="tetra")
    assert await weights(client, "stiff", 8) == [1, 0, 0, 0, 0, 0]
    assert await weights(client, "stiff", 10) == [0, 1, 0, 0, 0, 0]


@pytest.mark.parametrize("query", ["inbetween=cubic", "low_pass=6", "spikes=true", "position=add", "scale=0"])
async def test_other_wishes_are_refused(client: httpx.AsyncClient, query: str) -> None:
    answer = await put_with(client, query)
    assert answer.status_code == 422, answer.text
    assert "tetra" not in await names(client, "characters")


@pytest.mark.parametrize("what", ["a thousand million frames", "cut in half", "a scale that is no number"])
async def test_a_broken_file_is_refused_with_the_byte(client: httpx.AsyncClient, what: str) -> None:
    answer = await put(client, "bad", HOSTILE_MD2[what][0])
    assert answer.status_code == 422, answer.text
    assert "byte" in answer.text
