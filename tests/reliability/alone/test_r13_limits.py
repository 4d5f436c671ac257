"""R-13: what is too much is refused, and those who ask for little do not notice."""

import json
import os
import socket
import struct
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import httpx
import pytest
from serving import open_and_never_read, serving, wait_for
from statwalk.services.cancel import CancelToken
from statwalk.services.limits import Limits
from statwalk.services.publish import outbox
from statwalk.web import server
from statwalk.web.app import create_app
from statwalk.web.rate_limits import Rate
from statwalk.web.settings import Settings
from statwalk.web.socket import protocol
from watcher import Watcher

MAIN = "/api/stages/main"


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


def masked(text: str) -> bytes:
    """A text frame as a client sends it."""
    data, mask = text.encode(), os.urandom(4)
    body = bytes(byte ^ mask[place % 4] for place, byte in enumerate(data))
    return struct.pack("!BB", 0x81, 0x80 | len(data)) + mask + body


@pytest.fixture
def impatient(monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """A server that soon notices who does not answer pings, and looks for nothing else."""
    monkeypatch.setattr(server, "PING_SECONDS", 0.1)
    monkeypatch.setattr(server, "PONG_SECONDS", 3.0)
    monkeypatch.setattr(protocol, "UNWRITABLE_SECONDS", 3_600.0)
    monkeypatch.setattr(outbox, "ACKNOWLEDGE_SECONDS", 3_600.0)
    with serving(create_app()) as address:
        yield address


def acknowledge_all(client: socket.socket, first: int, last: int) -> None:
    """Acknowledges ticks without having read their frames."""
    for tick in range(first, last):
        client.sendall(masked(json.dumps({"type": "ack", "tick": tick})))


def test_who_acknowledges_without_reading_is_cut_off(impatient: str) -> None:
    """The frames of one actor fill the buffers only after many seconds; a ping is answered or it is not."""
    with httpx.Client(base_url=f"http://{impatient}", timeout=60) as rest:
        lying = open_and_never_read(impatient, f"{MAIN}/stream")
        wait_for(lambda: rest.get(MAIN).json()["viewers"] == 1)
        acknowledged = rest.get(MAIN).json()["head"]

        def is_cut() -> bool:
            nonlocal acknowledged
            facts = rest.get(MAIN).json()
            try:
                acknowledge_all(lying, acknowledged, facts["head"])
            except OSError:
                return True
            acknowledged = facts["head"]
            return bool(facts["viewers"] == 0)

        wait_for(is_cut)
        lying.close()


def test_who_reads_is_not_cut_off(impatient: str) -> None:
    with Watcher(impatient, MAIN) as viewer:
        first = viewer.frame().tick
        assert viewer.frame_from(first + 240)


LONG = {"clock": "manual", "actors": [{"machine": "faq-walker"}] * 20}
MOST_TICKS = 36_000


@pytest.fixture
def busy() -> Iterator[str]:
    """A server whose long requests have two seconds."""
    with serving(create_app(Settings(limits=Limits(work_seconds=2.0)))) as address:
        yield address


def test_a_long_step_has_a_deadline_and_says_what_to_do(busy: str) -> None:
    with httpx.Client(base_url=f"http://{busy}", timeout=60) as rest:
        stage = rest.post("/api/stages", json=LONG | {"actors": LONG["actors"] * 20}).headers["location"]
        answer = rest.post(f"{stage}/step", json={"ticks": MOST_TICKS})
        assert rest.get(stage).json()["tick"] > 0
    assert answer.status_code == 503
    assert "longer than 2 s" in answer.json()["detail"]
    assert "fewer ticks" in answer.json()["detail"]


OVERDUE = {
    "step": ("POST", "{}/step", {}),
    "seek": ("POST", "{}/seek", {"tick": 0}),
    "recording": ("GET", "{}/recording.glb", None),
    "log": ("GET", "{}/log", None),
    "fork": ("POST", "{}/fork", {"tick": 1}),
    "differences": ("GET", "{0}/differences?with={1}", None),
    "why not": ("GET", "{}/actors/1/whynot?event=JUMP&tick=1", None),
    "verify": ("GET", "/api/machines/faq-walker/verify", None),
    "measure": ("GET", "/api/machines/faq-walker/measure", None),
}


@pytest.mark.anyio
@pytest.mark.parametrize(("method", "path", "body"), OVERDUE.values(), ids=OVERDUE)
async def test_all_long_work_looks_at_its_deadline(
    method: str, path: str, body: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    app = create_app(Settings(main_stage=False))
    transport = httpx.ASGITransport(app)
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost", timeout=60) as client:
        stage = (await client.post("/api/stages", json=LONG)).headers["location"]
        await client.post(f"{stage}/step", json={"ticks": 2})
        monkeypatch.setattr(CancelToken, "expire_after", lambda token, _: setattr(token, "_deadline", 0.0))
        answer = await client.request(method, path.format(stage, stage.rpartition("/")[2]), json=body)
    assert (answer.status_code, "and was stopped" in answer.json()["detail"]) == (503, True)


@pytest.mark.anyio
async def test_a_server_that_does_not_look_at_its_limits_is_found_out(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The control: the limits are the same, and nothing counts or looks at the time."""
    monkeypatch.setattr(Rate, "spend", lambda *_: None)
    monkeypatch.setattr(CancelToken, "expire_after", lambda *_: None)
    app = create_app(Settings(limits=Limits(requests=0.5, work_seconds=0.0)))
    transport = httpx.ASGITransport(app, client=("192.0.2.1", 1))
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost", timeout=60) as client:
        statuses = {(await client.get("/api/machines")).status_code for _ in range(20)}
        verified = await client.get("/api/machines/faq-walker/verify")
    assert statuses | {verified.status_code} == {200}


def test_many_long_steps_at_once_leave_room_for_all_others(busy: str) -> None:
    """45 at once: two run, the others wait without a thread; short requests and a neighbour's steps go on."""
    with httpx.Client(base_url=f"http://{busy}", timeout=60) as rest, ThreadPoolExecutor(45) as steppers:
        long, other = (rest.post("/api/stages", json=LONG).headers["location"] for _ in range(2))
        with Watcher(busy, MAIN) as viewer:
            viewer.frame()
            url, body = f"http://{busy}{long}/step", {"ticks": MOST_TICKS}
            steps = [steppers.submit(httpx.post, url, json=body, timeout=60) for _ in range(45)]
            wait_for(lambda: rest.get(long).json()["tick"] > 0)
            assert rest.post(f"{other}/step", json={"ticks": 5}).json()["tick"] == 5
            for _ in range(10):
                viewer.say(type="event", event="FORWARD", ref=1)
                assert viewer.text("accepted")["stage"] == "main"
            assert rest.get("/healthz").status_code == 200
            rest.delete(long)
        statuses = [step.result().status_code for step in steps]
    assert 503 in statuses  # one more than may wait


def test_a_stage_that_takes_too_much_time_slows_down_and_says_so(busy: str) -> None:
    """Its status has the pace; the stage beside it keeps its own."""
    crowd = {"rate": 240, "actors": [{"machine": "faq-walker"}] * 1_500}
    with httpx.Client(base_url=f"http://{busy}", timeout=60) as rest:
        stage = rest.post("/api/stages", json=crowd).headers["location"]
        with Watcher(busy, stage) as viewer:
            wait_for(lambda: viewer.text("status")["pace"] < 1)
            assert rest.get(MAIN).json()["pace"] == 1
