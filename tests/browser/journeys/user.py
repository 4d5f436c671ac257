"""What a user can do with the page; mouse.py, keyboard.py and fingers.py say how three users do it."""

import re
from abc import ABC, abstractmethod
from pathlib import Path
from typing import Any, ClassVar, Literal

from browser.conftest import until
from paths import ROOT
from playwright.sync_api import Locator, Page, Position

DOCUMENT = ROOT / "docs" / "journeys.md"
Moment = Literal["start", "middle"]
HIDDEN_IN = """place => {
  const panel = place.closest('[data-tab]');
  return panel && !panel.checkVisibility() ? panel.dataset.tab : '';
}"""
"""the tab of the panel that holds a place, if a small window shows another panel"""
SHARES: dict[Moment, float] = {"start": 0.02, "middle": 0.5}
"""where on the timeline a moment is, as a share of its width"""


class User(ABC):
    """A user with a large window, who counts keys and words; subclasses say what their users do otherwise."""

    WINDOW: ClassVar[dict[str, Any]] = {"viewport": {"width": 1440, "height": 900}}

    def __init__(self, page: Page) -> None:
        self.page = page
        self.steps = 0

    @abstractmethod
    def take(self, place: Locator) -> None:
        """Clicks or taps a place, or presses Enter there."""

    @abstractmethod
    def send(self, event: str) -> None:
        """Sends the character an event."""

    @abstractmethod
    def _scrub(self, moment: Moment) -> None:
        """Moves the timeline to a moment."""

    def arrived(self, journey: str) -> None:
        """Ends a journey; the document has it, with a number of steps."""
        self._promised(journey)

    def bring(self, place: Locator) -> None:
        """Shows the panel that holds a place."""
        if tab := place.evaluate(HIDDEN_IN):
            self.take(self.page.get_by_role("tab", name=tab, exact=True))

    def until(self, condition: str, arg: object = None) -> None:
        until(self.page, condition, arg)

    def press(self, key: str) -> None:
        self.steps += 1
        self.page.keyboard.press(key)

    def type(self, text: str) -> None:
        self.steps += 1
        self.page.keyboard.type(text)

    def focus(self, place: Locator) -> None:
        """Makes a place the one that keys go to."""
        self.take(place)

    def press_button(self, name: str) -> None:
        self.take(self.page.get_by_role("button", name=name))

    def take_from_menu(self, place: Locator, item: str) -> None:
        """Opens the menu of a place, and takes an item."""
        self.take(place)
        self.take(self.page.get_by_role("menuitem", name=item))

    def go_to_curves(self) -> None:
        self.take(self.page.get_by_role("link", name="curves"))

    def fill(self, place: Locator, text: str) -> None:
        """Types over what a field says."""
        self.focus(place)
        self.page.keyboard.press("Control+a")
        self.type(text)

    def choose(self, place: Locator, option: str) -> None:
        """Opens a list, and takes an option: two steps."""
        self.steps += 2
        place.select_option(option)

    def choose_machine(self, title: str) -> None:
        self.choose(self.page.locator("#picker select[title=machine]"), title)

    def open_stages(self) -> None:
        self.press_button("stage faq-walker")

    def find(self, words: str) -> None:
        """Finds a command, a state, a machine … by its words, and takes it."""
        self._open_search()
        self.page.get_by_role("combobox", name="find a command").wait_for()
        self.type(words)
        self.page.locator("#choices [role=option]").first.wait_for()
        self.press("Enter")

    def copy_link(self) -> None:
        """Copies a link to the moment that is shown."""
        self.press("y")

    def add_model(self, path: Path, initial: str) -> None:
        """Opens a file, and takes what the dialog proposes; returns when its machine is in this state."""
        self._open_file(path)
        self.page.get_by_role("button", name="Make a machine").wait_for()
        self._confirm()
        self.until("__viewer.stage() !== 'main' && __viewer.ready && __viewer.state() === arg", initial)

    def edit_cell(self, state: str, event: str, text: str) -> None:
        """Goes to a cell and writes, or empties it; returns when the edit is a version."""
        before = self.page.evaluate("__viewer.version()")
        self.focus(self.page.locator(f"td[data-state={state}][data-column={event}]"))
        self._write(text)
        self.until("__viewer.version() === arg", before + 1)

    def look_back(self, moment: Moment) -> None:
        """Goes back in time; returns when the character is drawn as it was."""
        self._scrub(moment)
        self.until("__viewer.looking() !== null && __viewer.posed() === __viewer.looking()")

    def blend_half_way(self) -> None:
        self.take(self.page.locator(".blend-pad .ground"))

    def _open_search(self) -> None:
        self.press_button("find anything")

    def _open_file(self, path: Path) -> None:
        with self.page.expect_file_chooser() as chosen:
            self.take(self.page.get_by_role("button", name="add your own character").first)
        chosen.value.set_files(path)

    def _confirm(self) -> None:
        self.press("Enter")

    def _write(self, text: str) -> None:
        if text:
            self.type(text)
        else:
            self.press("Delete")
        self.press("Enter")

    def _timeline(self, moment: Moment) -> tuple[Locator, Position]:
        """The timeline, and where on it a moment is."""
        bar = self.page.locator(".scrub")
        box = bar.bounding_box()
        assert box is not None
        return bar, {"x": SHARES[moment] * box["width"], "y": box["height"] / 2}

    def _promised(self, journey: str) -> int:
        """How many steps the document says a journey takes."""
        told = re.search(rf"^## {journey}: (\d+) steps$", DOCUMENT.read_text(), re.MULTILINE)
        assert told is not None, f"docs/journeys.md has no journey '{journey}: N steps'"
        return int(told[1])
