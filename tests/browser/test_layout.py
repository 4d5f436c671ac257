"""What fits on pages of several sizes, and what a click must not move."""

from collections.abc import Callable

import pytest
from browser.conftest import Server, controls, until
from browser.journeys.fingers import Fingers
from playwright.sync_api import Page

LAST_ROW_IS_SEEN = """(() => {
    const table = document.querySelector('#table');
    const row = table.querySelector('tbody tr:last-child');
    return row && row.getBoundingClientRect().bottom <= table.getBoundingClientRect().bottom + 0.5;
})()"""
CELL = "#table tbody tr:nth-child(3) td:nth-child(3)"
SMALL = [(390, 844), (320, 640), (960, 600)]
"""pages that show one of graph, table and values"""
PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True}
CUT = """[...document.querySelectorAll('#events .event, #parameters label')].filter(control => {
    const box = control.getBoundingClientRect();
    return box.bottom > control.parentElement.getBoundingClientRect().bottom;
}).map(control => control.textContent.trim())"""
OPEN_AND_LOOK = """button => {
  button.click();
  const box = document.querySelector('#look-popover');
  return box.getBoundingClientRect().top - button.getBoundingClientRect().bottom;
}"""
"""opens a box; the pixels between it and its button"""


def show_tab(page: Page, name: str, width: int, height: int) -> None:
    if (width, height) in SMALL:
        page.get_by_role("tab", name=name, exact=True).click()


def test_the_whole_table_is_seen_on_a_large_page(viewer: Page) -> None:
    viewer.set_viewport_size({"width": 1440, "height": 900})
    until(viewer, LAST_ROW_IS_SEEN)


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (1280, 800), (1024, 700), (960, 600)])
def test_a_machine_with_layers_and_sliders_has_its_table_in_sight(
    server: Server, opened: Callable[[str], Page], width: int, height: int
) -> None:
    """Six rows; where the page is not small, its event buttons and sliders stay in sight, too."""
    page = opened(f"{server.url}?machine=walker-layers")
    page.set_viewport_size({"width": width, "height": height})
    show_tab(page, "table", width, height)
    page.get_by_role("tab", name="face").click()
    until(page, "document.querySelectorAll('#table tbody tr').length === 6")
    until(page, LAST_ROW_IS_SEEN)
    if height >= 800:
        assert page.evaluate(CUT) == []


@pytest.mark.parametrize(("width", "height"), SMALL)
def test_a_small_page_has_sliders_and_layers(
    server: Server, opened: Callable[[str], Page], width: int, height: int
) -> None:
    page = opened(f"{server.url}?machine=walker-layers")
    page.set_viewport_size({"width": width, "height": height})
    page.get_by_role("tab", name="head").click()
    show_tab(page, "values", width, height)
    slider = page.get_by_role("slider", name="speed")
    slider.press("End")
    until(page, "document.querySelector('#parameters output').textContent === '2.8'")
    show_tab(page, "table", width, height)
    page.locator("#table [data-state=CALM]").first.wait_for()


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (1024, 700), (960, 600)])
def test_a_cell_that_is_clicked_stays_under_the_pointer(viewer: Page, width: int, height: int) -> None:
    viewer.set_viewport_size({"width": width, "height": height})
    show_tab(viewer, "table", width, height)
    cell = viewer.locator(CELL)
    cell.click()
    until(viewer, "document.querySelector('#cell-inspector .findings')")
    before = cell.bounding_box()
    viewer.keyboard.press("Escape")
    until(viewer, "document.querySelector('#cell-inspector').hidden")
    assert cell.bounding_box() == before


@pytest.mark.parametrize(("width", "height"), [(390, 844), (320, 640)])
def test_a_phone_scrolls_no_page_sideways(viewer: Page, width: int, height: int) -> None:
    viewer.set_viewport_size({"width": width, "height": height})
    until(viewer, "innerWidth === arg", width)
    assert viewer.evaluate("document.documentElement.scrollWidth") == width


