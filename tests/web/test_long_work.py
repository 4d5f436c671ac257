"""Places for long requests: so many run, so many wait, and who has gone waits no more."""

import asyncio
import socket
from collections.abc import AsyncIterator
from typing import Any

import httpx
import pytest
from serving import PATIENCE, serving, wait_for
from statwalk.errors import CancelledError
from statwalk.services.library import measuring
from statwalk.web import long_work
from statwalk.web.app import create_app
from statwalk.web.errors import Problem
from statwalk.web.long_work import LongWork
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio


class Client:
    """A request that keeps its place until it is told to leave."""

    def __init__(self, work: LongWork, about: str = "") -> None:
        self.gone: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        self.has_place, self.may_leave = asyncio.Event(), asyncio.Event()
        self.task = asyncio.ensure_future(self._stay(work, about))

    async def _stay(self, work: LongWork, about: str) -> None:
        async with work.place(self.gone, about):
            self.has_place.set()
            await self.may_leave.wait()

    async def leave(self) -> None:
        self.may_leave.set()
        await self.task


async def settled() -> None:
    """All that can happen without a further event has happened."""
    for _ in range(20):
        await asyncio.sleep(0)


async def test_as_many_run_as_may_and_the_next_gets_the_first_free_place() -> None:
    work = LongWork(running=2, waiting=1)
    first, second, third = Client(work), Client(work), Client(work)
    await settled()
    assert [client.has_place.is_set() for client in (first, second, third)] == [True, True, False]
    await second.leave()
    await third.has_place.wait()
    await asyncio.gather(first.leave(), third.leave())


async def test_one_more_than_may_wait_is_refused() -> None:
    work = LongWork(running=1, waiting=1)
    running, waiting = Client(work), Client(work)
    await settled()
    with pytest.raises(Problem) as refused:
        await Client(work).task
    assert refused.value.status_code == 503
    await asyncio.gather(running.leave(), waiting.leave())


async def test_one_stage_does_not_take_all_places() -> None:
    """45 long steps of one stage: they would wait for its lock anyway."""
    work = LongWork(running=3, waiting=9, about_one=2)
    steps = [Client(work, "stage 1") for _ in range(4)]
    await settled()
    assert [client.has_place.is_set() for client in steps] == [True, True, False, False]
    other = Client(work, "stage 2")
    await other.has_place.wait()
    assert (work.running, work.waiting) == (3, 2)
    await steps[0].leave()
    await steps[2].has_place.wait()
    await asyncio.gather(*(client.leave() for client in (*steps[1:], other)))
    assert (work.running, work.waiting) == (0, 0)


async def test_who_has_waited_long_is_told_to_try_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(long_work, "WAIT_SECONDS", 0.0)
    work = LongWork(running=1, waiting=1)
    running = Client(work)
    await settled()
    with pytest.raises(Problem, match="try again") as refused:
        await Client(work).task
    assert refused.value.headers == {"Retry-After": "1"}
    await running.leave()


async def test_who_has_gone_leaves_the_queue() -> None:
    work = LongWork(running=1, waiting=1)
    running, leaver = Client(work), Client(work)
    await settled()
    leaver.gone.set_result(None)
    with pytest.raises(CancelledError):
        await leaver.task
    successor = Client(work)
    await settled()
    await running.leave()
    await successor.has_place.wait()
    await successor.leave()


async def test_a_place_is_free_again_after_an_error() -> None:
    work = LongWork(running=1, waiting=0)
    gone: asyncio.Future[None] = asyncio.get_running_loop().create_future()
    with pytest.raises(ValueError, match="its own"):
        async with work.place(gone):
            raise ValueError("its own")
    async with work.place(gone):
        assert work.running == 1


LONG = {
    "log": ("GET", "/api/stages/{}/log", None),
    "history": ("GET", "/api/stages/{}/history", None),
    "facts": ("GET", "/api/stages/{}/facts", None),
    "new machine": ("POST", "/api/machines", {"name": "a", "character": "b"}),
    "step": ("POST", "/api/stages/{}/step", {}),
    "seek": ("POST", "/api/stages/{}/seek", {"tick": 0}),
    "frame": ("GET", "/api/stages/{}/frame.glb", None),
    "recording": ("GET", "/api/stages/{}/recording.glb", None),
    "why": ("GET", "/api/stages/{}/actors/1/why?tick=0", None),
    "why not": ("GET", "/api/stages/{}/actors/1/whynot?event=JUMP&tick=0", None),
    "verify": ("GET", "/api/machines/faq-walker/verify", None),
    "edit": ("PUT", "/api/machines/faq-walker", {"text": ""}),
    "cell": ("PATCH", "/api/machines/faq-walker/cells", {"state": "A", "event": "B", "text": ""}),
    "undo": ("POST", "/api/machines/faq-walker/undo", None),
}


@pytest.fixture
async def full() -> AsyncIterator[httpx.AsyncClient]:
    """A client of a server whose places for long requests are all taken."""
    app: Any = create_app(Settings(main_stage=False))
    app.app.app.state.long_work = LongWork(running=0, waiting=0)
    async with httpx.AsyncClient(
        transport=httpx.ASGITransport(app), base_url="http://localhost", headers={"If-Match": '"1"'}
    ) as client:
        yield client


@pytest.mark.parametrize(("method", "path", "body"), LONG.values(), ids=LONG)
async def test_a_long_request_needs_a_place(
    full: httpx.AsyncClient, method: str, path: str, body: Any
) -> None:
    stage = (await full.post("/api/stages", json={"clock": "manual"})).json()["id"]
    answer = await full.request(method, path.format(stage), json=body)
    assert (answer.status_code, "try again" in answer.json()["detail"]) == (503, True)


async def test_short_requests_need_none(full: httpx.AsyncClient) -> None:
    opened = await full.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}]})
    posted = await full.post(f"{opened.headers['Location']}/events", json={"event": "FORWARD"})
    assert (opened.status_code, posted.status_code) == (201, 202)
    assert (await full.get("/api/machines")).status_code == 200


def test_work_in_a_process_ends_when_its_client_has_gone() -> None:
    """It would take many seconds; the measured figures of a machine are kept as soon as they are there."""
    app: Any = create_app(Settings(main_stage=False))
    state = app.app.app.state
    with serving(app) as address, httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
        host, port = address.split(":")
        with socket.create_connection((host, int(port))) as client:
            client.sendall(b"GET /api/machines/faq-walker/measure HTTP/1.1\r\nHost: localhost\r\n\r\n")
            wait_for(lambda: state.workers.processes)
        wait_for(lambda: not state.long_work.running)
        assert rest.get("/api/machines/elbow/verify").is_success
        role = state.registry.catalogue.role("faq-walker")
        processes = state.workers.processes
    assert role not in measuring._known
    assert processes
    assert state.workers.processes == []
