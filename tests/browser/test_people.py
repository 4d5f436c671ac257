"""Two people at one stage: they have names, are told who paused, and follow each other's cameras."""

import pytest
from browser.conftest import until
from playwright.sync_api import Page
from serving import wait_for


@pytest.fixture
def other(viewer: Page) -> Page:
    """Another page at the stage of the first."""
    page = viewer.context.new_page()
    page.goto(viewer.url)
    until(page, "window.__viewer?.ready")
    return page


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
    before = viewer.evaluate("__viewer.camera()")
    viewer.get_by_role("button", name="2 viewers").click()
    viewer.get_by_role("button", name="follow the camera").click()
    other.mouse.move(200, 300)
    other.mouse.down()
    other.mouse.move(300, 310)
    other.mouse.up()
    wait_for(lambda: viewer.evaluate("__viewer.camera()") == other.evaluate("__viewer.camera()") != before)