@pytest.mark.parametrize(("width", "height"), [(390, 844), (320, 640)])
def test_a_phone_shows_live_and_whole_events_of_a_machine_with_layers(
    server: Server, opened: Callable[[str], Page], width: int, height: int
) -> None:
    page = opened(f"{server.url}?machine=walker-layers")
    page.set_viewport_size({"width": width, "height": height})
    until(page, "document.querySelector('.live-button').getBoundingClientRect().right <= innerWidth")
    assert page.locator("#events").bounding_box()["height"] >= 60
    assert page.locator(".lanes-window").bounding_box()["height"] <= 84


def test_nothing_of_the_header_is_cut(viewer: Page) -> None:
    """What has no room is in a menu at its end, which the keyboard opens: there is the palette, too."""
    for width in (1440, 1100, 1024, 960, 390, 320):
        viewer.set_viewport_size({"width": width, "height": 640})
        until(viewer, "innerWidth === arg && document.querySelector('.bar').scrollWidth <= arg", width)
    viewer.get_by_role("button", name="more").press("Enter")
    viewer.get_by_role("menuitem", name="find anything").press("Enter")
    viewer.get_by_role("combobox", name="find a command").wait_for()


@pytest.mark.parametrize("window", [Fingers.WINDOW], ids=["tablet"])
def test_the_buttons_of_events_are_whole_for_fingers(viewer: Page) -> None:
    row = viewer.locator("#events").bounding_box()
    button = viewer.locator("#events [data-event=FORWARD]").bounding_box()
    assert row is not None
    assert button is not None
    assert row["y"] <= button["y"]
    assert button["y"] + button["height"] <= row["y"] + row["height"]


@pytest.mark.parametrize("window", [PHONE], ids=["phone"])
def test_the_buttons_of_the_graph_cover_no_state_of_a_phone(viewer: Page) -> None:
    """Fingers have no pointer that comes and goes, so the buttons always show."""
    viewer.locator("#graph .state").first.wait_for()
    until(
        viewer,
        "document.querySelector('.graph-buttons').getBoundingClientRect().bottom <= Math.min("
        "...[...document.querySelectorAll('#graph .state')].map(state => state.getBoundingClientRect().top))",
    )


@pytest.mark.parametrize("window", [PHONE], ids=["phone"])
def test_the_table_of_a_phone_has_the_place_of_the_words_until_an_event(viewer: Page) -> None:
    viewer.get_by_role("tab", name="table").click()
    words = viewer.locator("#verdict")
    words.wait_for(state="hidden")
    viewer.locator("#events [data-event=FORWARD]").tap()
    words.wait_for()


def test_a_phone_has_the_look_below_the_picture(viewer: Page) -> None:
    """Its row has no room for what is drawn; the keyboard opens, and Escape gives the focus back."""
    viewer.set_viewport_size({"width": 390, "height": 844})
    bones = viewer.locator("#look-popover").get_by_role("button", name="bones")
    button = viewer.get_by_role("button", name="look", exact=True)
    button.press("Enter")
    bones.wait_for()
    box, opener = viewer.locator("#look-popover").bounding_box(), button.bounding_box()
    assert box is not None
    assert opener is not None
    assert box["y"] >= opener["y"] + opener["height"]
    bones.press("Escape")
    bones.wait_for(state="hidden")
    assert button.evaluate("button => button === document.activeElement")


def test_a_box_of_controls_opens_below_its_button_at_once(viewer: Page) -> None:
    """The page looks in the same task in which the box opens, before any frame is drawn."""
    viewer.set_viewport_size({"width": 390, "height": 844})
    button = viewer.get_by_role("button", name="look", exact=True)
    button.wait_for()
    below = button.evaluate(OPEN_AND_LOOK)
    assert below == pytest.approx(8, abs=1)


