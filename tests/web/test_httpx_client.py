"""The issue's way: an httpx client drives a stage with a manual clock, without a socket, and compares poses
as numbers.
"""

import json
import math
import sys
from typing import Any

import anyio
import httpx
import pytest

pytestmark = pytest.mark.anyio
WALKER = {"machine": "faq-walker"}

WAY_TO = {  # the events that lead from STAT to each state; END waits for the motion's end
    "STAT": [],
    "STWK": ["FORWARD"],
    "WALK": ["FORWARD", "END"],
    "CSTP": ["FORWARD", "STOP"],
    "TLFT": ["LEFT"],
    "TRGT": ["RIGHT"],
    "JUMP": ["FORWARD", "END", "JUMP"],
    "FLY": ["FORWARD", "END", "JUMP", "END"],
    "LAND": ["FORWARD", "END", "JUMP", "END", "END"],
    "CRCH": ["CROUCH"],
    "STUP": ["CROUCH", "END"],
}
EVENTS = ("FORWARD", "LEFT", "RIGHT", "STOP", "JUMP", "CROUCH", "END")
TABLE = """
STAT | STWK        | TLFT         | TRGT         | STAT | -    | CRCH        |
STWK | STWK        |              |              | CSTP |      |             | WALK
WALK | WALK        | TLFT         | TRGT         | CSTP | JUMP |             |
CSTP |             |              |              | CSTP |      |             | STAT
TLFT | WALK at end | TLFT! at end | TRGT         | CSTP |      |             | STAT
TRGT | WALK at end | TLFT         | TRGT! at end | CSTP |      |             | STAT
JUMP |             |              |              |      |      |             | FLY
FLY  |             |              |              |      |      |             | LAND
LAND |             |              |              |      |      |             | CRCH
CRCH |             |              |              |      |      | CRCH at end | STUP
STUP |             |              |              |      |      |             | STAT
"""  # the corrected table of spec/machine.md
ROWS = {
    line.split("|")[0].strip(): [cell.strip() for cell in line.split("|")[1:]]
    for line in TABLE.strip().splitlines()
}
CELLS = [(state, event, cell) for state, row in ROWS.items() for event, cell in zip(EVENTS, row, strict=True)]


class Walk:
    """One walker on a stage of its own."""

    def __init__(self, client: httpx.AsyncClient, path: str, durations: dict[str, float]) -> None:
        self.client, self.path, self.durations = client, path, durations

    @classmethod
    async def begin(cls, client: httpx.AsyncClient, **stage: Any) -> "Walk":
        opened = await client.post("/api/stages", json={"clock": "manual", "actors": [WALKER]} | stage)
        assert opened.status_code == 201, opened.text
        machine = (await client.get("/api/machines/faq-walker")).json()
        return cls(
            client,
            opened.headers["Location"],
            {state["name"]: state["duration"] for state in machine["states"]},
        )

    async def post(self, what: str, **body: Any) -> Any:
        answer = await self.client.post(f"{self.path}/{what}", json=body)
        assert answer.is_success, answer.text
        return answer.json()

    async def step(self, ticks: int = 1) -> str:
        """The state of the first actor after so many ticks."""
        return str((await self.post("step", ticks=ticks))["actors"][0]["state"])

    async def ticks_to_end(self) -> int:
        """Ticks until the motion that runs now has come to its end."""
        actor = (await self.client.get(self.path)).json()["actors"][0]
        return math.ceil((self.durations[actor["state"]] - actor["time"]) * 60 - 1e-6)

    async def event(self, name: str) -> str:
        """Posts an event and takes one tick; for END, as many as the motion still has."""
        if name == "END":
            return await self.step(await self.ticks_to_end())
        await self.post("events", event=name)
        return await self.step()

    async def leave(self) -> None:
        await self.client.delete(self.path)


@pytest.mark.parametrize(
    ("state", "event", "cell"), CELLS, ids=[f"{state}/{event}" for state, event, _ in CELLS]
)
async def test_each_cell_of_the_corrected_table(
    client: httpx.AsyncClient, state: str, event: str, cell: str
) -> None:
    walk = await Walk.begin(client)
    for before in WAY_TO[state]:
        await walk.event(before)
    assert (await client.get(walk.path)).json()["actors"][0]["state"] == state
    target = cell.partition(" ")[0].strip("!-") or state
    if "at end" in cell:
        left = await walk.ticks_to_end()  # of the longest clip, where the motion is a blend
        await walk.post("events", event=event)
        states = [await walk.step() for _ in range(left)]
        assert states[0] == state
        assert states[-1] == target
        assert set(states) == {state, target}
    else:
        assert await walk.event(event) == target
    await walk.leave()


async def test_seek_back_and_forth_gives_the_same_hash(client: httpx.AsyncClient) -> None:
    walk = await Walk.begin(client)
    hashes = {}
    for tick, event in enumerate(("FORWARD", "LEFT", "STOP", "CROUCH") * 3):
        await walk.post("events", event=event)
        hashes[(tick + 1) * 17] = (await walk.post("step", ticks=17))["hash"]
    for tick in (17, 204, 51, 187, 17, 102):
        assert (await walk.post("seek", tick=tick))["hash"] == hashes[tick]
    assert len(set(hashes.values())) == len(hashes)
    await walk.leave()


