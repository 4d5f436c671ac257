"""Every panel and dialog in turn: axe finds nothing wrong, in both themes, and every control can be hit.

A new panel is a line of `PANELS`.
"""

import base64
from collections.abc import Callable, Iterator

import httpx
import pytest
from browser.axe import LARGE, begin, faults
from browser.conftest import Server, controls, leave
from browser.test_import import DROP
from browser.test_timeline import shift_drag
from paths import ROOT
from playwright.sync_api import Page

NAME = "every-panel"
CELL = "td[data-state=WALK][data-column=RIGHT]"


def drop_a_model(page: Page) -> None:
    model = (ROOT / "machines" / "principles" / "principles.glb").read_bytes()
    page.evaluate(DROP, ["mine.glb", base64.b64encode(model).decode()])


def look_at_a_model(page: Page) -> None:
    drop_a_model(page)
    page.locator(".look-controls").wait_for()
    page.evaluate("document.querySelectorAll('.look-contents details').forEach(one => (one.open = true))")


def change_a_key(page: Page) -> None:
    page.keyboard.press("?")
    page.get_by_label("key of “frame the character, or the chosen joint”").click()
    page.keyboard.press("F8")


def open_pad(page: Page) -> None:
    page.click("#table th[data-state=TLFT]")
    page.get_by_role("menuitem", name="clip, loop, markers").click()


def open_yaml(page: Page) -> None:
    page.get_by_role("button", name="versions").click()
    page.get_by_role("tab", name="YAML").click()


def open_machine_form(page: Page) -> None:
    page.get_by_role("button", name="inspect").click()
    page.get_by_role("tab", name="machine").click()


def open_people(page: Page) -> None:
    page.keyboard.press("o")
    page.get_by_role("tab", name="people").click()


def plot_a_joint(page: Page) -> None:
    page.keyboard.press("3")
    page.mouse.click(*page.evaluate("__viewer.circle('Head')"))
    page.locator("#joint").get_by_role("button", name="plot").click()


def ask_why(page: Page) -> None:
    page.click("[data-event=JUMP]")
    page.click("#verdict[data-tick]")


def compare_spans(page: Page) -> None:
    page.get_by_role("button", name="compare").click()
    page.get_by_role("button", name="keep this span").click()
    page.keyboard.press("Escape")
    shift_drag(page, 0, 0.9)
    page.get_by_role("button", name="compare").click()


def travel_while_paused(page: Page) -> None:
    """The route stays as long as the stage is paused."""
    page.keyboard.press("p")
    page.wait_for_selector("[data-link=paused]")
    page.locator("#graph .state[data-state=FLY]").dblclick()


PANELS: dict[str, tuple[Callable[[Page], object], str]] = {
    "the page alone": (Page.bring_to_front, "#table td"),
    "help": (lambda page: page.keyboard.press("?"), "dialog.help"),
    "key settings": (change_a_key, "dialog.help .reset:not([hidden])"),
    "palette": (lambda page: page.keyboard.press("Control+k"), "#choices li"),
    "download": (lambda page: page.click("#download"), "dialog.download a"),
    "IK rules": (lambda page: page.click("#deduce"), "dialog.deduce"),
    "machine menu": (lambda page: page.click("#machine-menu button"), "[role=menuitem]"),
    "import, with the look": (look_at_a_model, ".look-contents details[open] li"),
    "cell editor": (lambda page: page.click(CELL), "#cell-inspector .findings li"),
    "menu of a column": (lambda page: page.click("#table th[data-column=RIGHT]"), ".head-menu"),
    "inspector": (lambda page: page.press(CELL, "Alt+Enter"), "#cell h2"),
    "pad": (open_pad, ".blend-pad"),
    "versions": (lambda page: page.get_by_role("button", name="versions").click(), "#versions li"),
    "YAML": (open_yaml, ".yaml-editor .cm-line"),
    "machine": (open_machine_form, "#machine-form h2"),
    "stages": (lambda page: page.keyboard.press("o"), "#stages li"),
    "people": (open_people, "#people li"),
    "look": (lambda page: controls(page, "look"), "#look-popover select"),
    "camera": (lambda page: controls(page, "camera"), "#camera-popover select"),
    "picture": (lambda page: page.keyboard.press("v"), "#scene h2"),
    "joint": (plot_a_joint, ".joint-plot .uplot"),
    "why": (ask_why, "#why .event-why"),
    "targets": (lambda page: page.click("#targets button"), "#targets [aria-pressed=true]"),
    "span bar": (lambda page: shift_drag(page, 0.25, 0.5), "#span a"),
    "compare box": (compare_spans, "#compare-popover .joint-table tbody tr"),
    "route bar": (travel_while_paused, "#route li"),
}
"""how a panel is opened, in this order, and what is seen then; Escape closes it"""


@pytest.fixture
def wide(server: Server, page: Page, opened: Callable[[str], Page]) -> Iterator[Page]:
    """The page with a machine that may be edited, in a window where all panels are seen."""
    copy = {"name": NAME, "copy_of": "faq-walker"}
    httpx.post(f"{server.url}/api/machines", json=copy, timeout=60).raise_for_status()
    made = httpx.post(f"{server.url}/api/stages", json={"actors": [{"machine": NAME}]}, timeout=60)
    stage = made.raise_for_status().headers["Location"].rsplit("/", 1)[1]
    page.set_viewport_size(LARGE)
    opened(f"{server.url}/?stage={stage}")
    begin(page)
    yield page
    leave(page, f"{server.url}/api/stages/{stage}", f"{server.url}/api/machines/{NAME}")


def test_every_panel_can_be_read_and_hit(wide: Page) -> None:
    wrong = {}
    for name, (open_panel, seen) in PANELS.items():
        open_panel(wide)
        wide.locator(seen).first.wait_for()
        wrong[name] = faults(wide)
        wide.keyboard.press("Escape")
        wide.evaluate("document.activeElement.blur()")
    assert {name: found for name, found in wrong.items() if found} == {}
