"""The line: acknowledgements, the way back after a restart, and what a name cannot do."""

import json
from collections.abc import Callable

import httpx
from browser.conftest import Server, until
from playwright.sync_api import Page

HOSTILE = "<img src=x onerror=\"document.title='owned'\">"


def test_every_frame_is_acknowledged(viewer: Page) -> None:
    """Longer than the server's patience with a viewer that acknowledges nothing."""
    viewer.evaluate("__viewer.listen(6)")
    until(viewer, "__viewer.link() === 'live'")


def test_it_comes_back_after_a_restart(server: Server, viewer: Page, allowed: list[str]) -> None:
    allowed += ["WebSocket connection to", "Failed to load resource", "ERR_CONNECTION_REFUSED"]
    server.stop()
    viewer.get_by_text("lost, trying again").wait_for()
    server.start()
    until(viewer, "__viewer.link() === 'live' && __viewer.head() > 10")
    until(viewer, "__viewer.posed() > 10")


def test_a_killed_server_takes_nothing_with_it(server: Server, viewer: Page, allowed: list[str]) -> None:
    """The page says that the stage came back; its walker still goes forward."""
    allowed += ["WebSocket connection to", "Failed to load resource", "ERR_CONNECTION_REFUSED"]
    url = f"{server.url}/api/stages/main"
    posted = httpx.post(f"{url}/events", json={"event": "FORWARD"}).json()
    server.kill()
    until(viewer, "__viewer.link() !== 'live'")
    server.start()
    until(viewer, "__viewer.link() === 'live'")
    viewer.get_by_text("Restored: the server was started again").last.wait_for()
    lines = httpx.get(f"{url}/log").text.splitlines()
    assert json.loads(lines[-1])["number"] >= posted["seq"]
    until(viewer, "__viewer.state() === 'WALK'")
    httpx.post(f"{url}/events", json={"event": "STOP"}).raise_for_status()


def test_names_are_text(server: Server, opened: Callable[[str], Page]) -> None:
    machine = httpx.get(f"{server.url}/api/machines").json()[0]["name"]
    actors = [
        {"machine": machine, "name": HOSTILE},
        {"machine": machine, "name": "\u202etwo", "position": [1.5, 0, 0]},
    ]
    made = httpx.post(f"{server.url}/api/stages", json={"actors": actors, "clock": "real"}, timeout=60).json()
    page = opened(f"{server.url}/?stage={made['id']}")
    options = page.locator("#picker select").nth(1).locator("option")
    options.nth(1).wait_for(state="attached")
    assert options.all_text_contents() == [HOSTILE, "\u202etwo"]
    assert page.locator("img").count() == 0
    assert page.title() == "statwalk"


def test_an_unknown_stage_leads_back_to_main(
    server: Server, opened: Callable[[str], Page], allowed: list[str]
) -> None:
    allowed += ["WebSocket connection to", "Failed to load resource"]
    page = opened(f"{server.url}/?stage=nowhere")
    assert page.evaluate("__viewer.stage()") == "main"
