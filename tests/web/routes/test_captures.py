"""Captures over REST: uploaded through the child process, carried over, filtered, played; refused with the
place.
"""

import re
from collections.abc import AsyncIterator
from pathlib import Path

import captures
import httpx
import numpy as np
import pytest
from bone_places import places
from hostile_captures import HOSTILE_CAPTURES
from statwalk.files.bvh import read_bvh
from uploads import make, names, opened, put

pytestmark = pytest.mark.anyio
MARKERS = {
    **{"Hips": "Hips", "LeftUpLeg": "LHip", "RightUpLeg": "RHip", "LeftLeg": "LKNE", "RightLeg": "RKNE"},
    **{"LeftFoot": "LANK", "RightFoot": "RANK", "Neck": "Neck", "Head": "Head"},
}
"""of the joints of a walk"""


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


async def carried(client: httpx.AsyncClient, **body: object) -> httpx.Response:
    return await client.post(
        "/api/characters/walker/clips", json={"source": "walk", "character": "hero"} | body
    )


async def test_a_dropped_walk_plays_on_the_shipped_walker(client: httpx.AsyncClient) -> None:
    taken = await put(client, "walk", captures.walk().encode())
    assert (taken.status_code, taken.json()["joints"], taken.json()["clips"]) == (201, 23, 1)
    answer = await carried(client, loop=True, low_pass=8, spikes=True)
    assert answer.status_code == 201, answer.text
    assert answer.headers["Location"] == "/api/characters/hero"
    assert answer.json()["bones"]["LeftUpperLeg"] == {"source": "LeftUpLeg", "target": "Left.upperleg"}
    assert (answer.json()["clip"], answer.json()["root"], answer.json()["missing"]) == ("walk 2", "Root", [])
    clips = (await client.get("/api/characters/hero")).json()["clips"]
    assert clips[-1] == {"name": "walk 2", "duration": 1.0}
    made = await make(client, "hero", character="hero", mapping={"walk 2": "WALK"}, root="Root")
    assert made.status_code == 201, made.text
    stage = {"clock": "manual", "actors": [{"machine": "hero"}]}
    url = (await client.post("/api/stages", json=stage)).headers["Location"]
    await client.post(f"{url}/step", json={"ticks": 60})
    pose = (await client.get(f"{url}/actors/1/pose")).json()
    assert pose["root"]["position"][2] > 0.5


async def test_tracks_of_markers_play_on_the_shipped_walker(client: httpx.AsyncClient) -> None:
    seen = read_bvh(captures.walk().encode(), "walk")
    at = places(seen, seen.clips["walk"], np.arange(30) / 30)
    tracks = np.stack([at[joint] for joint in MARKERS], 1)
    taken = await put(client, "walk", captures.trc(list(MARKERS.values()), tracks).encode())
    assert taken.status_code == 201, taken.text
    answer = await carried(client)
    assert answer.status_code == 201, answer.text
    made = await make(client, "hero", character="hero", mapping={answer.json()["clip"]: "WALK"}, root="Root")
    assert made.status_code == 201, made.text
    stage = {"clock": "manual", "actors": [{"machine": "hero"}]}
    url = (await client.post("/api/stages", json=stage)).headers["Location"]
    await client.post(f"{url}/step", json={"ticks": 50})
    assert (await client.get(f"{url}/actors/1/pose")).json()["root"]["position"][2] > 0.5


async def test_an_uploaded_character_gets_the_clip_itself(client: httpx.AsyncClient) -> None:
    await put(client, "walk", captures.walk().encode())
    await put(client, "other", captures.walk().encode())
    answer = await client.post("/api/characters/other/clips", json={"source": "walk", "name": "stroll"})
    assert answer.status_code == 201, answer.text
    assert [clip["name"] for clip in (await client.get("/api/characters/other")).json()["clips"]] == [
        "other",
        "stroll",
    ]
    assert (await client.get("/api/characters/other/model.glb")).content.startswith(b"glTF")


async def test_bones_are_told_by_names(client: httpx.AsyncClient) -> None:
    answer = (await client.get("/api/characters/walker/bones")).json()
    assert answer["bones"]["LeftLowerLeg"] == "Left.lowerleg"
    assert set(answer["needed"]) <= set(answer["bones"]) <= set(answer["known"])


async def test_bones_that_no_name_tells_are_asked_for(client: httpx.AsyncClient) -> None:
    names = {"Hips": "a", "LeftUpLeg": "b", "RightUpLeg": "c"}
    await put(client, "walk", captures.walk(names).encode())
    refused = await carried(client)
    assert (refused.status_code, refused.json()["errors"][0]["field"]) == (422, "bones")
    chosen = {"Hips": "a", "LeftUpperLeg": "b", "RightUpperLeg": "c"}
    assert (await carried(client, bones=chosen)).status_code == 201
    assert (await carried(client, bones={"Tail": "a"})).status_code == 422
    assert (await carried(client, bones={"Hips": "nobody"})).status_code == 422


async def test_the_servers_own_characters_stay_as_they_are(client: httpx.AsyncClient) -> None:
    await put(client, "walk", captures.walk().encode())
    refused = await client.post("/api/characters/walker/clips", json={"source": "walk"})
    assert (refused.status_code, refused.json()["errors"][0]["field"]) == (409, "character")
    assert (await carried(client, character="walker")).status_code == 409
    assert (await carried(client, source="nobody")).status_code == 422
    assert (await carried(client, clip="nobody")).status_code == 422


async def test_uploads_of_captures_have_a_scale_and_a_filter(client: httpx.AsyncClient) -> None:
    query = "?position=add&scale=0.01&low_pass=6&spikes=true"
    answer = await client.put(
        f"/api/characters/walk{query}",
        content=captures.walk().encode(),
        headers={"content-type": "text/plain"},
    )
    assert answer.status_code == 201, answer.text
    for wrong in ("?position=left", "?scale=0", "?scale=nan", "?low_pass=-1", "?low_pass=1e9"):
        assert (await client.put(f"/api/characters/walk{wrong}", content=b"HIERARCHY")).status_code in (
            415,
            422,
        )
    assert (
        await client.put("/api/characters/x?scale=2", content=b"glTF", headers={"content-type": "text/plain"})
    ).status_code == 422


@pytest.mark.parametrize("what", HOSTILE_CAPTURES)
async def test_broken_captures_are_refused_with_the_line(client: httpx.AsyncClient, what: str) -> None:
    data, reason = HOSTILE_CAPTURES[what]
    refused = await put(client, "walk", data)
    assert refused.status_code == 422
    body = refused.json()
    assert re.search(r"\b(line|byte) [0-9]+", refused.text) or "a body needs" in body["detail"]
    assert reason in body["detail"]
    assert len(body["detail"]) < 1000
    assert "walk" not in await names(client, "characters")
