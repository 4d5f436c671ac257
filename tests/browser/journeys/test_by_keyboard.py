"""The journeys of docs/journeys.md by the keyboard alone: Tab, arrows, Enter and the page's keys."""

from pathlib import Path

import pytest
from browser.conftest import until
from browser.journeys.conftest import Journey
from browser.journeys.test_journeys import DOOR
from paths import GLTF, needs_assets
from playwright.sync_api import Locator, Page

MOST_TABS = 60
"""there are about fifty stops on the page, from the list of machines to the timeline"""
FOCUSED = "element => element === document.activeElement || element.contains(document.activeElement)"


class Keyboard:
    """The page, and a user without a pointer."""

    def __init__(self, page: Page) -> None:
        self.page = page

    def press(self, *keys: str) -> None:
        for key in keys:
            self.page.keyboard.press(key)

    def type(self, text: str) -> None:
        self.page.keyboard.type(text)

    def until(self, condition: str, arg: object = None) -> None:
        until(self.page, condition, arg)

    def reach(self, place: Locator, key: str = "Tab") -> None:
        """Presses Tab, or an arrow, until the place has the focus."""
        place.wait_for()
        for _ in range(MOST_TABS):
            if place.evaluate(FOCUSED):
                return
            self.press(key)
        pytest.fail(f"{place} cannot be reached with {key}")

    def button(self, name: str) -> None:
        """Reaches a button, and presses it."""
        self.reach(self.page.get_by_role("button", name=name).first)
        self.press("Enter")

    def find(self, words: str) -> None:
        """Finds a command, a state, a machine … by its words, and takes it."""
        self.press("Control+k")
        self.page.get_by_role("combobox", name="find a command").wait_for()
        self.type(words)
        self.page.locator("#choices [role=option]").first.wait_for()
        self.press("Enter")

    def add_model(self, path: Path, initial: str) -> None:
        """Opens a file, and takes what the dialog proposes."""
        with self.page.expect_file_chooser() as chosen:
            self.button("add your own character")
        chosen.value.set_files(path)
        self.page.get_by_role("button", name="Make a machine").wait_for()
        self.press("Enter")
        self.until("__viewer.stage() !== 'main' && __viewer.ready && __viewer.state() === arg", initial)

    def to_cell(self, state: str, event: str) -> None:
        """Goes to a cell of the table with the arrows, from wherever the focus is."""
        table = self.page.locator("#table")
        self.reach(table)
        step = """([state, event]) => {
          const cell = document.activeElement.closest('td, th'), wanted =
            document.querySelector(`td[data-state="${state}"][data-column="${event}"]`);
          const at = c => [c.parentElement.rowIndex, c.cellIndex];
          const [[row, column], [toRow, toColumn]] = [at(cell), at(wanted)];
          return row < toRow ? 'ArrowDown' : row > toRow ? 'ArrowUp'
            : column < toColumn ? 'ArrowRight' : column > toColumn ? 'ArrowLeft' : '';
        }"""
        for _ in range(MOST_TABS):
            key = self.page.evaluate(step, [state, event])
            if not key:
                return
            self.press(key)
        pytest.fail(f"{state}/{event} cannot be reached with the arrows")

    def edit_cell(self, state: str, event: str, text: str) -> None:
        """Goes to a cell, types, and presses Enter; returns when the edit is a version."""
        before = self.page.evaluate("__viewer.version()")
        self.to_cell(state, event)
        if text:
            self.type(text)
        else:
            self.press("Delete")
        self.press("Enter")
        self.until("__viewer.version() === arg", before + 1)


@pytest.fixture
def keyboard(journey: Journey) -> Keyboard:
    return Keyboard(journey.page)


def test_make_a_door_that_opens(keyboard: Keyboard) -> None:
    keyboard.add_model(DOOR, "SHUT")
    keyboard.edit_cell("OPEN", "END", "OPENED")
    keyboard.edit_cell("OPENED", "END", "")
    keyboard.press("Escape")
    keyboard.press("q")
    keyboard.until("__viewer.state() === 'OPENED'")
    keyboard.press("e")
    keyboard.until("__viewer.state() === 'SHUT'")


@needs_assets
def test_bring_your_own_model_and_make_it_jump(keyboard: Keyboard) -> None:
    keyboard.add_model(GLTF / "RobotExpressive.glb", "STAT")
    keyboard.press("Space")
    keyboard.until("__viewer.state() === 'JUMP'")


