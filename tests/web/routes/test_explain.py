"""Why, why not, and the way to a state, over REST; scenes."""

import httpx
import pytest

pytestmark = pytest.mark.anyio


async def stage_of(client: httpx.AsyncClient, **asked: object) -> str:
    made = await client.post("/api/stages", json={"clock": "manual"} | asked)
    return str(made.headers["Location"])


async def walker(client: httpx.AsyncClient) -> str:
    return await stage_of(client, actors=[{"machine": "faq-walker"}])


async def test_why_names_cell_blend_and_joints(client: httpx.AsyncClient) -> None:
    path = await walker(client)
    await client.post(f"{path}/events", json={"event": "LEFT"})
    await client.post(f"{path}/step", json={"ticks": 3})
    event = (await client.get(f"{path}/actors/1/why", params={"tick": 1})).json()["events"][0]
    assert (event["event"], event["verdict"], event["cell"], event["to_state"]) == (
        "LEFT",
        "taken",
        ["STAT", "LEFT"],
        "TLFT",
    )
    assert event["blend_seconds"] == pytest.approx(0.3)
    assert event["joints"][0]["degrees"] > 0


async def test_whynot_offers_a_change_that_works(client: httpx.AsyncClient) -> None:
    path = await walker(client)
    await client.post(f"{path}/events", json={"event": "JUMP"})
    await client.post(f"{path}/step", json={"ticks": 3})
    said = (await client.get(f"{path}/actors/1/whynot", params={"tick": 1, "event": "JUMP"})).json()
    assert said["fired"] is False
    assert {remedy["kind"] for remedy in said["remedies"]} >= {"cell", "state"}


async def test_travel_arrives(client: httpx.AsyncClient) -> None:
    path = await walker(client)
    plan = (await client.post(f"{path}/actors/1/travel", json={"state": "FLY"})).json()
    assert plan["steps"][-1] == {"state": "JUMP", "event": "END", "seconds": pytest.approx(0.55)}
    seen = [
        (await client.post(f"{path}/step", json={"ticks": 6})).json()["actors"][0]["state"] for _ in range(30)
    ]
    assert "FLY" in seen


async def test_who_is_sent_off_in_the_past_goes_in_a_fork(client: httpx.AsyncClient) -> None:
    path = await walker(client)
    await client.post(f"{path}/step", json={"ticks": 10})
    await client.post(f"{path}/seek", json={"tick": 3})
    plan = (await client.post(f"{path}/actors/1/travel", json={"state": "FLY"})).json()
    fork = f"/api/stages/{plan['stage']}"
    assert (fork != path, plan["tick"]) == (True, 3)
    seen = [
        (await client.post(f"{fork}/step", json={"ticks": 6})).json()["actors"][0]["state"] for _ in range(30)
    ]
    assert "FLY" in seen


async def test_travel_is_cancelled(client: httpx.AsyncClient) -> None:
    path = await walker(client)
    await client.post(f"{path}/actors/1/travel", json={"state": "FLY"})
    assert (await client.delete(f"{path}/actors/1/travel")).status_code == 204
    assert (await client.post(f"{path}/step", json={"ticks": 60})).json()["actors"][0]["state"] == "STAT"


@pytest.mark.parametrize(
    ("path", "status"),
    [
        ("actors/9/why?tick=0", 404),
        ("actors/1/why?tick=99", 409),
        ("actors/1/whynot?tick=1&event=HOP", 422),
        ("actors/1/whynot?tick=0&event=LEFT", 409),
        ("actors/1/why", 422),
    ],
)
async def test_what_cannot_be_asked(client: httpx.AsyncClient, path: str, status: int) -> None:
    stage = await walker(client)
    await client.post(f"{stage}/step", json={"ticks": 3})
    assert (await client.get(f"{stage}/{path}")).status_code == status


async def test_scenes_are_listed_and_open(client: httpx.AsyncClient) -> None:
    listed = {scene["name"]: scene["actors"] for scene in (await client.get("/api/scenes")).json()}
    path = await stage_of(client, scene="playground")
    assert len((await client.get(path)).json()["actors"]) == listed["playground"]


async def test_a_scene_that_is_not_there(client: httpx.AsyncClient) -> None:
    answer = await client.post("/api/stages", json={"scene": "../playground"})
    known = ["geese", "joints", "playground", "street", "swarm"]
    assert (answer.status_code, answer.json()["known"]) == (422, known)


async def test_the_same_scene_gives_the_same_flight(client: httpx.AsyncClient) -> None:
    hashes = []
    for _ in range(2):
        path = await stage_of(client, scene="geese")
        hashes.append((await client.post(f"{path}/step", json={"ticks": 30})).json()["hash"])
    assert hashes[0] == hashes[1]


async def test_what_a_flock_sets_is_said(client: httpx.AsyncClient) -> None:
    goose = (await client.get("/api/machines/geese.goose")).json()
    assert {one["name"]: one["driven"] for one in goose["parameters"]} == {"pace": True}