async def test_the_log_replayed_in_a_new_process_gives_the_same_hash(client: httpx.AsyncClient) -> None:
    walk = await Walk.begin(client, seed=5)
    for event in ("FORWARD", "RIGHT", "JUMP"):
        await walk.post("events", event=event)
        stage = await walk.post("step", ticks=40)
    log = (await client.get(f"{walk.path}/log")).text
    program = (
        "import sys; from statwalk.services.library.load import load; from statwalk.stage.replay import "
        "replay;"
        "print(replay(sys.stdin.read().splitlines(), load).hash)"
    )
    again = await anyio.run_process([sys.executable, "-c", program], input=log.encode())
    assert again.stdout.decode().strip() == stage["hash"]
    await walk.leave()


async def test_an_actor_alone_and_among_a_thousand_has_the_same_pose(client: httpx.AsyncClient) -> None:
    alone = await Walk.begin(client)
    crowd = await Walk.begin(client, actors=[WALKER] * 1_000)
    poses = []
    for walk, at in ((alone, 0), (crowd, 499)):
        actor = (await client.get(walk.path)).json()["actors"][at]["id"]
        for event in ("FORWARD", "LEFT", "STOP"):
            await walk.post("events", event=event, actor=actor)
            await walk.post("step", ticks=11)
        pose = (await client.get(f"{walk.path}/actors/{actor}/pose")).json()
        one = (await client.get(f"{walk.path}/actors/{actor}")).json()
        poses.append((pose, one["hash"]))
        await walk.leave()
    assert poses[0] == poses[1]


async def test_an_event_before_the_head_goes_to_a_fork(client: httpx.AsyncClient) -> None:
    walk = await Walk.begin(client)
    await walk.step(60)
    await walk.post("seek", tick=20)
    accepted = await walk.post("events", event="FORWARD")
    branch = (await client.get(f"/api/stages/{accepted['stage']}")).json()
    assert accepted["stage"] not in walk.path
    assert (branch["tick"], branch["head"]) == (20, 20)
    assert (await client.get(walk.path)).json()["head"] == 60
    await walk.leave()


async def test_a_refused_event_before_the_head_leaves_no_fork(client: httpx.AsyncClient) -> None:
    walk = await Walk.begin(client)
    await walk.step(60)
    await walk.post("seek", tick=20)
    before = (await client.get("/api/stages")).json()
    assert (await client.post(f"{walk.path}/events", json={"event": "DANCE"})).status_code == 422
    assert (
        await client.post(f"{walk.path}/parameters", json={"parameter": "mood", "value": 1.0})
    ).status_code == 422
    assert [stage["id"] for stage in (await client.get("/api/stages")).json()] == [
        stage["id"] for stage in before
    ]
    await walk.leave()


async def test_hold_counts_until_it_is_released(client: httpx.AsyncClient) -> None:
    walk = await Walk.begin(client)
    await walk.post("events", event="LEFT", kind="hold")
    assert await walk.step(300) == "TLFT"
    await walk.post("events", event="LEFT", kind="release")
    assert await walk.step(300) == "STAT"
    await walk.leave()


@pytest.mark.parametrize(
    ("what", "body", "status", "known"),
    [
        ("events", {"event": "DANCE"}, 422, "FORWARD"),
        ("events", {"event": "END"}, 422, "FORWARD"),
        ("events", {"event": "FORWARD", "actor": 99}, 422, ""),
        ("parameters", {"parameter": "mood", "value": 1.0}, 422, ""),
        ("actors", {"machine": "nobody"}, 422, "faq-walker"),
        ("seek", {"tick": 1}, 409, ""),
    ],
)
async def test_what_does_not_exist_is_named(
    client: httpx.AsyncClient, what: str, body: Any, status: int, known: str
) -> None:
    walk = await Walk.begin(client)
    answer = await client.post(f"{walk.path}/{what}", json=body)
    assert answer.status_code == status
    assert answer.headers["content-type"] == "application/problem+json"
    assert known in json.dumps(answer.json().get("known", ""))
    await walk.leave()


@pytest.mark.parametrize(
    ("what", "body", "field"),
    [
        ("events", {}, "event"),
        ("events", {"event": 7}, "event"),
        ("events", {"event": "FORWARD", "kind": "push"}, "kind"),
        ("events", {"event": "FORWARD", "colour": "red"}, "colour"),
        ("step", {"ticks": "3"}, "ticks"),
        ("step", {"ticks": 2.5}, "ticks"),
        ("step", {"ticks": True}, "ticks"),
        ("step", {"ticks": 0}, "ticks"),
        ("step", {"ticks": 36_001}, "ticks"),
        ("speed", {"speed": 0}, "speed"),
        ("speed", {"speed": False}, "speed"),
        ("pause", {"paused": 1}, "paused"),
        ("seek", {"tick": -1}, "tick"),
        ("actors", {"machine": "faq-walker", "position": [0, 0]}, "position"),
        ("actors", {"machine": "faq-walker", "position": [0, 0, 1e7]}, "position.2"),
        ("actors", {"machine": "faq-walker", "name": ""}, "name"),
    ],
)
async def test_a_wrong_field_is_named(client: httpx.AsyncClient, what: str, body: Any, field: str) -> None:
    walk = await Walk.begin(client)
    answer = await client.post(f"{walk.path}/{what}", json=body)
    assert answer.status_code == 422
    assert [error["field"] for error in answer.json()["errors"]] == [field]
    await walk.leave()
