"""Who watches a stage, over a real socket: names, what they look at, cameras, and who paused."""

import json

import httpx
import pytest
from serving import wait_for
from statwalk.web.socket.presence_inbox import CAMERAS_PER_SECOND
from watcher import MOST_MESSAGES, Watcher

CAMERA = {"position": [0, 1.5, 3], "target": [0, 1, 0]}


def listed(viewer: Watcher, **wanted: object) -> dict[str, object]:
    """The next list in which a viewer has these members; returns that viewer."""
    for _ in range(MOST_MESSAGES):
        for each in viewer.text("viewers")["viewers"]:
            if wanted.items() <= each.items():
                return dict(each)
    raise AssertionError(wanted)


def test_a_viewer_is_told_its_number_and_then_who_is_there(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        told = viewer.text("viewers")["viewers"]
        assert [text["type"] for text in viewer.texts[:2]] == ["hello", "viewers"]
    (me,) = told
    assert me == {
        "id": viewer.hello["viewer"],
        "name": "",
        "person": "",
        "role": "admin",
        "actor": None,
        "tick": None,
        "follows": None,
    }


def test_the_others_see_what_a_viewer_says_and_rest_too(address: str, stage: str, rest: httpx.Client) -> None:
    rest.post(f"{stage}/step", json={"ticks": 9})
    with Watcher(address, stage) as one, Watcher(address, stage) as other:
        one.say(type="name", name=" Ada ")
        one.say(type="watch", actor=1)
        one.say(type="look", tick=4)
        seen = listed(other, name="Ada", actor=1, tick=4)
        assert seen in rest.get(f"{stage}/viewers").json()
        one.say(type="live")
        assert listed(other, name="Ada", tick=None)["id"] == one.hello["viewer"]
    wait_for(lambda: rest.get(f"{stage}/viewers").json() == [])


WRONG = {"41 letters": "x" * 41, "a line break": "a\nb", "an escape": "\x1b[2J", "backwards": "\u202eabc"}


@pytest.mark.parametrize("name", WRONG.values(), ids=WRONG)
def test_a_name_that_is_no_short_line_is_refused(address: str, stage: str, name: str) -> None:
    with Watcher(address, stage) as viewer:
        viewer.say(type="name", name=name)
        error = viewer.text("error")
    assert (error["status"], error["errors"][0]["field"]) == (422, "name.name")


@pytest.mark.parametrize("origin", [{}, {"actor": 1}], ids=["of the stage", "of an actor"])
def test_a_viewer_gets_the_camera_that_it_follows(address: str, stage: str, origin: dict[str, int]) -> None:
    with Watcher(address, stage) as shown, Watcher(address, stage) as follower:
        follower.say(type="follow", viewer=shown.hello["viewer"])
        assert listed(shown, follows=shown.hello["viewer"])["id"] == follower.hello["viewer"]
        shown.say(type="camera", **CAMERA, **origin)
        camera = follower.text("camera")
    assert camera == {"type": "camera", "viewer": shown.hello["viewer"], "actor": None, **CAMERA, **origin}


def test_nobody_follows_a_viewer_that_is_not_there(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        viewer.say(type="follow", viewer=999)
        assert viewer.text("error")["status"] == 422


def test_cameras_come_a_few_times_a_second(address: str, stage: str) -> None:
    with Watcher(address, stage) as viewer:
        for _ in range(3 * int(CAMERAS_PER_SECOND)):
            viewer.socket.send(json.dumps({"type": "camera", **CAMERA}))
        error = viewer.text("error")
        viewer.say(type="ping", ref=1)
        assert viewer.text("pong")["ref"] == 1  # the socket lives on
    assert (error["status"], "10 cameras a second" in error["detail"]) == (429, True)


@pytest.mark.parametrize("name", ["Ada", ""], ids=["with a name", "without one"])
def test_the_others_are_told_who_paused(address: str, stage: str, rest: httpx.Client, name: str) -> None:
    with Watcher(address, stage) as one, Watcher(address, stage) as other:
        one.say(type="name", name=name)
        one.say(type="ping", ref=1)
        one.text("pong")
        header = {"Statwalk-Viewer": str(one.hello["viewer"])}
        rest.post(f"{stage}/pause", json={"paused": True}, headers=header)
        while not (changed := other.text("status")["changed"]):
            pass
    told = {"what": "paused", "by": name or "somebody", "viewer": one.hello["viewer"], "tick": 0}
    assert changed == rest.get(stage).json()["changed"] == told


def test_one_page_watches_two_stages_at_the_same_tick(address: str, stage: str, rest: httpx.Client) -> None:
    """A ghost: a fork over its origin."""
    rest.post(f"{stage}/step", json={"ticks": 10})
    fork = rest.post(f"{stage}/fork").headers["location"]
    rest.post(f"{fork}/events", json={"event": "FORWARD"})
    for each in (stage, fork):
        rest.post(f"{each}/step", json={"ticks": 10})
    with Watcher(address, stage) as origin, Watcher(address, fork) as ghost:
        hashes = []
        for tick in (10, 15):
            for viewer in (origin, ghost):
                viewer.say(type="look", tick=tick)
            hashes.append([viewer.frame_at(tick).hash for viewer in (origin, ghost)])
    rest.delete(fork)
    assert [one == other for one, other in hashes] == [True, False]
