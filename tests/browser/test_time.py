"""Time: the scrub bar goes back for this page alone, the stage goes on; pause and step are the stage's."""

from collections.abc import Iterator

import pytest
from browser.conftest import until
from playwright.sync_api import Page

SCRUB = """async tick => {
  const bar = document.querySelector('.scrub');
  while (Number(bar.max) < tick) await new Promise(done => setTimeout(done, 20));
  bar.value = String(tick);
  bar.dispatchEvent(new Event('input'));
}"""


@pytest.fixture
def paused(viewer: Page) -> Iterator[Page]:
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=paused]")
    yield viewer
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=live]")


def test_the_scrub_bar_goes_back_and_live_returns(viewer: Page) -> None:
    until(viewer, "__viewer.tick() > 60")
    there = viewer.evaluate("__viewer.tick()") - 40
    viewer.evaluate(SCRUB, there)
    until(viewer, "__viewer.tick() === arg", there)
    until(viewer, "__viewer.looking() === arg", there)
    until(viewer, "__viewer.head() > arg + 60", there)
    viewer.get_by_role("button", name="live", exact=True).last.click()
    until(viewer, "__viewer.looking() === null && __viewer.tick() > arg + 60", there)


def test_the_same_tick_looks_the_same(viewer: Page) -> None:
    """Going to a tick twice shows the same hash and the same pose."""
    until(viewer, "__viewer.tick() > 60")
    there = viewer.evaluate("__viewer.tick()") - 30
    seen = []
    for tick in (there, there - 20, there):
        viewer.evaluate(SCRUB, tick)
        until(viewer, "__viewer.tick() === arg", tick)
        until(viewer, "__viewer.posed() === __viewer.tick()")
        seen.append(viewer.evaluate("[__viewer.hash(), __viewer.joints()]"))
    assert seen[0] == seen[2]
    assert seen[0][0] != seen[1][0]


def test_pause_stands_still_and_step_is_one_tick(paused: Page) -> None:
    before = paused.evaluate("__viewer.head()")
    paused.keyboard.press(".")
    until(paused, "__viewer.tick() === arg + 1", before)


def test_space_is_the_characters_key_after_a_click_on_play(viewer: Page) -> None:
    for link in ("paused", "live"):
        viewer.locator("#transport .icon").nth(1).click()
        viewer.wait_for_selector(f"[data-link={link}]")
    viewer.keyboard.press(" ")
    until(viewer, "document.querySelector('#verdict').textContent.startsWith('JUMP')")
    assert viewer.locator("[data-link=live]").count()
