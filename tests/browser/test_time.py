"""Time: the scrub bar goes back for this page alone, the stage goes on; pause and step are the stage's."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Page

SCRUB = """tick => {
  const bar = document.querySelector('.scrub');
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
    viewer.wait_for_function("__viewer.tick() > 60")
    there = viewer.evaluate("__viewer.tick()") - 40
    viewer.evaluate(SCRUB, there)
    viewer.wait_for_function("there => __viewer.tick() === there", arg=there)
    assert viewer.evaluate("__viewer.looking()") == there
    viewer.wait_for_function("there => __viewer.head() > there + 60", arg=there)
    viewer.get_by_role("button", name="live", exact=True).last.click()
    viewer.wait_for_function("there => __viewer.looking() === null && __viewer.tick() > there + 60", arg=there)


def test_the_same_tick_looks_the_same(viewer: Page) -> None:
    """Going to a tick twice shows the same hash and the same pose."""
    viewer.wait_for_function("__viewer.tick() > 60")
    there = viewer.evaluate("__viewer.tick()") - 30
    seen = []
    for tick in (there, there - 20, there):
        viewer.evaluate(SCRUB, tick)
        viewer.wait_for_function("tick => __viewer.tick() === tick", arg=tick)
        viewer.wait_for_function("__viewer.posed() === __viewer.tick()")
        seen.append(viewer.evaluate("[__viewer.hash(), __viewer.joints()]"))
    assert seen[0] == seen[2]
    assert seen[0][0] != seen[1][0]


def test_pause_stands_still_and_step_is_one_tick(paused: Page) -> None:
    before = paused.evaluate("__viewer.head()")
    paused.keyboard.press(".")
    paused.wait_for_function("before => __viewer.tick() === before + 1", arg=before)


def test_an_event_in_the_past_forks(viewer: Page, allowed: list[str]) -> None:
    viewer.wait_for_function("__viewer.tick() > 60 && __viewer.state() === 'STAT'")
    viewer.evaluate(SCRUB, viewer.evaluate("__viewer.tick()") - 10)
    viewer.wait_for_function("__viewer.looking() === __viewer.tick()")
    viewer.keyboard.press("c")
    viewer.wait_for_function("__viewer.stage() !== 'main' && __viewer.link() === 'live'")
    assert "stage=" in viewer.url
