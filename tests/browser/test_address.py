"""The address names the moment, and from where the page looks: another page shows the same there."""

from collections.abc import Callable

import httpx
import pytest
from browser.conftest import Server, controls, leave, until
from browser.test_time import SCRUB
from playwright.sync_api import Page

MOMENT = "['tick=', 'camera=', 'view=free'].every(part => location.search.includes(part))"


def test_a_link_shows_the_same_moment_from_the_same_place(viewer: Page) -> None:
    until(viewer, "__viewer.tick() > 60")
    tick = viewer.evaluate("__viewer.tick()") - 30
    viewer.mouse.move(200, 300)
    viewer.mouse.down()
    viewer.mouse.move(300, 310)
    viewer.mouse.up()
    viewer.keyboard.press("0")
    viewer.evaluate(SCRUB, tick)
    until(viewer, f"__viewer.posed() === {tick} && {MOMENT}")
    other = viewer.context.new_page()
    other.goto(viewer.evaluate("location.href"))
    until(other, f"window.__viewer?.ready && __viewer.posed() === {tick}")
    assert other.evaluate("__viewer.joints()") == viewer.evaluate("__viewer.joints()")
    there, here = (page.evaluate("__viewer.camera()") for page in (other, viewer))
    assert controls(other, "camera").get_by_label("camera", exact=True).input_value() == "free"
    assert there["position"] == pytest.approx(here["position"], abs=0.02)


def test_a_reloaded_page_shows_the_same_actor_and_layer(
    server: Server, opened: Callable[[str], Page]
) -> None:
    pair = [{"machine": "walker-layers", "position": [x, 0, 0]} for x in (0, 1)]
    made = httpx.post(f"{server.url}/api/stages", json={"actors": pair}, timeout=60).json()["id"]
    page = opened(f"{server.url}/?stage={made}")
    page.mouse.click(*page.evaluate("__viewer.places()['2']"))
    page.get_by_role("tab", name="head").click()
    until(page, "['actor=2', 'layer=head'].every(part => location.search.includes(part))")
    page.reload()
    until(page, "window.__viewer?.ready")
    page.locator("#layers [aria-selected=true]").filter(has_text="head").wait_for()
    assert page.get_by_label("actor", exact=True).input_value() == "2"
    rows = "[...document.querySelectorAll('#table tbody th')].map(head => head.dataset.state).join()"
    assert page.evaluate(rows) == "CALM,NOD"
    leave(page, f"{server.url}/api/stages/{made}")