def test_fix_the_printed_table(keyboard: Keyboard) -> None:
    page = keyboard.page
    keyboard.find("The table as printed")
    page.get_by_label("findings: 2 errors, 5 warnings").wait_for()
    keyboard.edit_cell("STAT", "LEFT", "TLFT")
    keyboard.edit_cell("WALK", "LEFT", "TLFT")
    keyboard.edit_cell("TRGT", "RIGHT", "TRGT")
    page.get_by_label("findings: 5 warnings").wait_for()
    keyboard.reach(page.locator("#table th[data-column=RIGHT]"), "ArrowUp")
    keyboard.reach(page.locator("#table th").first, "ArrowLeft")
    keyboard.press("Enter")
    keyboard.reach(page.get_by_role("menuitem", name="event"), "ArrowDown")
    keyboard.press("Enter")
    keyboard.type("JUMP")
    keyboard.press("Enter")
    page.locator("th[data-column=JUMP]").wait_for()
    keyboard.edit_cell("WALK", "JUMP", "JUMP")
    page.get_by_label("findings: nothing is wrong").wait_for()


@needs_assets
def test_a_walk_and_a_run_blend_on_a_pad(keyboard: Keyboard) -> None:
    page = keyboard.page
    keyboard.add_model(GLTF / "RobotExpressive.glb", "STAT")
    keyboard.to_cell("WALK", "STOP")
    keyboard.reach(page.locator("th[data-state=WALK]"), "ArrowLeft")
    keyboard.press("Enter")
    keyboard.reach(page.get_by_role("menuitem", name="clip, loop, markers"), "ArrowDown")
    keyboard.press("Enter")
    keyboard.reach(page.get_by_label("blend with"))
    keyboard.type("Running")
    keyboard.button("see it: go to WALK")
    keyboard.until("__viewer.state() === 'WALK'")
    keyboard.reach(page.locator("#parameters input[type=range]").first)
    keyboard.press("PageUp")
    keyboard.until("Number(document.querySelector('#parameters output').textContent) > 0")


def look_back(keyboard: Keyboard, key: str) -> None:
    """Goes back in time with the slider of the timeline."""
    keyboard.reach(keyboard.page.get_by_label("history: tick that is shown"))
    keyboard.press(key)
    keyboard.until("__viewer.looking() !== null && __viewer.posed() === __viewer.looking()")


def test_compare_two_ideas(keyboard: Keyboard) -> None:
    page = keyboard.page
    keyboard.press("c")
    keyboard.until("__viewer.state() === 'CRCH'")
    look_back(keyboard, "Home")
    keyboard.press("Escape", "ArrowUp")
    keyboard.until("__viewer.stage() !== 'main' && __viewer.ready")
    keyboard.button("stage faq-walker")
    keyboard.button("ghost of main")
    keyboard.button("the first that differs")
    keyboard.until("__viewer.posed() === __viewer.looking() && __viewer.ghost() === __viewer.looking()")
    page.get_by_role("columnheader", name="degrees").wait_for()


def test_send_a_colleague_the_moment_that_goes_wrong(keyboard: Keyboard) -> None:
    page = keyboard.page
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    keyboard.press("Space")
    page.get_by_text("JUMP: dropped").wait_for()
    look_back(keyboard, "ArrowLeft")
    keyboard.press("y")
    page.get_by_text("Copied: a link").wait_for()
    assert f"tick={page.evaluate('__viewer.tick()')}" in page.evaluate("navigator.clipboard.readText()")


def test_find_out_why_it_did_not_jump(keyboard: Keyboard) -> None:
    page = keyboard.page
    keyboard.press("Space")
    page.get_by_text("JUMP: dropped").wait_for()
    keyboard.reach(page.locator("#verdict[data-tick]"))
    keyboard.press("Enter")
    page.locator(".event-why[data-about=JUMP] .where", has_text="STAT/JUMP").wait_for()
    keyboard.reach(page.locator(".remedies [data-kind=state] button").first)
    keyboard.press("Enter")
    keyboard.until("__viewer.state() === 'WALK'")
    keyboard.press("Escape", "Space")
    keyboard.until("__viewer.state() === 'JUMP'")


def test_teach_interpolation(keyboard: Keyboard) -> None:
    page = keyboard.page
    keyboard.reach(page.get_by_role("link", name="curves"))
    keyboard.press("Enter")
    page.get_by_role("button", name="far apart").wait_for()
    keyboard.until("document.body.dataset.curves === '7'")
    keyboard.button("far apart")
    keyboard.reach(page.get_by_label("x° of key 2"))
    keyboard.press("Control+a")
    with page.expect_response(lambda answer: "170" in (answer.request.post_data or "")):
        keyboard.type("170")
    keyboard.button("linear, Euler XYZ")
    keyboard.until("document.querySelectorAll('#names button[aria-pressed=true]').length === 6")