@pytest.mark.parametrize(("width", "height"), [(390, 844), (320, 640)])
def test_a_phone_has_its_controls_beside_the_character(
    server: Server, opened: Callable[[str], Page], width: int, height: int
) -> None:
    """Those over the picture end where the character begins; the turntable is in the box of the camera."""
    page = opened(f"{server.url}?machine=walker-layers")
    page.set_viewport_size({"width": width, "height": height})
    until(page, "innerWidth === arg && document.querySelector('#modes').offsetWidth < innerWidth / 3", width)
    page.keyboard.press("f")
    box = page.evaluate("__viewer.pixels()")["box"]
    right = box[2] * width
    until(page, "arg < document.querySelector('#modes').getBoundingClientRect().left", right)
    until(page, "arg > document.querySelector('.feet').getBoundingClientRect().right", box[0] * width)
    controls(page, "camera").get_by_role("button", name="turntable").wait_for()


@pytest.mark.parametrize("window", [{"viewport": {"width": 320, "height": 640}, "has_touch": True}])
def test_a_cell_has_room_for_a_finger_on_the_smallest_phone(viewer: Page) -> None:
    viewer.get_by_role("tab", name="table").click()
    viewer.locator("#table td").first.wait_for()
    heights = "[...document.querySelectorAll('#table td')].map(cell => cell.getBoundingClientRect().height)"
    assert viewer.evaluate(f"Math.min(...{heights})") >= 44


IN_SIGHT = """(() => {
  const [left, , right] = window.__viewer.pixels().box, drawer = document.querySelector('#drawer');
  const picture = document.querySelector('#stage-view').getBoundingClientRect();
  return left > 0 && picture.left + right * picture.width < drawer.getBoundingClientRect().left;
})()"""


@pytest.mark.parametrize(("width", "height"), [(1440, 900), (1280, 800)])
def test_the_drawer_leaves_the_character_in_sight(viewer: Page, width: int, height: int) -> None:
    viewer.set_viewport_size({"width": width, "height": height})
    viewer.get_by_role("button", name="stage main").click()
    until(viewer, IN_SIGHT)


BESIDE = """(() => {
  const edge = document.querySelector('#drawer').getBoundingClientRect().left;
  const parts = [...document.querySelectorAll('#modes button, #notices')].filter((part) => part.offsetParent);
  return parts.length > 2 && parts.every((part) => part.getBoundingClientRect().right <= edge);
})()"""


@pytest.mark.parametrize("tab", ["stages", "YAML"])
def test_the_drawer_covers_neither_controls_nor_what_is_said(viewer: Page, tab: str) -> None:
    """The controls that have no room beside it are in the boxes of *look* and *camera*."""
    viewer.set_viewport_size({"width": 1440, "height": 900})
    viewer.get_by_role("button", name="stage main").click()
    viewer.get_by_role("tab", name=tab).click()
    until(viewer, BESIDE)


INSIDE = """[...document.querySelectorAll(arg)].some((part) => {
  const { left, right, width } = part.getBoundingClientRect();
  return width > 0 && left >= 0 && right <= innerWidth;
})"""


def test_a_small_phone_has_menus_tabs_and_dialogs_in_sight(viewer: Page) -> None:
    viewer.set_viewport_size({"width": 320, "height": 640})
    viewer.get_by_role("button", name="machine menu").click()
    until(viewer, INSIDE, ".machine-menu")
    viewer.keyboard.press("Escape")
    viewer.keyboard.press("o")
    viewer.get_by_role("tab", name="people").click()
    for part in ('#drawer [aria-selected="true"]', '#drawer [aria-label="close"]'):
        until(viewer, INSIDE, part)
    viewer.get_by_role("button", name="close").click()
    viewer.get_by_role("button", name="more").click()
    viewer.get_by_role("menuitem", name="IK rules").click()
    until(viewer, INSIDE, ".deduce textarea")
