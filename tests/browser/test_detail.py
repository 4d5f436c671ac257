"""DS10 in the page: by the slider, by the size on screen, and in a crowd."""

from collections.abc import Callable, Iterator
from typing import Any

import httpx
import pytest
from browser.conftest import Server, controls, leave, until
from playwright.sync_api import Page


def stage_of(server: Server, setup: dict[str, Any]) -> str:
    made = httpx.post(f"{server.url}/api/stages", json={"clock": "manual", **setup}, timeout=60)
    stage = f"{server.url}{made.raise_for_status().headers['Location']}"
    httpx.post(f"{stage}/step", json={"ticks": 30}, timeout=60).raise_for_status()
    return stage


@pytest.fixture
def walker(server: Server, opened: Callable[[str], Page]) -> Iterator[Page]:
    stage = stage_of(server, {"actors": [{"machine": "faq-walker"}]})
    page = opened(f"{server.url}/?stage={stage.rsplit('/', 1)[1]}")
    until(page, "__viewer.posed() === 30")
    yield page
    leave(page, stage)


def triangles(page: Page) -> int:
    count: int = page.evaluate("__viewer.detail().triangles")
    return count


def test_the_slider_chooses_a_level(walker: Page, server: Server) -> None:
    levels = httpx.get(f"{server.url}/api/characters/walker/levels", timeout=60).json()
    slider = controls(walker).get_by_label("detail", exact=True)
    slider.fill(str(len(levels) - 1))
    until(walker, "__viewer.detail().level === 0")
    full, covered = triangles(walker), walker.evaluate("__viewer.pixels()")["covered"]
    slider.fill(str(len(levels) - 1 - 5))
    until(walker, "__viewer.detail().level === 5")
    gone = levels[0]["triangles"] - levels[5]["triangles"]
    passes = round((full - triangles(walker)) / gone, 3)
    assert passes in (1, 2), "the picture, and the shadow's picture"
    assert walker.evaluate("__viewer.pixels()")["covered"] == pytest.approx(covered, rel=0.05)
    walker.locator(".detail-words").filter(has_text=f"{levels[5]['triangles']:,} triangles").wait_for()


def test_by_size_the_error_stays_below_a_pixel(walker: Page) -> None:
    until(walker, "__viewer.detail().levels.length > 5")
    near = walker.evaluate("__viewer.detail().level")
    walker.mouse.move(400, 300)
    for _ in range(30):
        walker.mouse.wheel(0, 400)
    until(walker, "__viewer.detail().level > arg", near)
    box = walker.evaluate("__viewer.pixels()")["box"]
    height_px = (box[3] - box[1]) * walker.locator("#stage-view").bounding_box()["height"]
    shown = walker.evaluate("__viewer.detail()")
    assert shown["levels"][shown["level"] - 1]["error_m"] * height_px / 1.75 <= 1.3


def test_a_crowd_draws_levels(server: Server, opened: Callable[[str], Page]) -> None:
    stage = stage_of(server, {"scene": "street"})
    page = opened(f"{server.url}/?stage={stage.rsplit('/', 1)[1]}")
    until(page, "__viewer.posed() === 30")
    slider = controls(page).get_by_label("detail", exact=True)
    slider.fill(slider.get_attribute("max"))
    until(page, "__viewer.detail().level === 0")
    full, calls = triangles(page), page.evaluate("__viewer.calls()")
    slider.fill("2")
    until(page, "__viewer.detail().level > 5")
    assert triangles(page) < 0.4 * full
    assert page.evaluate("__viewer.calls()") == calls
    leave(page, stage)
