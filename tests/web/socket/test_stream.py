"""The stream over a real socket: hello, one frame a tick, credits, facts in order, the past for one viewer
alone.
"""

import json
from collections.abc import Iterator

import httpx
import khronos
import numpy as np
import pytest
from serving import open_and_never_read, serving, wait_for
from statwalk.services.publish import outbox
from statwalk.web import server
from statwalk.web.app import create_app
from statwalk.web.socket import protocol
from watcher import Watcher
from websockets.exceptions import ConnectionClosed

MAIN = "/api/stages/main"
FOR_EVER = 3_600.0


def test_the_hello_describes_the_frames(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        frame = viewer.frame()
        cast, said = frame.casts[0], viewer.hello["casts"][0]
    assert frame.epoch == viewer.hello["epoch"]
    assert cast.translation.shape == (len(said["actors"]), said["joints"], 3)
    assert cast.weights.shape[1] == said["weights"]
    assert len(said["names"]) == len(said["nodes"]) == len(said["parents"]) == said["joints"]
    assert said["states"][cast.state[0, 0]] == "STAT"


def test_frames_come_at_the_pace_of_the_stage(address: str) -> None:
    with Watcher(address, MAIN) as viewer:
        assert viewer.keeps_up()


def test_one_frame_for_each_step(address: str, stage: str, rest: httpx.Client) -> None:
    with Watcher(address, stage) as viewer:
        assert viewer.frame().tick == 0
        for tick in range(1, 6):
            rest.post(f"{stage}/step", json={"ticks": 1})
            assert viewer.frame().tick == tick


def test_the_frame_is_the_pose_that_rest_tells(address: str, stage: str, rest: httpx.Client) -> None:
    with Watcher(address, stage) as viewer:
        rest.post(f"{stage}/events", json={"event": "FORWARD"})
        rest.post(f"{stage}/step", json={"ticks": 9})
        frame = viewer.frame_at(9)
        actor = viewer.hello["casts"][0]["actors"][0]["id"]
        told = rest.get(f"{stage}/actors/{actor}/pose").json()
        seen = rest.get(stage).json()
    assert np.array_equal(frame.casts[0].rotation[0], np.array(told["rotation"], np.float32))
    assert np.array_equal(frame.casts[0].translation[0], np.array(told["translation"], np.float32))
    assert f"{frame.hash:016x}" == seen["hash"]


def test_no_more_than_three_frames_without_acknowledgement(
    address: str, stage: str, rest: httpx.Client
) -> None:
    """Three are sent; after an acknowledgement comes the newest, not the fourth."""
    with Watcher(address, stage, acknowledge=False) as viewer:
        assert viewer.frame().tick == 0
        for tick in (1, 2):
            rest.post(f"{stage}/step", json={"ticks": 1})
            assert viewer.frame().tick == tick
        rest.post(f"{stage}/step", json={"ticks": 10})
        viewer.say(type="ping")
        assert viewer.receive() == viewer.texts[-1]
        viewer.say(type="ack", tick=2)
        assert viewer.frame().tick == 12


def test_a_viewer_that_never_acknowledges_is_cut_off(address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(outbox, "ACKNOWLEDGE_SECONDS", 0.1)
    with Watcher(address, MAIN, acknowledge=False) as viewer:
        with pytest.raises(ConnectionClosed) as closed:
            viewer.text("nothing")
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 4008


def test_verdicts_come_once_each_in_order(address: str, stage: str, rest: httpx.Client) -> None:
    with Watcher(address, stage) as viewer:
        for event in ("FORWARD", "STOP", "JUMP"):
            rest.post(f"{stage}/events", json={"event": event})
            rest.post(f"{stage}/step", json={"ticks": 5})
        viewer.frame_at(15)
    told = [(text["tick"], text["event"]) for text in viewer.texts if text["type"] == "verdict"]
    assert told == sorted(set(told))
    assert {event for _, event in told} >= {"FORWARD", "STOP", "JUMP"}


def test_looking_back_moves_only_the_one_who_looks(address: str, stage: str, rest: httpx.Client) -> None:
    with Watcher(address, stage) as one, Watcher(address, stage) as other:
        rest.post(f"{stage}/events", json={"event": "FORWARD"})
        rest.post(f"{stage}/step", json={"ticks": 30})
        now = other.frame_at(30)
        one.frame_at(30)
        one.say(type="look", tick=10)
        past = one.frame()
        rest.post(f"{stage}/step", json={"ticks": 1})
        assert other.frame().tick == 31
        one.say(type="live")
        assert one.frame().tick == 31
    assert (past.tick, past.head) == (10, 30)
    assert past.hash != now.hash


def test_an_event_for_a_tick_of_the_past_forks_there(address: str, stage: str, rest: httpx.Client) -> None:
    rest.post(f"{stage}/step", json={"ticks": 20})
    with Watcher(address, stage) as viewer:
        viewer.say(type="event", event="FORWARD", kind="press", tick=5, ref="then")
        assert viewer.text("accepted")["tick"] == 5
        branch = viewer.text("forked")["stage"]
    assert rest.get(f"/api/stages/{branch}").json()["head"] == 5


def test_an_event_in_the_past_forks(address: str, stage: str, rest: httpx.Client) -> None:
    with Watcher(address, stage) as viewer:
        rest.post(f"{stage}/step", json={"ticks": 30})
        viewer.say(type="look", tick=10)
        viewer.frame_at(10)
        viewer.say(type="event", event="FORWARD", ref=7)
        accepted, forked = viewer.text("accepted"), viewer.text("forked")
    branch = rest.get(f"/api/stages/{forked['stage']}").json()
    assert (accepted["ref"], accepted["stage"], accepted["tick"]) == (7, forked["stage"], 10)
    assert branch["head"] == 10
    assert rest.get(stage).json()["head"] == 30


def test_an_event_counts_now_while_its_viewer_looks_at_the_past(
    address: str, stage: str, rest: httpx.Client
) -> None:
    with Watcher(address, stage) as viewer:
        rest.post(f"{stage}/step", json={"ticks": 30})
        viewer.say(type="look", tick=10)
        viewer.frame_at(10)
        viewer.say(type="event", event="FORWARD", now=True)
        assert viewer.text("accepted")["tick"] == 30
    assert "FORWARD" in rest.get(stage).json()["newest_input"]["text"]


def test_actors_that_come_and_go_are_announced(address: str, stage: str, rest: httpx.Client) -> None:
    with Watcher(address, stage) as viewer:
        viewer.frame()
        added = rest.post(
            f"{stage}/actors", json={"machine": "faq-walker", "name": "second", "position": [1, 0, 0]}
        ).json()
        hello = viewer.text("hello")
        frame = viewer.frame()
        rest.delete(f"{stage}/actors/{added['id']}")
        assert len(viewer.text("hello")["casts"][0]["actors"]) == 1
    assert hello["casts"][0]["actors"][1] == {"id": added["id"], "name": "second"}
    assert frame.epoch == hello["epoch"] > viewer.hello["epoch"]
    assert frame.casts[0].root[1, 0] == 1


def test_what_a_viewer_holds_is_released_when_it_leaves(address: str, stage: str, rest: httpx.Client) -> None:
    with Watcher(address, stage) as viewer:
        viewer.say(type="event", event="LEFT", kind="hold")
        viewer.text("accepted")
        rest.post(f"{stage}/step", json={"ticks": 1})
    wait_for(lambda: '"release"' in rest.get(f"{stage}/log").text)


def test_deleting_a_stage_sends_its_viewers_away(address: str, rest: httpx.Client) -> None:
    stage = rest.post("/api/stages", json={"clock": "manual"}).headers["Location"]
    with Watcher(address, stage) as viewer:
        rest.delete(stage)
        with pytest.raises(ConnectionClosed) as closed:
            viewer.text("nothing")
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 4404


@pytest.fixture
def patient(monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """A server that cuts no stalled viewer off."""
    for module, name in (
        (outbox, "ACKNOWLEDGE_SECONDS"),
        (protocol, "UNWRITABLE_SECONDS"),
        (server, "PONG_SECONDS"),
    ):
        monkeypatch.setattr(module, name, FOR_EVER)
    with serving(create_app()) as address:
        yield address


def test_a_stalled_viewer_harms_nobody(patient: str) -> None:
    """One never reads its GLB frames, and stays; another still gets its frames at the pace of the stage."""
    stalled = open_and_never_read(patient, f"{MAIN}/stream?frames=glb")
    with Watcher(patient, MAIN) as viewer:
        assert viewer.keeps_up()
        assert httpx.get(f"http://{patient}{MAIN}", timeout=30).json()["viewers"] == 2
    stalled.close()


def test_every_glb_frame_is_a_valid_model(address: str, stage: str, rest: httpx.Client) -> None:
    frames = [rest.get(f"{stage}/frame.glb").content]
    with Watcher(address, stage, frames="glb") as viewer:
        for _ in range(3):
            rest.post(f"{stage}/step", json={"ticks": 7})
            frames.append(viewer.data())
        viewer.say(type="look", tick=3)
        frames.append(viewer.data())
    assert khronos.errors(*frames) == []


def test_the_kind_of_frame_can_be_changed(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        assert viewer.data()[:4] == b"STW1"
        viewer.say(type="frames", frames="glb")
        assert viewer.text("hello")["frames"] == "glb"
        assert viewer.data()[:4] == b"glTF"


def test_a_viewer_chooses_how_the_server_skins(address: str, stage: str, rest: httpx.Client) -> None:
    with Watcher(address, stage, frames="glb") as viewer:
        own = viewer.data()
        assert viewer.hello["skinning"] is None
        assert viewer.hello["casts"][0]["skinning"] == "linear"
        viewer.say(type="frames", frames="glb", skinning="parts")
        assert viewer.text("hello")["skinning"] == "parts"
        pieces = viewer.data()
    assert len(pieces) > len(own)
    assert len(rest.get(f"{stage}/frame.glb?skinning=parts").content) > len(
        rest.get(f"{stage}/frame.glb").content
    )


def test_targets_over_rest_and_socket_are_logged_and_replayed(
    address: str, stage: str, rest: httpx.Client
) -> None:
    def logged() -> list[tuple[int, float]]:
        lines = map(json.loads, rest.get(f"{stage}/log").text.splitlines())
        return [(line["tick"], line["value"]) for line in lines if line.get("parameter") == "gaze.x"]

    rest.post(f"{stage}/parameters", json={"parameter": "look", "value": 1})
    rest.post(f"{stage}/parameters", json={"parameter": "gaze", "value": [0.5, 1.4, 2]})
    rest.post(f"{stage}/step", json={"ticks": 90})
    (actor,) = rest.get(stage).json()["actors"]
    with Watcher(address, stage) as viewer:
        viewer.say(type="set", parameter="gaze", value=[-0.5, 1.5, 2])
        wait_for(lambda: len(logged()) == 2)
    assert logged() == [(1, 0.5), (91, -0.5)]
    rest.post(f"{stage}/step", json={"ticks": 90})
    seen = rest.get(stage).json()
    assert [found["reached"] for found in (actor["reached"][0], seen["actors"][0]["reached"][0])] == [
        True
    ] * 2
    rest.post(f"{stage}/seek", json={"tick": 40})
    assert rest.get(stage).json()["hash"] != seen["hash"]
    rest.post(f"{stage}/seek", json={"tick": 180})
    assert rest.get(stage).json()["hash"] == seen["hash"]
