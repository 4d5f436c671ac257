"""How far a fork is from the stage that it left, against poses that REST tells of both."""

import math

import httpx
import numpy as np
import pytest
from statwalk.services.hosting import actor_tracks, differences

pytestmark = pytest.mark.anyio
WALKER = {"clock": "manual", "actors": [{"machine": "faq-walker"}]}


@pytest.fixture
async def pair(client: httpx.AsyncClient) -> tuple[str, str]:
    """A stage with a walker, and a fork at tick 10 that was sent forward there; both are at tick 30."""
    stage = (await client.post("/api/stages", json=WALKER)).headers["location"]
    await client.post(f"{stage}/step", json={"ticks": 10})
    fork = (await client.post(f"{stage}/fork")).headers["location"]
    await client.post(f"{fork}/events", json={"event": "FORWARD"})
    for each in (stage, fork):
        await client.post(f"{each}/step", json={"ticks": 20})
    return stage, fork


async def compared(client: httpx.AsyncClient, stage: str, other: str, **query: object) -> httpx.Response:
    return await client.get(f"{stage}/differences", params={"with": other.rpartition("/")[2], **query})


async def pose(client: httpx.AsyncClient, stage: str, tick: int) -> dict[str, np.ndarray]:
    await client.post(f"{stage}/seek", json={"tick": tick})
    told = (await client.get(f"{stage}/actors/1/pose")).json()
    return {"places": np.array(told["world"])[:, :3, 3], "rotations": np.array(told["rotation"])}


async def test_each_joint_is_as_far_apart_as_the_poses_say(
    client: httpx.AsyncClient, pair: tuple[str, str]
) -> None:
    stage, fork = pair
    found = (await compared(client, fork, stage, detail="joints")).json()
    (actor,) = found["actors"]
    for tick in (9, 20, 30):
        one, other = await pose(client, fork, tick), await pose(client, stage, tick)
        row = actor["ticks"].index(tick)
        apart = np.linalg.norm(one["places"] - other["places"], axis=1)
        assert actor["by_tick"]["distance"][row] == pytest.approx(apart, abs=2e-6)
        cosine = np.abs(np.sum(one["rotations"] * other["rotations"], axis=1)).clip(0, 1)
        turned = [math.degrees(2 * math.acos(value)) for value in cosine]
        assert actor["by_tick"]["angle_deg"][row] == pytest.approx(turned, abs=0.06)
        assert actor["joints"][actor["distance_joint"][row]] == actor["joints"][int(np.argmax(apart))]


async def test_the_past_before_the_fork_is_exactly_the_same(
    client: httpx.AsyncClient, pair: tuple[str, str]
) -> None:
    found = (await compared(client, *pair)).json()
    (actor,) = found["actors"]
    assert (found["from"], found["to"], found["first_difference"]) == (0, 30, 11)
    assert set(actor["distance"][:11]) == set(actor["angle_deg"][:11]) == {0.0}
    assert actor["by_tick"] is None


async def test_the_summary_is_the_largest_of_the_details(
    client: httpx.AsyncClient, pair: tuple[str, str]
) -> None:
    (actor,) = (await compared(client, *pair, detail="joints")).json()["actors"]
    distance, angle = np.array(actor["by_tick"]["distance"]), np.array(actor["by_tick"]["angle_deg"])
    assert actor["distance"] == distance.max(1).tolist()
    assert actor["angle_deg"] == angle.max(1).tolist()
    assert actor["joint_distance"] == distance.max(0).tolist()
    assert actor["joint_angle_deg"] == angle.max(0).tolist()


async def test_actors_of_one_stage_alone_are_named(client: httpx.AsyncClient, pair: tuple[str, str]) -> None:
    stage, fork = pair
    await client.post(f"{fork}/actors", json={"machine": "elbow"})
    found = (await compared(client, fork, stage, **{"from": 30})).json()
    assert (found["only_here"], found["only_there"]) == ([2], [])
    assert [each["id"] for each in found["actors"]] == [1]


