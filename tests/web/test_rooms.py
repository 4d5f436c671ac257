"""Characters, machines, actors and the description of it all over REST."""

import json
from typing import Any

import httpx
import pytest

pytestmark = pytest.mark.anyio


async def get(client: httpx.AsyncClient, path: str, status: int = 200) -> Any:
    answer = await client.get(path)
    assert answer.status_code == status, answer.text
    return answer.json()


async def test_the_shipped_machines_are_listed_the_default_first(client: httpx.AsyncClient) -> None:
    listed = await get(client, "/api/machines")
    assert listed[0]["name"] == "faq-walker"
    assert "faq-printed" in {machine["name"] for machine in listed}


async def test_a_machine_says_its_table(client: httpx.AsyncClient) -> None:
    machine = await get(client, "/api/machines/faq-walker")
    assert machine["events"] == ["FORWARD", "LEFT", "RIGHT", "STOP", "JUMP", "CROUCH", "END"]
    assert machine["table"]["STAT"]["FORWARD"]["to"] == "STWK"
    assert machine["table"]["STAT"]["JUMP"]["to"] is None
    assert machine["table"]["CRCH"]["CROUCH"]["when"] == "end"
    assert "END" not in machine["table"]["STAT"]
    assert {"from": "STWK", "to": "WALK", "events": ["END"]} in machine["edges"]
    assert machine["rows"][0][0] == "state"
    assert machine["keys"]["ArrowUp"]
    assert machine["text"].startswith("#") or "semantics" in machine["text"]


async def test_the_printed_table_is_found_wanting(client: httpx.AsyncClient) -> None:
    said = json.dumps((await get(client, "/api/machines/faq-printed/verify"))["findings"])
    assert all(name in said for name in ("TLFG", "TRGY", "JUMP", "FLY", "LAND", "CRCH", "STUP"))


async def test_a_character_has_joints_clips_and_a_model(client: httpx.AsyncClient) -> None:
    name = (await get(client, "/api/machines/faq-walker"))["character"]
    character = await get(client, f"/api/characters/{name}")
    model = await client.get(character["model"])
    assert model.headers["content-type"] == "model/gltf-binary"
    assert model.content[:4] == b"glTF"
    nodes = json.loads(model.content[20 : 20 + int.from_bytes(model.content[12:16], "little")])["nodes"]
    assert all(
        nodes[joint["node"]].get("name", joint["name"]) == joint["name"] for joint in character["joints"]
    )
    assert {"walk", "stand", "fly"} <= {clip["name"] for clip in character["clips"]}


@pytest.mark.parametrize(
    "path",
    ["/api/machines/x", "/api/machines/x/verify", "/api/characters/x", "/api/stages/x", "/api/stages/x/log"],
)
async def test_what_is_not_there_is_404_and_lists_what_is(client: httpx.AsyncClient, path: str) -> None:
    problem = await get(client, path, 404)
    assert problem["status"] == 404
    assert isinstance(problem["known"], list)


async def test_actors_come_and_go(client: httpx.AsyncClient) -> None:
    stage = (await client.post("/api/stages", json={"clock": "manual"})).headers["Location"]
    added = await client.post(
        f"{stage}/actors", json={"machine": "faq-walker", "position": [1, 0, 2], "heading_deg": 90}
    )
    assert added.status_code == 201
    actor = await get(client, added.headers["Location"])
    assert actor["position"] == [1, 0, 2]
    assert actor["heading_deg"] == pytest.approx(90)
    assert (await client.delete(added.headers["Location"])).status_code == 204
    assert await get(client, f"{stage}/actors") == []
    assert (await client.get(added.headers["Location"])).status_code == 404
    assert (await client.delete(stage)).status_code == 204
    assert (await client.get(stage)).status_code == 404


async def test_the_number_of_stages_is_bounded(client: httpx.AsyncClient) -> None:
    opened = []
    while (answer := await client.post("/api/stages", json={"clock": "manual"})).status_code == 201:
        opened.append(answer.headers["Location"])
    assert answer.status_code == 409
    assert len(opened) <= 64
    for stage in opened:
        await client.delete(stage)


async def test_the_description_has_every_route_and_its_errors(client: httpx.AsyncClient) -> None:
    description = await get(client, "/api/openapi.json")
    assert len(description["paths"]) >= 20
    for answer in description["components"]["responses"].values():
        assert "application/problem+json" in answer["content"]
    for path, operations in description["paths"].items():
        for operation in operations.values():
            assert operation["responses"]["421"]["$ref"] == "#/components/responses/421", path
            assert operation["summary"]


async def test_the_frame_of_a_tick_is_a_model(client: httpx.AsyncClient) -> None:
    opened = await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}]})
    stage = opened.headers["Location"]
    await client.post(f"{stage}/step", json={"ticks": 10})
    frames = [(await client.get(f"{stage}/frame.glb", params={"tick": tick})).content for tick in (0, 10)]
    assert all(frame[:4] == b"glTF" for frame in frames)
    assert frames[0] != frames[1]
    assert (await client.get(f"{stage}/frame.glb")).content == frames[1]
    assert (await get(client, stage))["tick"] == 10
    assert (await client.get(f"{stage}/frame.glb", params={"tick": 11})).status_code == 409
    await client.delete(stage)


@pytest.mark.parametrize(("path", "status"), [("/api/machines", 200), ("/api/nothing", 404)])
async def test_head_is_get_without_a_body(client: httpx.AsyncClient, path: str, status: int) -> None:
    answer = await client.head(path)
    assert (answer.status_code, answer.headers["content-type"]) == (
        status,
        (await client.get(path)).headers["content-type"],
    )
