"""Stages as a tree: where each was forked, what came since, and what people call it."""

import time
from typing import Any

import httpx
import pytest

pytestmark = pytest.mark.anyio
WALKER = {"clock": "manual", "actors": [{"machine": "faq-walker", "name": "Ann"}]}


@pytest.fixture
async def stage(client: httpx.AsyncClient) -> str:
    """A walker after ten ticks, sent forward in the first."""
    stage = (await client.post("/api/stages", json=WALKER)).headers["location"]
    await client.post(f"{stage}/events", json={"event": "FORWARD"})
    await client.post(f"{stage}/step", json={"ticks": 10})
    return str(stage)


async def listed(client: httpx.AsyncClient, stage: str) -> dict[str, Any]:
    """A stage as the list has it."""
    found = (await client.get("/api/stages")).json()
    return next(each for each in found if stage.endswith(each["id"]))


async def forked(client: httpx.AsyncClient, stage: str, **body: Any) -> str:
    return str((await client.post(f"{stage}/fork", json=body)).raise_for_status().headers["location"])


async def test_a_stage_that_is_no_fork(client: httpx.AsyncClient, stage: str) -> None:
    found = await listed(client, stage)
    assert (found["origin"], found["machines"], found["scene"]) == (None, ["faq-walker"], None)
    assert abs(found["made"] - time.time()) < 60
    assert (found["inputs"], found["newest_input"]["text"]) == (2, "FORWARD to Ann")  # with Ann herself


async def test_a_fork_says_where_it_began_and_what_came_since(client: httpx.AsyncClient, stage: str) -> None:
    fork = await forked(client, stage)
    before = await listed(client, fork)
    await client.post(f"{fork}/events", json={"event": "JUMP", "actor": 1})
    after = await listed(client, fork)
    origin = {"stage": stage.rpartition("/")[2], "tick": 10, "is_there": True}
    assert (before["origin"], before["inputs"], before["newest_input"]) == (origin, 0, None)
    assert (after["inputs"], after["newest_input"]) == (1, {"number": 3, "tick": 11, "text": "JUMP to Ann"})


async def test_a_fork_begins_at_any_tick_with_a_name(client: httpx.AsyncClient, stage: str) -> None:
    found = await listed(client, await forked(client, stage, tick=4, name=" Idea B "))
    assert (found["origin"]["tick"], found["head"], found["name"]) == (4, 4, "Idea B")


async def test_a_fork_at_a_tick_that_is_not_there_is_refused(client: httpx.AsyncClient, stage: str) -> None:
    refused = await client.post(f"{stage}/fork", json={"tick": 11})
    assert (refused.status_code, "0 … 10" in refused.json()["detail"]) == (409, True)


async def test_an_input_in_the_past_makes_a_fork_that_nobody_has_claimed(
    client: httpx.AsyncClient, stage: str
) -> None:
    await client.post(f"{stage}/seek", json={"tick": 6})
    fork = (await client.post(f"{stage}/events", json={"event": "JUMP"})).json()["stage"]
    before = await listed(client, fork)
    await client.get(f"/api/stages/{fork}")
    assert (before["origin"]["tick"], before["inputs"], before["unclaimed"]) == (6, 1, True)
    assert (await listed(client, fork))["unclaimed"] is False


async def test_a_fork_outlives_the_stage_that_it_left(client: httpx.AsyncClient, stage: str) -> None:
    fork = await forked(client, stage)
    assert (await client.delete(stage)).status_code == 204
    assert (await client.get(fork)).json()["origin"]["is_there"] is False
    assert (await client.post(f"{fork}/seek", json={"tick": 3})).json()["tick"] == 3


async def test_a_fork_has_the_scene_of_its_origin(client: httpx.AsyncClient) -> None:
    stage = (await client.post("/api/stages", json={"scene": "playground", "clock": "manual"})).headers[
        "location"
    ]
    assert (await listed(client, await forked(client, stage)))["scene"] == "playground"


async def test_a_stage_gets_a_name_and_loses_it(client: httpx.AsyncClient, stage: str) -> None:
    named = await client.patch(stage, json={"name": "  Jump <b>earlier</b> "})
    assert named.json()["name"] == (await listed(client, stage))["name"] == "Jump <b>earlier</b>"
    assert (await client.patch(stage, json={"name": ""})).json()["name"] == ""


async def test_a_stage_is_opened_with_a_name(client: httpx.AsyncClient) -> None:
    opened = await client.post("/api/stages", json={"clock": "manual", "name": "Idea"})
    assert (await client.get(opened.headers["location"])).json()["name"] == "Idea"


WRONG = {
    "81 letters": "x" * 81,
    "a line break": "a\nb",
    "a bell": "\x07",
    "backwards": "\u202eabc",
    "a C1 control": "\x85",
}


@pytest.mark.parametrize("name", WRONG.values(), ids=WRONG)
async def test_names_that_are_no_short_line_are_refused(
    client: httpx.AsyncClient, stage: str, name: str
) -> None:
    refused = await client.patch(stage, json={"name": name})
    assert (refused.status_code, refused.json()["errors"][0]["field"]) == (422, "name")


async def test_the_longest_name_counts_letters_not_bytes(client: httpx.AsyncClient, stage: str) -> None:
    name = "é" * 79 + "👩"
    assert (await client.patch(stage, json={"name": name})).json()["name"] == name


async def test_a_program_that_touches_the_clock_is_told(client: httpx.AsyncClient, stage: str) -> None:
    acts = {
        "paused": ("pause", {"paused": True}),
        "resumed": ("pause", {"paused": False}),
        "speed": ("speed", {"speed": 2}),
        "stepped": ("step", {"ticks": 1}),
        "moved": ("seek", {"tick": 2}),
    }
    for what, (path, body) in acts.items():
        changed = (await client.post(f"{stage}/{path}", json=body)).json()["changed"]
        assert (changed["what"], changed["by"], changed["viewer"]) == (what, "a program", None)
