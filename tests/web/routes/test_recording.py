"""recording.glb: what a stage did, as one animated file."""

import khronos
import numpy as np
import pytest
from statwalk.files.gltf import read_model

pytestmark = pytest.mark.anyio


@pytest.fixture
async def walked(client):
    """The path of a stage on which a walker went for 40 ticks."""
    stage = (
        await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}]})
    ).headers["Location"]
    await client.post(f"{stage}/events", json={"event": "FORWARD"})
    await client.post(f"{stage}/step", json={"ticks": 40})
    yield stage
    await client.delete(stage)


def positions(data, seconds=None):
    shown = read_model(data, "shown")
    pose = shown.bind_pose if seconds is None else shown.clips["recording"].sample(seconds)
    return np.concatenate([part.positions for part in shown.vertices(pose)])


@pytest.mark.parametrize("tick", [10, 23, 40])
async def test_its_ticks_are_those_of_the_frames(client, walked, tick):
    recording = (await client.get(f"{walked}/recording.glb", params={"from": 10, "to": 40})).content
    frame = (await client.get(f"{walked}/frame.glb", params={"tick": tick})).content
    assert positions(recording, (tick - 10) / 60) == pytest.approx(positions(frame), abs=1e-3)


async def test_without_a_tick_it_is_the_playheads(client, walked):
    await client.post(f"{walked}/seek", json={"tick": 10})
    shown = (await client.get(f"{walked}/frame.glb")).content
    recording = (await client.get(f"{walked}/recording.glb", params={"from": 5})).content
    assert shown == (await client.get(f"{walked}/frame.glb", params={"tick": 10})).content
    assert recording == (await client.get(f"{walked}/recording.glb", params={"from": 5, "to": 10})).content


async def test_it_is_valid(client, walked):
    answer = await client.get(f"{walked}/recording.glb")
    assert (answer.status_code, answer.headers["content-type"]) == (200, "model/gltf-binary")
    assert khronos.errors(answer.content) == []


async def test_with_a_framing_a_camera_follows(client, walked):
    answer = await client.get(f"{walked}/recording.glb", params={"framing": "upper body", "actor": 1})
    assert khronos.errors(answer.content) == []
    shown = read_model(answer.content, "shown")
    camera, root = (shown.skeleton.names.index(name) for name in ("camera", "Root"))
    first, last = (shown.world(shown.clips["recording"].sample(time)) for time in (0, 40 / 60))
    way = (last - first)[[camera, root], 2, 3]
    assert 0.1 < way[0] < way[1]
    assert first[camera, 2, 3] > 1


@pytest.mark.parametrize(
    ("params", "status"),
    [({"framing": "feet"}, 422), ({"framing": "face", "actor": 7}, 422), ({"actor": "x"}, 422)],
)
async def test_a_camera_that_cannot_be_is_refused(client, walked, params, status):
    answer = await client.get(f"{walked}/recording.glb", params=params)
    assert (answer.status_code, answer.headers["content-type"]) == (status, "application/problem+json")


async def test_a_camera_without_an_actor_is_refused(client):
    empty = (await client.post("/api/stages", json={"clock": "manual"})).headers["location"]
    answer = await client.get(f"{empty}/recording.glb", params={"framing": "face"})
    assert (answer.status_code, "there is none" in answer.json()["detail"]) == (409, True)


async def test_an_actor_that_came_later_is_in_it(client, walked):
    await client.post(
        f"{walked}/actors", json={"machine": "faq-walker", "position": [2, 0, 0], "name": "late"}
    )
    await client.post(f"{walked}/step", json={"ticks": 10})
    answer = await client.get(f"{walked}/recording.glb", params={"from": 30, "to": 50})
    assert "late" in read_model(answer.content, "shown").skeleton.names
    assert khronos.errors(answer.content) == []


@pytest.mark.parametrize(
    "params", [{"from": 5, "to": 2}, {"from": 0, "to": 41}, {"from": 0, "to": 1_000_000}]
)
async def test_ticks_that_are_not_there_are_refused(client, walked, params):
    answer = await client.get(f"{walked}/recording.glb", params=params)
    assert (answer.status_code, answer.headers["content-type"]) == (409, "application/problem+json")


@pytest.mark.parametrize("value", ["-1", "x", "1e9", "9" * 30])
async def test_ticks_that_are_no_ticks_are_refused(client, walked, value):
    assert (await client.get(f"{walked}/recording.glb", params={"from": value})).status_code == 422
