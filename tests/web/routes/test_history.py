"""GET /api/stages/{id}/history: who was in which state, and since when."""

import httpx
import pytest

pytestmark = pytest.mark.anyio


def rows(changes):
    return [(change["tick"], change["actor"], change["layer"], change["state"]) for change in changes]


async def test_it_begins_with_the_state_an_actor_came_in(client: httpx.AsyncClient) -> None:
    stage = (await client.post("/api/stages", json={"clock": "manual"})).headers["Location"]
    await client.post(f"{stage}/step", json={"ticks": 7})
    await client.post(f"{stage}/actors", json={"machine": "faq-walker"})
    told = (await client.get(f"{stage}/history")).json()
    assert (told["head"], rows(told["changes"])) == (7, [(7, 1, 0, "STAT")])


async def test_each_change_stands_at_its_tick(client: httpx.AsyncClient) -> None:
    """Compared with the state that the API shows at every tick."""
    stage = (
        await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}]})
    ).headers["Location"]
    await client.post(f"{stage}/events", json={"event": "FORWARD"})
    seen = [(0, 1, 0, "STAT")]
    for tick in range(1, 121):
        state = (await client.post(f"{stage}/step", json={"ticks": 1})).json()["actors"][0]["state"]
        if state != seen[-1][3]:
            seen.append((tick, 1, 0, state))
    assert len(seen) > 2
    assert rows((await client.get(f"{stage}/history")).json()["changes"]) == seen


async def test_the_playhead_does_not_matter(client: httpx.AsyncClient) -> None:
    stage = (
        await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}]})
    ).headers["Location"]
    await client.post(f"{stage}/events", json={"event": "FORWARD"})
    await client.post(f"{stage}/step", json={"ticks": 40})
    before = (await client.get(f"{stage}/history")).json()
    await client.post(f"{stage}/seek", json={"tick": 3})
    assert (await client.get(f"{stage}/history")).json() == before


async def test_there_is_none_of_an_unknown_stage(client: httpx.AsyncClient) -> None:
    assert (await client.get("/api/stages/nowhere/history")).status_code == 404
