"""The address names the moment, and from where the page looks: another page shows the same there."""

import pytest
from browser.conftest import controls, until
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
    other.goto(viewer.url)
    until(other, f"window.__viewer?.ready && __viewer.posed() === {tick}")
    assert other.evaluate("__viewer.joints()") == viewer.evaluate("__viewer.joints()")
    there, here = (page.evaluate("__viewer.camera()") for page in (other, viewer))
    assert controls(other, "camera").get_by_label("camera", exact=True).input_value() == "free"
    assert there["position"] == pytest.approx(here["position"], abs=0.02)
