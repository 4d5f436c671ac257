"""Two people at one stage: they have names, are told who paused, and follow each other's cameras."""

import pytest
from browser.conftest import controls, until
from playwright.sync_api import Page
from serving import wait_for


@pytest.fixture
def other(viewer: Page) -> Page:
    """Another page at the stage of the first."""
    page = viewer.context.new_page()
    page.goto(viewer.url)
    until(page, "window.__viewer?.ready")
    return page


def follow(page: Page) -> None:
    """Has the page follow the camera of the only other viewer."""
    page.get_by_role("button", name="2 viewers").click()
    page.get_by_role("button", name="follow the camera").click()


def test_the_others_are_told_by_name_who_paused(viewer: Page, other: Page) -> None:
    other.get_by_role("button", name="2 viewers").click()
    other.get_by_label("your name").fill("Ada")
    other.keyboard.press("Enter")
    until(viewer, "document.querySelector('#people').textContent.includes('Ada')")
    other.keyboard.press("Escape")
    other.keyboard.press("p")
    until(viewer, "document.querySelector('#notices').textContent.includes('paused by Ada')")
    other.wait_for_selector("[data-link=paused]")  # else its second press would pause again
    other.keyboard.press("p")
    viewer.wait_for_selector("[data-link=live]")


def test_a_page_follows_the_camera_of_another(viewer: Page, other: Page) -> None:
    before = viewer.evaluate("__viewer.around()")
    follow(viewer)
    other.mouse.move(200, 300)
    other.mouse.down()
    other.mouse.move(300, 310)
    other.mouse.up()
    wait_for(lambda: viewer.evaluate("__viewer.around()") == other.evaluate("__viewer.around()") != before)


STEPS = """(() => {
  const places = [];
  const note = () => {
    places.push(__viewer.around());
    if (places.length < 90) requestAnimationFrame(note);
    else window.longest = Math.max(...places.slice(1).map((place, k) =>
      Math.max(...place.map((metres, axis) => Math.abs(metres - places[k][axis])))));
  };
  note();
})()"""


def test_the_camera_that_is_followed_walks_along_evenly(viewer: Page, other: Page) -> None:
    """Nothing is told while the other's character walks: its camera moves with it on both pages."""
    follow(viewer)
    other.keyboard.down("ArrowUp")
    until(viewer, "__viewer.state() === 'WALK'")
    viewer.evaluate(STEPS)
    until(viewer, "window.longest !== undefined")
    other.keyboard.up("ArrowUp")
    assert viewer.evaluate("longest") < 0.002


def test_a_free_camera_that_is_followed_stays_when_the_character_goes(viewer: Page, other: Page) -> None:
    follow(viewer)
    other.keyboard.press("0")
    camera = controls(viewer, "camera").get_by_label("camera", exact=True)
    wait_for(lambda: camera.input_value() == "free")
    wait_for(lambda: viewer.evaluate("__viewer.camera()") == other.evaluate("__viewer.camera()"))
    stood = other.evaluate("__viewer.camera().position")
    root = "Object.values(__viewer.joints())[0]"
    start = viewer.evaluate(root)
    other.keyboard.down("ArrowUp")
    until(viewer, f"Math.hypot(...{root}.map((place, i) => place - arg[i])) > 1", start)
    other.keyboard.up("ArrowUp")
    stand = [page.evaluate("__viewer.camera().position") for page in (viewer, other)]
    assert stand == [stood, stood]
