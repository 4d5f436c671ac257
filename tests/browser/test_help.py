"""The help changes keys; a page in a hall shows the character alone."""

from browser.conftest import Server, until
from playwright.sync_api import Page

SEEN = """[...document.querySelectorAll("body *")]
  .filter(element => element.checkVisibility() && element.clientWidth)
  .map(({ id }) => id)"""


def test_a_changed_key_is_kept_when_the_page_is_opened_again_until_all_keys_are_reset(
    viewer: Page,
) -> None:
    viewer.keyboard.press("?")
    viewer.get_by_role("button", name="key of “full screen”: M").click()
    viewer.keyboard.press("q")
    viewer.get_by_role("button", name="key of “full screen”: Q").wait_for()
    viewer.reload()
    until(viewer, "window.__viewer?.ready")
    viewer.keyboard.press("q")
    until(viewer, "document.fullscreenElement === document.documentElement")
    viewer.keyboard.press("q")
    until(viewer, "document.fullscreenElement === null")
    viewer.keyboard.press("?")
    viewer.get_by_role("button", name="reset all keys").click()
    viewer.get_by_role("button", name="key of “full screen”: M").wait_for()
    viewer.get_by_role("button", name="reset all keys").wait_for(state="hidden")
    viewer.keyboard.press("Escape")
    viewer.keyboard.press("m")
    until(viewer, "document.fullscreenElement === document.documentElement")


def test_the_help_says_what_the_marks_in_cells_mean(viewer: Page) -> None:
    """Each sign that the table shows is in its list."""
    signs = viewer.locator("#table td small").all_inner_texts()
    viewer.keyboard.press("?")
    marks = viewer.get_by_role("dialog").locator("section").filter(has_text="marks in cells")
    kinds, words = marks.locator("dt").all_inner_texts(), marks.locator("dd").all_inner_texts()
    listed = dict(zip(kinds, words, strict=True))
    assert {"⇥", "≈", "◆"} == set(signs) <= set(listed)
    assert (listed["⇥"], listed["–"]) == ("at the end of the motion", "the event is dropped")
    assert len(listed) == 11


def test_a_kiosk_shows_the_character_alone(server: Server, page: Page) -> None:
    page.goto(f"{server.url}/?kiosk")
    until(page, "window.__viewer?.ready")
    assert set(page.evaluate(SEEN)) == {"", "stage-view"}
    box = page.locator("#stage-view").bounding_box()
    assert box == {"x": 0, "y": 0, **page.viewport_size}