async def test_it_says_that_no_actor_is_on_both(client: httpx.AsyncClient, pair: tuple[str, str]) -> None:
    stage, fork = pair
    await client.delete(f"{fork}/actors/1")
    await client.post(f"{fork}/step", json={"ticks": 1})
    await client.post(f"{stage}/step", json={"ticks": 1})
    found = (await compared(client, fork, stage, **{"from": 31})).json()
    assert (found["actors"], found["only_there"]) == ([], [1])
    assert found["note"] == "no actor is on both stages in these ticks"


async def test_it_says_that_two_skeletons_have_no_joint_in_common(client: httpx.AsyncClient) -> None:
    stages = []
    for machine in ("elbow", "anchor-chain"):
        opened = await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": machine}]})
        stages.append(opened.headers["location"])
    found = (await compared(client, *stages)).json()
    assert (found["actors"], "no joint of the same name" in found["note"]) == ([], True)


async def test_a_span_that_one_stage_has_not_is_refused(
    client: httpx.AsyncClient, pair: tuple[str, str]
) -> None:
    refused = await compared(client, *pair, to=31)
    assert (refused.status_code, "0 … 30" in refused.json()["detail"]) == (409, True)


async def test_too_long_a_span_and_too_many_details_are_refused(
    client: httpx.AsyncClient, pair: tuple[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(differences, "MOST_DETAILED", 100)
    assert "for the summary" in (await compared(client, *pair, detail="joints")).json()["detail"]
    monkeypatch.setattr(actor_tracks, "MOST_JOINT_POSES", 100)
    refused = await compared(client, *pair)
    assert (refused.status_code, "100 joint poses" in refused.json()["detail"]) == (409, True)
    monkeypatch.setattr(actor_tracks, "MOST_TICKS", 10)
    assert "10 ticks at most" in (await compared(client, *pair)).json()["detail"]


async def test_a_stage_that_is_not_there_is_named(client: httpx.AsyncClient, pair: tuple[str, str]) -> None:
    refused = await compared(client, pair[0], "nobody")
    assert refused.status_code == 422


async def test_two_spans_of_one_stage_are_compared_tick_by_tick(
    client: httpx.AsyncClient, pair: tuple[str, str]
) -> None:
    stage = pair[1]
    query = {"from": 12, "to": 20, "with_from": 21, "detail": "joints"}
    found = (await compared(client, stage, stage, **query)).json()
    (actor,) = found["actors"]
    assert (found["from"], found["to"], found["with_from"]) == (12, 20, 21)
    assert actor["ticks"] == list(range(12, 21))
    one, other = await pose(client, stage, 14), await pose(client, stage, 23)
    apart = np.linalg.norm(one["places"] - other["places"], axis=1)
    assert actor["by_tick"]["distance"][2] == pytest.approx(apart, abs=2e-6)


async def test_a_pose_is_the_same_in_model_space_wherever_the_actor_stands(client: httpx.AsyncClient) -> None:
    spot = {"position": [3, 0, -2], "heading_deg": 40}
    actors = [WALKER["actors"][0], WALKER["actors"][0] | spot]
    stages = []
    for actor in actors:
        opened = await client.post("/api/stages", json={"clock": "manual", "actors": [actor]})
        stages.append(opened.headers["location"])
        await client.post(f"{stages[-1]}/events", json={"event": "FORWARD"})
        await client.post(f"{stages[-1]}/step", json={"ticks": 40})
    (on_stage,) = (await compared(client, *stages)).json()["actors"]
    (within,) = (await compared(client, *stages, space="model")).json()["actors"]
    assert min(on_stage["joint_distance"]) > 1
    assert max(within["joint_distance"]) < 1e-4


async def test_a_second_span_without_a_first_is_refused(
    client: httpx.AsyncClient, pair: tuple[str, str]
) -> None:
    refused = await compared(client, *pair, with_from=3)
    assert (refused.status_code, "with_from needs from" in refused.json()["detail"]) == (422, True)


async def test_a_second_span_that_is_not_there_is_named(
    client: httpx.AsyncClient, pair: tuple[str, str]
) -> None:
    refused = await compared(client, *pair, **{"from": 3, "to": 12, "with_from": 25})
    assert refused.status_code == 409
    assert "from 3 to 12, and from 25 to 34" in refused.json()["detail"]
