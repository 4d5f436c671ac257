"""Every panel and dialog in turn: axe finds nothing wrong, in both themes, and every control can be hit.

A new panel is a line of `PANELS`.
"""

import base64
from collections.abc import Callable, Iterator
from typing import Any, Literal

import httpx
import pytest
from browser.axe import LARGE, begin, faults, small_for_a_finger, unreadable
from browser.conftest import Server, controls, leave, until
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
    page.get_by_role("menuitem", name="clip, blend, markers").click()


def open_yaml(page: Page) -> None:
    page.get_by_role("button", name="versions").click()
    page.get_by_role("tab", name="YAML").click()


def open_machine_form(page: Page) -> None:
    page.get_by_role("button", name="inspect").click()
    page.get_by_role("tab", name="machine").click()


def unfold(page: Page, panel: str) -> None:
    """Opens each folded part of a panel."""
    page.locator(f"{panel} details").first.wait_for()
    page.evaluate(
        "panel => document.querySelectorAll(`${panel} details`).forEach(one => (one.open = true))", panel
    )


def unfold_the_machine(page: Page) -> None:
    open_machine_form(page)
    unfold(page, "#machine-form")


def unfold_a_state(page: Page) -> None:
    open_pad(page)
    unfold(page, "#cell")


def open_a_difference(page: Page) -> None:
    """The machine gets a second version first, if it has none."""
    if page.evaluate("__viewer.version()") == 1:
        page.click(CELL)
        page.keyboard.type("STAT")
        page.keyboard.press("Enter")
        until(page, "__viewer.version() > 1")
    page.get_by_role("button", name="versions").click()
    page.locator("#versions li button").first.click()


def break_the_yaml(page: Page) -> None:
    open_yaml(page)
    page.locator(".yaml-editor .cm-line").first.click()
    page.keyboard.press("Control+Home")
    page.keyboard.type("keys: [\n")


def ask_for_a_name(page: Page) -> None:
    page.click("#table th[data-state=WALK]")
    page.get_by_role("menuitem", name="rename").click()


def begin_a_machine(page: Page) -> None:
    page.click("#machine-menu button")
    page.get_by_role("menuitem", name="from nothing").click()


def delete_a_machine(page: Page) -> None:
    page.click("#machine-menu button")
    page.get_by_role("menuitem", name="delete").click()


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
    "a state's new name": (ask_for_a_name, ".head-menu input"),
    "a new machine": (begin_a_machine, "#machine-menu select"),
    "a deletion": (delete_a_machine, "#machine-menu .primary"),
    "menu of a column": (lambda page: page.click("#table th[data-column=RIGHT]"), ".head-menu"),
    "inspector": (lambda page: page.press(CELL, "Alt+Enter"), "#cell h2"),
    "pad": (open_pad, ".blend-pad"),
    "all of a state": (unfold_a_state, "#cell details[open]"),
    "versions": (lambda page: page.get_by_role("button", name="versions").click(), "#versions li"),
    "a version's differences": (open_a_difference, "#versions [aria-expanded=true]"),
    "YAML": (open_yaml, ".yaml-editor .cm-line"),
    "YAML with a fault": (break_the_yaml, ".cm-lint-marker-error"),
    "machine": (open_machine_form, "#machine-form h2"),
    "all of the machine": (unfold_the_machine, "#machine-form details[open]"),
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
def window() -> dict[str, Any]:
    """A window in which all panels are seen."""
    return {"viewport": LARGE}


@pytest.fixture
def editable(server: Server, page: Page, opened: Callable[[str], Page], allowed: list[str]) -> Iterator[Page]:
    """The page with a machine that may be edited."""
    allowed.append("status of 422")  # the console says what was refused
    copy = {"name": NAME, "copy_of": "faq-walker"}
    httpx.post(f"{server.url}/api/machines", json=copy, timeout=60).raise_for_status()
    made = httpx.post(f"{server.url}/api/stages", json={"actors": [{"machine": NAME}]}, timeout=60)
    stage = made.raise_for_status().headers["Location"].rsplit("/", 1)[1]
    opened(f"{server.url}/?stage={stage}")
    begin(page)
    yield page
    leave(page, f"{server.url}/api/stages/{stage}", f"{server.url}/api/machines/{NAME}")


def test_every_panel_can_be_read_and_hit(editable: Page) -> None:
    wrong = {}
    for name, (open_panel, seen) in PANELS.items():
        open_panel(editable)
        editable.locator(seen).first.wait_for()
        wrong[name] = faults(editable)
        editable.keyboard.press("Escape")
        editable.evaluate("document.activeElement.blur()")
    assert {name: found for name, found in wrong.items() if found} == {}


ROLES: tuple[Literal["button", "tab", "menuitem"], ...] = ("button", "tab", "menuitem")


def tapped(*names: str) -> Callable[[Page], object]:
    """Returns an opener that taps the controls of these names, one after the other."""

    def tap(page: Page) -> None:
        for name in names:
            found = [page.get_by_role(role, name=name, exact=True) for role in ROLES]
            found[0].or_(found[1]).or_(found[2]).locator("visible=true").first.tap()

    return tap


def tap_a_state(page: Page) -> None:
    page.locator("#table th[data-state=WALK]").tap()
    page.get_by_role("menuitem", name="clip, blend, markers").tap()


PHONE: dict[str, tuple[Callable[[Page], object], str]] = {
    "the graph": (tapped("graph"), "#graph .state"),
    "the table": (tapped("table"), "#table td"),
    "menu of a state": (lambda page: page.locator("#table th[data-state=WALK]").tap(), ".head-menu"),
    "cell editor": (lambda page: page.locator(CELL).tap(), "#cell-inspector .findings li"),
    "inspector": (tap_a_state, "#cell h2"),
    "machine": (tapped("inspect", "machine"), "#machine-form h2"),
    "versions": (tapped("versions"), "#versions"),
    "YAML": (tapped("versions", "YAML"), ".yaml-editor .cm-line"),
    "stages": (tapped("versions", "stages"), "#stages li"),
    "people": (tapped("versions", "people"), "#people li"),
    "machine menu": (tapped("machine menu"), "[role=menuitem]"),
    "the bar's menu": (tapped("more"), "#bar-menu [role=menuitem]"),
    "help": (tapped("more", "help: keys"), "dialog.help"),
    "palette": (tapped("more", "find anything"), "#choices li"),
    "download": (tapped("more", "download…"), "dialog.download a"),
    "IK rules": (tapped("more", "IK rules"), "dialog.deduce"),
    "look": (tapped("look"), "#look-popover select"),
    "camera": (tapped("camera"), "#camera-popover select"),
    "import, with the look": (look_at_a_model, ".look-contents details[open] li"),
}


class TestOnAPhone:
    @pytest.fixture
    def window(self) -> dict[str, Any]:
        return {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}

    def test_every_panel_can_be_read_and_touched(self, editable: Page) -> None:
        wrong = {}
        for name, (open_panel, seen) in PHONE.items():
            open_panel(editable)
            editable.locator(seen).locator("visible=true").first.wait_for()
            wrong[name] = unreadable(editable) + small_for_a_finger(editable)
            editable.keyboard.press("Escape")
            editable.evaluate("document.activeElement.blur()")
        assert {name: found for name, found in wrong.items() if found} == {}
