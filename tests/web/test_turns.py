"""The requests of one address begin one after another, with time for others in between; a long request delays
them only for a moment, and the requests of another address not at all.
"""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import pytest
from serving import PATIENCE
from statwalk.web import turns
from statwalk.web.turns import Turns

pytestmark = pytest.mark.anyio
NEVER = 1_000.0
FIRST, SECOND = "192.0.2.1", "192.0.2.2"


class Begun:
    """Tasks that wait for their turns, in order, and keep them until they are told to end."""

    def __init__(self) -> None:
        self.turns, self.names, self.news = Turns(), list[str](), asyncio.Condition()
        self.ends: dict[str, asyncio.Event] = {}
        self.tasks: dict[str, asyncio.Task[None]] = {}

    def begin(self, name: str, address: str) -> None:
        self.ends[name] = asyncio.Event()
        self.tasks[name] = asyncio.create_task(self._run(name, address))

    async def _run(self, name: str, address: str) -> None:
        async with self.turns.of(address):
            async with self.news:
                self.names.append(name)
                self.news.notify_all()
            await self.ends[name].wait()

    async def until(self, *names: str) -> None:
        """Until these have begun, in this order."""
        async with asyncio.timeout(PATIENCE), self.news:
            await self.news.wait_for(lambda: self.names == [*names])

    async def end(self, name: str) -> None:
        self.ends[name].set()
        await self.tasks[name]


@asynccontextmanager
async def begun(*asked: tuple[str, str]) -> AsyncIterator[Begun]:
    """Requests with these names, from these addresses, that have begun as far as they may."""
    all_of_them = Begun()
    for name, address in asked:
        all_of_them.begin(name, address)
    await _settle()
    yield all_of_them
    for name in all_of_them.ends:
        all_of_them.ends[name].set()
    await asyncio.gather(*all_of_them.tasks.values(), return_exceptions=True)


async def _settle() -> None:
    """Lets every task run until it waits."""
    for _ in range(20):
        await asyncio.sleep(0)


@pytest.fixture(autouse=True)
def _no_time_passes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(turns, "TURN_SECONDS", NEVER)


async def test_the_next_request_begins_when_the_one_before_has_its_answer() -> None:
    async with begun(("a", FIRST), ("b", FIRST), ("c", FIRST)) as requests:
        assert requests.names == ["a"]
        await requests.end("a")
        await requests.until("a", "b")


async def test_between_two_requests_others_have_as_much_time(monkeypatch: pytest.MonkeyPatch) -> None:
    loop, passed = asyncio.get_running_loop(), 0.0
    time = loop.time
    monkeypatch.setattr(loop, "time", lambda: time() + passed)
    async with begun(("a", FIRST), ("b", FIRST)) as requests:
        passed = 100.0
        await requests.end("a")
        passed = 190.0
        await _settle()
        assert requests.names == ["a"]
        passed = 201.0
        await requests.until("a", "b")


async def test_a_request_begins_at_once_when_nobody_waited_for_the_one_before() -> None:
    async with begun(("a", FIRST)) as requests:
        await requests.end("a")
        requests.begin("b", FIRST)
        await _settle()
        assert requests.names == ["a", "b"]


async def test_another_address_and_no_address_wait_for_nobody() -> None:
    async with begun(("a", FIRST), ("b", SECOND), ("c", ""), ("d", "")) as requests:
        assert requests.names == ["a", "b", "c", "d"]


async def test_a_long_request_holds_nobody_up_for_long(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(turns, "TURN_SECONDS", 0.001)
    async with begun(("a", FIRST), ("b", FIRST), ("c", FIRST)) as requests:
        await requests.until("a", "b", "c")


async def test_a_long_request_may_end_after_those_that_came_later(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(turns, "TURN_SECONDS", 0.001)
    async with begun(("a", FIRST), ("b", FIRST)) as requests:
        await requests.until("a", "b")
        await requests.end("b")
        await requests.end("a")
        assert not requests.turns._newest


async def test_a_request_that_is_given_up_makes_room() -> None:
    async with begun(("a", FIRST), ("b", FIRST), ("c", FIRST)) as requests:
        requests.tasks["b"].cancel()
        await requests.end("a")
        await requests.until("a", "c")


async def test_a_request_that_is_given_up_after_a_long_wait_makes_room_at_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    loop, passed = asyncio.get_running_loop(), 0.0
    time = loop.time
    monkeypatch.setattr(loop, "time", lambda: time() + passed)
    async with begun(("a", FIRST), ("b", FIRST), ("c", FIRST)) as requests:
        passed = 900.0
        requests.tasks["b"].cancel()
        await _settle()
        assert requests.names == ["a", "c"]


async def test_nothing_is_kept_of_an_address_without_requests() -> None:
    async with begun(("a", FIRST), ("b", FIRST)) as requests:
        await requests.end("a")
        await requests.end("b")
        assert not requests.turns._newest
