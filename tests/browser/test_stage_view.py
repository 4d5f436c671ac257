"""Looks at the stage view: the character in both streams, and its bones."""

import pytest
from browser.conftest import Server, until
from playwright.sync_api import Page

MOST_COLOUR = 14
MOST_AREA = 0.004
MOST_BOX = 0.03


@pytest.fixture
def most_fps() -> int:
    """As often as without a limit: a screenshot has what was drawn last."""
    return 30


def test_the_character_is_there(viewer: Page) -> None:
    drawn = viewer.evaluate("__viewer.pixels()")
    left, top, right, bottom = drawn["box"]
    assert drawn["covered"] > 0.02
    assert bottom - top > 0.5
    assert 0.2 < (left + right) / 2 < 0.8


def test_it_is_in_the_page_as_well(viewer: Page) -> None:
    """Without its skin the canvas looks different."""
    shot = viewer.locator("#stage-view").screenshot()
    viewer.keyboard.press("1")
    until(viewer, "__viewer.pixels().covered === 0")
    assert viewer.locator("#stage-view").screenshot() != shot


def test_the_page_says_that_the_character_is_hidden_and_shows_it_again(viewer: Page) -> None:
    note = viewer.get_by_role("status").filter(has_text="the character is hidden")
    assert note.is_hidden()
    viewer.keyboard.press("1")
    note.wait_for()
    until(viewer, "__viewer.pixels().covered === 0")
    viewer.get_by_role("button", name="show the skin").click()
    until(viewer, "__viewer.pixels().covered > 0.02")
    note.wait_for(state="hidden")


def test_software_rendering_means_low_quality(viewer: Page) -> None:
    assert viewer.evaluate("__viewer.quality()") == "low"


TIME_OF_DRAWINGS = """async count => {
  const drawn = () => __viewer.stats().drawn;
  const [before, start] = [drawn(), performance.now()];
  while (drawn() < before + count) await new Promise(requestAnimationFrame);
  return (performance.now() - start) / 1000;
}"""


@pytest.mark.parametrize(("wanted", "count", "least_s"), [("", 30, 0.85), ("60", 30, 0.85), ("8", 16, 1.6)])
def test_a_software_renderer_draws_at_most_thirty_times_a_second_and_no_more_than_wanted(
    server: Server, page: Page, wanted: str, count: int, least_s: float
) -> None:
    """Frames come sixty times a second, and each moves the character."""
    page.goto(f"{server.url}/?fps={wanted}")
    until(page, "window.__viewer?.ready")
    assert page.evaluate(TIME_OF_DRAWINGS, count) > least_s


CHANGES_OF_THE_TICK = """async count => {
  const drawn = () => __viewer.stats().drawn;
  const before = drawn();
  let changes = 0;
  const counter = document.querySelector('#transport .tick');
  const observer = new MutationObserver(() => changes++);
  observer.observe(counter, { childList: true, characterData: true, subtree: true });
  while (drawn() < before + count) await new Promise(requestAnimationFrame);
  return changes;
}"""


@pytest.mark.parametrize("most_fps", [8])
def test_counters_change_no_more_often_than_the_picture(viewer: Page) -> None:
    assert 0 < viewer.evaluate(CHANGES_OF_THE_TICK, 8) < 12


def test_server_and_gpu_skin_alike(viewer: Page) -> None:
    """Both streams show the same paused tick: same silhouette, same colours."""
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=paused]")
    until(viewer, "__viewer.posed() === __viewer.head()")
    by_gpu = viewer.evaluate("__viewer.pixels()")
    viewer.keyboard.press("g")
    until(viewer, "__viewer.frames() === 'glb' && __viewer.shown() === 'glb'")
    by_server = viewer.evaluate("__viewer.pixels()")
    viewer.keyboard.press("g")
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=live]")
    assert abs(by_gpu["covered"] - by_server["covered"]) < MOST_AREA
    assert max(abs(a - b) for a, b in zip(by_gpu["box"], by_server["box"], strict=True)) < MOST_BOX
    assert max(abs(a - b) for a, b in zip(by_gpu["colour"], by_server["colour"], strict=True)) < MOST_COLOUR


def test_bones_are_drawn_over_the_skin(viewer: Page) -> None:
    """RD1, RD2: the overlays change the picture, and their buttons say that they are on."""
    for name in ("bones", "tetra", "wire"):
        button = viewer.get_by_role("button", name=name)
        before = viewer.evaluate("__viewer.stats().drawn")
        button.click()
        until(viewer, "__viewer.stats().drawn > arg", before)
        viewer.get_by_role("button", name=name, pressed=True).wait_for()


def test_bones_are_on_the_character_in_both_streams(viewer: Page) -> None:
    """RD1, RD2: while it walks; at one paused tick the joints are at the same places in both."""
    viewer.get_by_role("button", name="bones").click()
    viewer.keyboard.press("g")
    viewer.keyboard.down("ArrowUp")
    start = viewer.evaluate("__viewer.joints()")
    until(
        viewer,
        "__viewer.shown() === 'glb' && __viewer.state() === 'WALK' && "
        "Object.keys(arg).some(name => Math.abs(__viewer.joints()[name][2] - arg[name][2]) > 1)",
        start,
    )
    assert viewer.evaluate("__viewer.overlays()") == 1
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=paused]")
    until(viewer, "__viewer.posed() === __viewer.head()")
    by_server = viewer.evaluate("__viewer.joints()")
    viewer.keyboard.press("g")
    until(viewer, "__viewer.shown() === 'pose'")
    by_browser = viewer.evaluate("__viewer.joints()")
    viewer.keyboard.up("ArrowUp")
    viewer.keyboard.press("p")
    viewer.wait_for_selector("[data-link=live]")
    assert viewer.evaluate("__viewer.overlays()") == 1
    assert all(by_server[name] == pytest.approx(by_browser[name], abs=1e-4) for name in by_browser)
