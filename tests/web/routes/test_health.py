"""A live server is ready as long as its stages move; the process answers in any case."""

from importlib.metadata import version

import httpx
import pytest
from prometheus_client.parser import text_string_to_metric_families
from serving import PATIENCE, serving, wait_for
from statwalk.web.app import create_app
from statwalk.web.settings import Settings
from watcher import Watcher

pytestmark = pytest.mark.anyio


def test_a_server_that_serves_is_healthy_and_ready(rest: httpx.Client) -> None:
    assert rest.get("/healthz").json() == {"status": "ok", "version": version("statwalk")}
    assert rest.get("/readyz").json() == {"status": "ready"}


def test_a_start_without_losses_says_so(rest: httpx.Client) -> None:
    assert rest.get("/api/losses").json() == {"stages": [], "other": []}


async def test_without_its_clock_a_server_lives_but_is_not_ready(client: httpx.AsyncClient) -> None:
    assert (await client.get("/healthz")).status_code == 200
    answer = await client.get("/readyz")
    assert (answer.status_code, answer.headers["content-type"]) == (503, "application/problem+json")


def test_a_stage_that_fails_makes_the_server_unready(monkeypatch: pytest.MonkeyPatch) -> None:
    app = create_app(Settings())
    registry = app.app.app.state.registry
    with serving(app) as address, httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
        assert rest.get("/readyz").status_code == 200
        monkeypatch.setattr(registry.find("main"), "advance_to", lambda _: 1 / 0)
        wait_for(lambda: rest.get("/readyz").status_code == 503)
        assert "1 of the stages fail" in rest.get("/readyz").json()["detail"]
        monkeypatch.undo()
        wait_for(lambda: rest.get("/readyz").status_code == 200)


def test_the_metrics_are_what_prometheus_reads(address: str, rest: httpx.Client) -> None:
    with Watcher(address, "/api/stages/main") as watcher:
        watcher.frame_from(watcher.frame().tick + 3)
        answer = rest.get("/metrics")
    families = {family.name: family for family in text_string_to_metric_families(answer.text)}
    held = {sample.labels["what"]: sample.value for sample in families["statwalk_held"].samples}
    assert held["viewers"] >= 1
    assert sum(sample.value for sample in families["statwalk_frames_sent"].samples) >= 3
    assert families["statwalk_tick_late_seconds"].samples
