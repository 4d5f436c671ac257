"""The lanes show the stage's past, also to a page that was opened late."""

from collections.abc import Callable

import httpx
from browser.conftest import Server, leave, until
from playwright.sync_api import Page


def test_a_page_opened_late_knows_what_was(server: Server, opened: Callable[[str], Page]) -> None:
    """Two minutes passed before anybody looked: the lane is full from the first tick on, with the walk in
    it.
    """
    machine = httpx.get(f"{server.url}/api/machines").json()[0]["name"]
    stage = httpx.post(
        f"{server.url}/api/stages", json={"clock": "manual", "actors": [{"machine": machine}]}
    ).headers["Location"]
    httpx.post(f"{server.url}{stage}/events", json={"event": "FORWARD"})
    httpx.post(f"{server.url}{stage}/step", json={"ticks": 240}, timeout=60)
    page = opened(f"{server.url}/?stage={stage.rsplit('/', 1)[1]}")
    until(page, "__viewer.lanes().length > 2")
    told = httpx.get(f"{server.url}{stage}/history").json()["changes"]
    assert page.evaluate("__viewer.lanes().map(([start, , state]) => [start, state])") == [
        [one["tick"], one["state"]] for one in told
    ]
    leave(page, f"{server.url}{stage}")
