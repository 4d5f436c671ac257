"""A stage that nobody watches and nobody has asked for sleeps until somebody does."""

import pickle
from collections.abc import Callable
from pathlib import Path

import httpx
import pytest
from keeping import keeping
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.limits import Limits
from statwalk.services.publish.outbox import Outbox
from statwalk.web.app import create_app, lifespan
from statwalk.web.settings import Settings

SETUP = StageSetup(actors=(AddActor("elbow"),))
STEP = 0.1
"""seconds between two looks at the clock; 6 ticks"""


class Hours:
    """A registry whose clock the test turns."""

    def __init__(self, catalogue: Catalogue) -> None:
        self.time = 0.0
        self.lost = 0
        self.held = Registry(catalogue, pickle.dumps, Limits(), now=lambda: self.time)
        self.held.measure_ticks = self.measure

    def measure(self, _: object, lost: int) -> None:
        self.lost += lost

    def run(self, host: StageHost, seconds: float) -> None:
        """As the ticker runs a stage."""
        for _ in range(round(seconds / STEP)):
            self.time += STEP
            host.advance_to(self.time)


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


@pytest.fixture
def hours(catalogue: Catalogue) -> Hours:
    return Hours(catalogue)


def tick(host: StageHost) -> int:
    return host.look(ask.Status()).tick


def is_asleep(host: StageHost) -> bool:
    return host.look(ask.Describe()).asleep


def test_a_stage_that_nobody_uses_takes_no_ticks(hours: Hours) -> None:
    host = hours.held.open(SETUP)
    hours.run(host, 31)
    asleep = tick(host)
    hours.run(host, 100)
    assert is_asleep(host)
    assert tick(host) == asleep == pytest.approx(30 * 60, abs=12)


def test_it_goes_on_where_it_stood_and_leaves_no_tick_out(hours: Hours) -> None:
    host = hours.held.open(SETUP)
    hours.run(host, 100)
    asleep, lost = tick(host), hours.lost
    host.handle(ask.Status())
    hours.run(host, 2 * STEP)
    assert not is_asleep(host)
    assert (tick(host) - asleep, hours.lost - lost) == (6, 0)


def awake_for_100_s(hours: Hours, host: StageHost) -> bool:
    """At the full number of ticks."""
    hours.run(host, 100)
    return not is_asleep(host) and tick(host) == pytest.approx(6000, abs=12)


STAGES: dict[str, Callable[[Registry], StageHost]] = {
    "main": lambda held: held.open_main(),
    "made to keep running": lambda held: held.open(StageSetup(keep_running=True)),
}


@pytest.mark.parametrize("stage", STAGES)
def test_these_do_not_sleep(hours: Hours, stage: str) -> None:
    assert awake_for_100_s(hours, STAGES[stage](hours.held))


@pytest.mark.anyio
async def test_a_stage_with_a_viewer_does_not_sleep(hours: Hours) -> None:
    host = hours.held.open(SETUP)
    host.join(Outbox("pose"))
    assert awake_for_100_s(hours, host)


def test_what_is_made_to_keep_running_does_so_after_a_start(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        kept = held.open(StageSetup(keep_running=True)).id
        other = held.open(SETUP).id
    with keeping(tmp_path, catalogue) as held:
        assert [held.find(name).identity.may_sleep for name in (kept, other)] == [False, True]


def test_a_stage_sleeps_after_a_start_until_somebody_asks(tmp_path: Path, catalogue: Catalogue) -> None:
    """A hundred stages that nobody watches do not step at once."""
    with keeping(tmp_path, catalogue) as held:
        main, kept = held.open_main().id, held.open(SETUP).id
    with keeping(tmp_path, catalogue) as held:
        hosts = [held.stages[name] for name in (main, kept)]
        for host in hosts:
            host.advance_to(held.now())
        assert [is_asleep(host) for host in hosts] == [False, True]
        hosts[1].handle(ask.Status())
        hosts[1].advance_to(held.now())
        assert not is_asleep(hosts[1])


def test_a_kept_stage_is_never_deleted_because_nobody_uses_it(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = held.open(StageSetup(clock="manual"))
        held.drop_idle(held.now() + 1e6)
        assert held.find(host.id) is host


def test_keeping_a_stage_is_no_request(tmp_path: Path, catalogue: Catalogue) -> None:
    """The server keeps all stages once a second."""
    with keeping(tmp_path, catalogue) as held:
        host = held.open(SETUP)
        asked = host.idle_for(held.now())
        held.save()
        assert host.idle_for(held.now()) > asked


@pytest.mark.anyio
async def test_the_list_of_stages_and_the_metrics_wake_none() -> None:
    app = create_app(Settings(limits=Limits(rest_seconds=1e-9)))
    inside = app.app.app  # type: ignore[attr-defined] - within the log and the guard
    transport = httpx.ASGITransport(app)
    async with (
        lifespan(inside),
        httpx.AsyncClient(transport=transport, base_url="http://localhost") as client,
    ):
        made = (await client.post("/api/stages", json={})).json()["id"]
        host = inside.state.registry.stages[made]
        host.advance_to(inside.state.registry.now())
        asked = host.idle_for(0.0)
        await client.get("/metrics")
        listed = {stage["id"]: stage["asleep"] for stage in (await client.get("/api/stages")).json()}
        assert (listed, host.idle_for(0.0)) == ({"main": False, made: True}, asked)
        await client.get(f"/api/stages/{made}")
        assert host.idle_for(0.0) < asked
